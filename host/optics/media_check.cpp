// Whether the coefficients of a medium fit its formula; messages for whoever wrote them.
#include <cmath>

#include "host/optics/interpolate.hpp"
#include "host/optics/media.hpp"

namespace nicol {
namespace {

using Coefficients = std::vector<double>;

std::string all_finite(const Coefficients& c) {
  for (std::size_t i = 0; i < c.size(); ++i)
    if (!std::isfinite(c[i])) return "coefficient " + std::to_string(i + 1) + " is not finite";
  return "";
}

std::string wanted(bool fits, const std::string& formula, const std::string& rule,
                   const Coefficients& c) {
  if (!fits) return formula + " takes " + rule + ", " + std::to_string(c.size()) + " given";
  return all_finite(c);
}

std::string check_numbered(int number, const Coefficients& c) {
  const std::string name = "formula " + std::to_string(number);
  const std::size_t count = c.size();
  switch (number) {
    case 1:
    case 2:
    case 3:
    case 5:
    case 6: return wanted(count % 2 == 1, name, "1 + 2m coefficients", c);
    case 4:
      return wanted(count == 1 || count == 5 || (count >= 9 && count % 2 == 1), name,
                    "1, 5 or 9 + 2m coefficients", c);
    case 7: return wanted(count >= 1 && count <= 6, name, "1 to 6 coefficients", c);
    case 8: return wanted(count == 4, name, "4 coefficients", c);
    case 9: return wanted(count == 6, name, "6 coefficients", c);
    default: return "there is no formula " + std::to_string(number) + ": the formulas are 1 to 9";
  }
}

std::string check_povray(const Coefficients& c) {
  const std::string problem = wanted(c.size() == 2, "ior with dispersion", "2 coefficients", c);
  if (!problem.empty()) return problem;
  if (c[0] <= 0) return "ior must be positive";
  if (c[1] <= 0) return "dispersion must be positive";
  return "";
}

std::string check_mean(const std::vector<IndexFormula>& parts) {
  if (parts.empty()) return "a mean takes 1 or more formulas, 0 given";
  for (const auto& part : parts) {
    const std::string problem = check(part);
    if (!problem.empty()) return problem;
  }
  return "";
}

}  // namespace

std::string check(const IndexFormula& formula) {
  using Kind = IndexFormula::Kind;
  const Coefficients& c = formula.coefficients;
  switch (formula.kind) {
    case Kind::constant: {
      const std::string problem = wanted(c.size() == 1, "a constant index", "1 coefficient", c);
      return problem.empty() && c[0] <= 0 ? "a refractive index must be positive" : problem;
    }
    case Kind::cauchy: return wanted(!c.empty(), "the Cauchy formula", "1 or more coefficients", c);
    case Kind::sellmeier:
      return wanted(!c.empty() && c.size() % 2 == 0, "the Sellmeier formula",
                    "2m coefficients B, C", c);
    case Kind::numbered: return check_numbered(formula.number, c);
    case Kind::table: return check_points(formula.points, 0);
    case Kind::povray: return check_povray(c);
    case Kind::mean: return check_mean(formula.parts);
  }
  return "unknown kind of formula";
}

std::string check(const RotationFormula& formula) {
  using Kind = RotationFormula::Kind;
  const Coefficients& c = formula.coefficients;
  if (!std::isfinite(formula.scale)) return "the scale of the rotation is not finite";
  switch (formula.kind) {
    case Kind::none: return "";
    case Kind::constant: return wanted(c.size() == 1, "a constant rotation", "1 coefficient", c);
    case Kind::biot: return wanted(!c.empty(), "Biot's formula", "1 or more coefficients", c);
    case Kind::drude: return wanted(c.size() >= 2, "Drude's formula", "2 or more coefficients", c);
    case Kind::chandrasekhar:
      return wanted(c.size() == 2, "Chandrasekhar's formula", "2 coefficients k, lambda0", c);
    case Kind::table: return check_points(formula.points, -HUGE_VAL);
  }
  return "unknown kind of formula";
}

std::string check(const AbsorptionFormula& formula) {
  using Kind = AbsorptionFormula::Kind;
  switch (formula.kind) {
    case Kind::none: return "";
    case Kind::constant:
      if (!std::isfinite(formula.per_mm)) return "the absorption is not finite";
      return formula.per_mm < 0 ? "an absorption must not be negative" : "";
    case Kind::table: return check_points(formula.points, 0);
  }
  return "unknown kind of formula";
}

}  // namespace nicol
