// Optical activity and optic axes.
//
// Along a direction s in which light is not split, D = eps E + i g s x E has two circular waves of
// index n +- g/(2n), so that the plane of polarization turns by rho = pi g/(n lambda) per length
// (Nye 1957, Physical Properties of Crystals, XIV.2, eq. 8; there G). g goes like 1/lambda far from absorption
// (Boltzmann's one-term law, rho ~ 1/lambda^2).
// Optic axes (Born & Wolf, Principles of Optics, 15.3.3): for n_alpha < n_beta < n_gamma,
//   cos V = (n_alpha/n_beta) sqrt((n_gamma^2 - n_beta^2)/(n_gamma^2 - n_alpha^2)) from the axis of gamma.
// Test: tests/optics/crystal_test.cpp.
#include "host/optics/crystal.hpp"

#include <algorithm>
#include <cmath>

#include "host/optics/interpolate.hpp"

namespace nicol {

namespace {
constexpr double mm_per_nm = 1e-6, half_turn_deg = 180, pi = 3.14159265358979323846;
}  // namespace

GyrationTensor gyration(const GyrationFormula& formula, double lambda_nm) {
  using Kind = GyrationFormula::Kind;
  GyrationTensor g{};
  for (std::size_t i = 0; i < g.size(); ++i) {
    if (formula.kind == Kind::constant) g[i] = formula.tensor[i];
    if (formula.kind == Kind::scaled) g[i] = formula.tensor[i] * formula.at_nm / lambda_nm;
    if (formula.kind == Kind::table) g[i] = monotone_cubic(formula.points[i], lambda_nm);
    g[i] *= formula.scale;
  }
  return g;
}

std::string check(const GyrationFormula& formula) {
  using Kind = GyrationFormula::Kind;
  if (formula.kind == Kind::scaled && !(formula.at_nm > 0))
    return "the wavelength of a gyration must be greater than 0";
  if (formula.kind == Kind::table) return check_points(formula.points[0], -HUGE_VAL);
  return "";
}

double gyration_along(const GyrationTensor& g, const std::array<double, 3>& s) {
  return g[0] * s[0] * s[0] + g[1] * s[1] * s[1] + g[2] * s[2] * s[2] +
         2 * (g[3] * s[1] * s[2] + g[4] * s[0] * s[2] + g[5] * s[0] * s[1]);
}

double rotation_of_gyration(double g, double n, double lambda_nm) {
  return half_turn_deg * g / (n * lambda_nm * mm_per_nm);
}

double gyration_of_rotation(double rotation_deg_per_mm, double n, double lambda_nm) {
  return rotation_deg_per_mm * n * lambda_nm * mm_per_nm / half_turn_deg;
}

double optic_axis_from_gamma_deg(double n_alpha, double n_beta, double n_gamma) {
  std::array<double, 3> n{n_alpha, n_beta, n_gamma};
  std::sort(n.begin(), n.end());
  // tan V = (n_gamma/n_alpha) sqrt((n_beta^2 - n_alpha^2)/(n_gamma^2 - n_beta^2)): no loss near 0 or 90.
  const double from_gamma = (n[1] - n[0]) * (n[1] + n[0]), from_alpha = (n[2] - n[1]) * (n[2] + n[1]);
  return std::atan2(n[2] * std::sqrt(from_gamma), n[0] * std::sqrt(from_alpha)) * half_turn_deg / pi;
}

}  // namespace nicol
