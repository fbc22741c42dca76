// Refractive indices of congruent lithium niobate as functions of wavelength and temperature.
//   n^2 = A1 + (A2 + B1 F) / (l^2 - (A3 + B2 F)^2) + B3 F - A4 l^2,  F = (T - 24.5)(T + 570.82), l in um, T in deg C
// Source: G. J. Edwards and M. Lawrence, A temperature-dependent dispersion equation for congruently grown lithium niobate,
// Opt. Quantum Electron. 16, 373 (1984). The crystal is clear between about 0.4 and 5 um; the formula is used here from room
// temperature to some hundred K above. Test: tests/plugins/plugins_test.py, against n_o of
// Zelmon et al. 1997 (1.3e-4 apart at 24.5 deg C, 450 to 1500 nm) and n_e of Jundt 1997 (2.3e-4 apart, also at 124.5 deg C).
#include <nicol_plugin.h>

#include <cmath>

namespace {

struct Coefficients {
  double a1, a2, a3, a4, b1, b2, b3;
};
const Coefficients ordinary{4.9048, 0.11775, 0.21802, 0.027153, 2.2314e-8, -2.9671e-8, 2.1429e-8};
const Coefficients extraordinary{4.5820, 0.09921, 0.21090, 0.021940, 5.2716e-8, -4.9143e-8, 2.2971e-7};

double index_squared(const Coefficients& c, double lambda_um, double temperature_c) {
  const double f = (temperature_c - 24.5) * (temperature_c + 570.82), l2 = lambda_um * lambda_um;
  const double pole = c.a3 + c.b2 * f;
  return c.a1 + (c.a2 + c.b1 * f) / (l2 - pole * pole) + c.b3 * f - c.a4 * l2;
}

int refractive_index(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* n, double*) {
  if (lambda_nm < 350 || lambda_nm > 5500) {
    host->set_message(host, "lithium niobate is clear from 350 to 5500 nm only");
    return NICOL_PLUGIN_ERROR;
  }
  constexpr double zero_celsius_k = 273.15;
  *n = std::sqrt(index_squared(*static_cast<const Coefficients*>(user), lambda_nm / 1000, values->numbers[0] - zero_celsius_k));
  return NICOL_PLUGIN_OK;
}

int add(const nicol_host_v1* host, const char* name, const char* meaning, const Coefficients& coefficients) {
  nicol_parameter_v1 temperature{};
  temperature.struct_size = sizeof temperature;
  temperature.name = "temperature";
  temperature.unit = "K";
  temperature.meaning = "of the crystal";
  temperature.has_default = 1;
  temperature.default_number = 297.65;  // 24.5 deg C, where F = 0
  temperature.has_bounds = 1;
  temperature.least = 250;
  temperature.most = 800;
  nicol_dispersion_v1 formula{};
  formula.struct_size = sizeof formula;
  formula.flags = NICOL_PLUGIN_THREAD_SAFE;
  formula.name = name;
  formula.meaning = meaning;
  formula.parameters = &temperature;
  formula.parameter_count = 1;
  formula.user = const_cast<Coefficients*>(&coefficients);
  formula.index = refractive_index;
  return host->add_dispersion(host, &formula);
}

}  // namespace

int nicol_plugin_v1(const nicol_host_v1* host) {
  const int status = add(host, "lithium_niobate_ordinary", "n_o of congruent LiNbO3 (Edwards & Lawrence 1984)", ordinary);
  if (status != NICOL_PLUGIN_OK) return status;
  return add(host, "lithium_niobate_extraordinary", "n_e of congruent LiNbO3 (Edwards & Lawrence 1984)", extraordinary);
}
