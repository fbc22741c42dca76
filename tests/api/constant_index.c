/* A plugin for the tests of libnicol: an index that does not depend on the wavelength. */
#include <nicol_plugin.h>
#include <string.h>

static int constant_index(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* n, double* k) {
  (void)user;
  (void)host;
  (void)lambda_nm;
  (void)k;
  *n = values->numbers[0];
  return NICOL_PLUGIN_OK;
}

int nicol_plugin_v1(const nicol_host_v1* host) {
  nicol_parameter_v1 parameter;
  nicol_dispersion_v1 formula;
  memset(&parameter, 0, sizeof parameter);
  memset(&formula, 0, sizeof formula);
  parameter.struct_size = sizeof parameter;
  parameter.name = "n";
  formula.struct_size = sizeof formula;
  formula.flags = NICOL_PLUGIN_THREAD_SAFE;
  formula.name = "constant_index";
  formula.meaning = "n as it is given";
  formula.parameters = &parameter;
  formula.parameter_count = 1;
  formula.index = constant_index;
  return host->add_dispersion(host, &formula);
}
