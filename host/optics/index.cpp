// Refractive index by formula. Inside this file wavelengths are in um, as the formulas are
// published. Numbered formulas: M. N. Polyanskiy, refractiveindex.info database, "Dispersion
// formulas"; also Sci. Data 11, 94 (2024).
#include <cmath>
#include <limits>

#include "host/optics/interpolate.hpp"
#include "host/optics/media.hpp"

namespace nicol {
namespace {

using Coefficients = std::vector<double>;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double real_positive(double n) { return std::isfinite(n) && n > 0 ? n : nan_value; }

// first + sum of term(C_2i, C_2i+1)
template <class Term>
double sum_of_pairs(double first, const Coefficients& c, Term term) {
  for (std::size_t i = 1; i + 1 < c.size(); i += 2) first += term(c[i], c[i + 1]);
  return first;
}

// 4: n^2 = C1 + C2 l^C3 / (l^2 - C4^C5) + C6 l^C7 / (l^2 - C8^C9) + C10 l^C11 + C12 l^C13 + ...
double formula_4(const Coefficients& c, double l) {
  double n2 = c[0];
  std::size_t i = 1;
  for (; i < 9 && i + 3 < c.size(); i += 4)
    if (c[i] != 0) n2 += c[i] * std::pow(l, c[i + 1]) / (l * l - std::pow(c[i + 2], c[i + 3]));
  for (; i + 1 < c.size(); i += 2) n2 += c[i] * std::pow(l, c[i + 1]);
  return std::sqrt(n2);
}

// 7: n = C1 + C2 L + C3 L^2 + C4 l^2 + C5 l^4 + C6 l^6, L = 1 / (l^2 - 0.028) (Herzberger 1959)
double formula_7(const Coefficients& c, double l) {
  const double big_l = 1 / (l * l - 0.028);
  double n = c[0];
  if (c.size() > 1) n += c[1] * big_l;
  if (c.size() > 2) n += c[2] * big_l * big_l;
  for (std::size_t i = 3; i < c.size(); ++i)
    n += c[i] * std::pow(l * l, static_cast<double>(i - 2));
  return n;
}

// 8: (n^2 - 1) / (n^2 + 2) = C1 + C2 l^2 / (l^2 - C3) + C4 l^2
double formula_8(const Coefficients& c, double l) {
  const double l2 = l * l;
  const double ratio = c[0] + c[1] * l2 / (l2 - c[2]) + c[3] * l2;
  return std::sqrt((1 + 2 * ratio) / (1 - ratio));
}

// 9: n^2 = C1 + C2 / (l^2 - C3) + C4 (l - C5) / ((l - C5)^2 + C6)
double formula_9(const Coefficients& c, double l) {
  const double shift = l - c[4];
  return std::sqrt(c[0] + c[1] / (l * l - c[2]) + c[3] * shift / (shift * shift + c[5]));
}

double numbered_index(int number, const Coefficients& c, double l) {
  const double l2 = l * l;
  const auto power = [l](double a, double exponent) { return a * std::pow(l, exponent); };
  switch (number) {
    case 1:  // Sellmeier: n^2 - 1 = C1 + sum C_2i l^2 / (l^2 - C_2i+1^2)
      return std::sqrt(
          sum_of_pairs(1 + c[0], c, [l2](double b, double l0) { return b * l2 / (l2 - l0 * l0); }));
    case 2:  // Sellmeier-2: n^2 - 1 = C1 + sum C_2i l^2 / (l^2 - C_2i+1)
      return std::sqrt(
          sum_of_pairs(1 + c[0], c, [l2](double b, double l02) { return b * l2 / (l2 - l02); }));
    case 3:  // polynomial: n^2 = C1 + sum C_2i l^C_2i+1
      return std::sqrt(sum_of_pairs(c[0], c, power));
    case 4: return formula_4(c, l);
    case 5:  // Cauchy: n = C1 + sum C_2i l^C_2i+1
      return sum_of_pairs(c[0], c, power);
    case 6:  // gases: n - 1 = C1 + sum C_2i / (C_2i+1 - l^-2)
      return sum_of_pairs(1 + c[0], c, [l2](double a, double b) { return a / (b - 1 / l2); });
    case 7: return formula_7(c, l);
    case 8: return formula_8(c, l);
    case 9: return formula_9(c, l);
    default: return nan_value;
  }
}

double cauchy_index(const Coefficients& c, double l) {
  double n = 0;
  for (std::size_t i = c.size(); i-- > 0;) n = n / (l * l) + c[i];
  return n;
}

double sellmeier_index(const Coefficients& c, double l) {
  double n2 = 1;
  for (std::size_t i = 0; i + 1 < c.size(); i += 2) n2 += c[i] * l * l / (l * l - c[i + 1]);
  return std::sqrt(n2);
}

double mean_index(const std::vector<IndexFormula>& parts, double lambda_nm) {
  double sum = 0;
  for (const auto& part : parts) sum += refractive_index(part, lambda_nm);
  return sum / static_cast<double>(parts.size());
}

}  // namespace

double refractive_index(const IndexFormula& formula, double lambda_nm) {
  using Kind = IndexFormula::Kind;
  if (!check(formula).empty() || !(lambda_nm > 0)) return nan_value;
  const Coefficients& c = formula.coefficients;
  const double l = lambda_nm / 1000;
  switch (formula.kind) {
    case Kind::constant: return real_positive(c[0]);
    case Kind::cauchy: return real_positive(cauchy_index(c, l));
    case Kind::sellmeier: return real_positive(sellmeier_index(c, l));
    case Kind::numbered: return real_positive(numbered_index(formula.number, c, l));
    case Kind::table: return real_positive(monotone_cubic(formula.points, lambda_nm));
    case Kind::povray: return real_positive(c[0] * std::pow(c[1], -(lambda_nm - 555) / 350));
    case Kind::mean: return real_positive(mean_index(formula.parts, lambda_nm));
  }
  return nan_value;
}

// Ghosh 1999, table 1: n^2 = A + B l^2/(l^2 - C) + D l^2/(l^2 - E), which is formula 2 with C1 = A
// - 1.
IndexFormula calcite_ordinary() {
  IndexFormula formula;
  formula.kind = IndexFormula::Kind::numbered;
  formula.number = 2;
  formula.coefficients = {0.73358749, 0.96464345, 1.94325203e-2, 1.82831454, 120};
  return formula;
}

IndexFormula calcite_extraordinary() {
  IndexFormula formula;
  formula.kind = IndexFormula::Kind::numbered;
  formula.number = 2;
  formula.coefficients = {0.35859695, 0.82427830, 1.06689543e-2, 0.14429128, 120};
  return formula;
}

}  // namespace nicol
