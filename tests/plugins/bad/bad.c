/* Plugins with one thing wrong each, chosen by a macro: the host must answer each with a message, never crash. */
#include <nicol_plugin.h>

#include <math.h>
#include <string.h>

#ifdef BAD_NO_SYMBOL
int something_else(void) { return 0; }
#elif defined(BAD_LATER)
NICOL_PLUGIN_ENTRY int nicol_plugin_v2(const void* host);
int nicol_plugin_v2(const void* host) { return host == NULL; }
#else

static int two(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* n, double* k) {
  (void)user, (void)host, (void)values, (void)lambda_nm, (void)k;
  *n = 2;
#ifdef BAD_NAN
  if (lambda_nm > 500) *n = NAN;
#endif
#ifdef BAD_ZERO
  *n = 0;
#endif
#ifdef BAD_STATUS
  host->set_message(host, "the oven is cold");
  return 7;
#endif
#ifdef BAD_PLACE
  host->add_point(host, n);
#endif
#ifdef BAD_LATE
  return host->add_dispersion(host, NULL);
#endif
  return NICOL_PLUGIN_OK;
}

int nicol_plugin_v1(const nicol_host_v1* host) {
  nicol_dispersion_v1 formula;
  memset(&formula, 0, sizeof formula);
  formula.struct_size = sizeof formula;
  formula.name = NAME;
  formula.index = two;
#ifdef BAD_SIZE
  formula.struct_size = 12;
#endif
#ifdef BAD_NAME
  formula.name = "not a name";
#endif
#ifdef BAD_FUNCTION
  formula.index = NULL;
#endif
#ifdef BAD_NOTHING
  return NICOL_PLUGIN_OK;
#endif
  int status = host->add_dispersion(host, &formula);
#ifdef BAD_TWICE
  status = host->add_dispersion(host, &formula);
#endif
#ifdef BAD_SIZE
  status = NICOL_PLUGIN_OK; /* as if it had not looked */
#endif
#ifdef BAD_ENTRY
  host->set_message(host, "no licence");
  return NICOL_PLUGIN_ERROR;
#endif
  return status;
}
#endif
