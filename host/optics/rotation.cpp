// Optical rotation and absorption by formula. Inside this file the formulas' wavelengths are in um.
#include <cmath>
#include <limits>

#include "host/optics/interpolate.hpp"
#include "host/optics/media.hpp"

namespace nicol {
namespace {

using Coefficients = std::vector<double>;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double finite(double value) { return std::isfinite(value) ? value : nan_value; }

// Biot 1812: alpha = A/l^2, with further terms B/l^4, ...
double biot(const Coefficients& c, double l2) {
  double alpha = 0;
  for (std::size_t i = c.size(); i-- > 0;) alpha = (alpha + c[i]) / l2;
  return alpha;
}

// Drude 1900: alpha = sum A_i / (l^2 - l_i^2), here with an optional constant at the end
double drude(const Coefficients& c, double l2) {
  double alpha = c.size() % 2 == 1 ? c.back() : 0;
  for (std::size_t i = 0; i + 1 < c.size(); i += 2) alpha += c[i] / (l2 - c[i + 1]);
  return alpha;
}

// Chandrasekhar 1961: alpha = k l^2 / (l^2 - l_0^2)^2
double chandrasekhar(double k, double lambda0_um, double l2) {
  const double distance = l2 - lambda0_um * lambda0_um;
  return k * l2 / (distance * distance);
}

double unscaled_rotation(const RotationFormula& formula, double lambda_nm) {
  using Kind = RotationFormula::Kind;
  const Coefficients& c = formula.coefficients;
  const double l2 = lambda_nm * lambda_nm * 1e-6;
  switch (formula.kind) {
    case Kind::none: return 0;
    case Kind::constant: return c[0];
    case Kind::biot: return biot(c, l2);
    case Kind::drude: return drude(c, l2);
    case Kind::chandrasekhar: return chandrasekhar(c[0], c[1], l2);
    case Kind::table: return monotone_cubic(formula.points, lambda_nm);
  }
  return nan_value;
}

}  // namespace

double rotation_deg_per_mm(const RotationFormula& formula, double lambda_nm) {
  if (!check(formula).empty() || !(lambda_nm > 0)) return nan_value;
  return finite(formula.scale * unscaled_rotation(formula, lambda_nm));
}

double absorb_per_mm(const AbsorptionFormula& formula, double lambda_nm) {
  using Kind = AbsorptionFormula::Kind;
  if (!check(formula).empty() || !(lambda_nm > 0)) return nan_value;
  if (formula.kind == Kind::none) return 0;
  if (formula.kind == Kind::constant) return formula.per_mm;
  return monotone_cubic(formula.points, lambda_nm);
}

}  // namespace nicol
