/* A plugin from outside: a spectrum that is the same at all wavelengths. */
#include <nicol_plugin.h>

static int radiance(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* value) {
  (void)user, (void)host, (void)values, (void)lambda_nm;
  *value = 1;
  return NICOL_PLUGIN_OK;
}

int nicol_plugin_v1(const nicol_host_v1* host) {
  nicol_spectrum_v1 flat = {0};
  flat.struct_size = sizeof flat;
  flat.name = "flat";
  flat.meaning = "the same at all wavelengths";
  flat.radiance = radiance;
  return host->add_spectrum(host, &flat);
}
