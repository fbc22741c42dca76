// Refractive indices against the literature: each formula with a material it was published for.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "host/optics/interpolate.hpp"
#include "host/optics/media.hpp"

using namespace nicol;

namespace {

constexpr double d_line_nm = 587.5618, sodium_nm = 589.3;

IndexFormula numbered(int number, std::vector<double> coefficients) {
  IndexFormula formula;
  formula.kind = IndexFormula::Kind::numbered;
  formula.number = number;
  formula.coefficients = std::move(coefficients);
  return formula;
}

IndexFormula of_kind(IndexFormula::Kind kind, std::vector<double> coefficients) {
  IndexFormula formula;
  formula.kind = kind;
  formula.coefficients = std::move(coefficients);
  return formula;
}

IndexFormula table(std::vector<std::pair<double, double>> points) {
  IndexFormula formula;
  formula.kind = IndexFormula::Kind::table;
  formula.points = std::move(points);
  return formula;
}

void check_index(const IndexFormula& formula, double lambda_nm, double n, double tolerance) {
  CHECK(check(formula) == "");
  CHECK(std::abs(refractive_index(formula, lambda_nm) - n) <= tolerance);
}

}  // namespace

TEST_CASE(
    "formula 1: fused silica") {  // Malitson 1965, J. Opt. Soc. Am. 55, 1205: equation and table 1
  const auto silica =
      numbered(1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161});
  check_index(silica, d_line_nm, 1.45846, 1e-5);
  check_index(silica, 404.656, 1.46962, 1e-5);
  check_index(silica, 1013.98, 1.45024, 1e-5);
}

TEST_CASE("formula 2 and sellmeier: Schott glasses") {  // Schott data sheets N-BK7, N-SF11
  const std::vector<double> bk7{1.03961212,   0.00600069867, 0.231792344,
                                0.0200179144, 1.01046945,    103.560653};
  const std::vector<double> sf11{1.73759695,   0.013188707, 0.313747346,
                                 0.0623068142, 1.89878101,  155.23629};
  check_index(of_kind(IndexFormula::Kind::sellmeier, bk7), d_line_nm, 1.51680, 5e-6);
  check_index(of_kind(IndexFormula::Kind::sellmeier, bk7), 486.1327, 1.52238, 5e-6);
  check_index(of_kind(IndexFormula::Kind::sellmeier, bk7), 656.2725, 1.51432, 5e-6);
  auto sf11_numbered = sf11;
  sf11_numbered.insert(sf11_numbered.begin(), 0);
  check_index(numbered(2, sf11_numbered), d_line_nm, 1.78472, 5e-6);
  check_index(numbered(2, sf11_numbered), 486.1327, 1.80651, 5e-6);
  check_index(numbered(2, sf11_numbered), 656.2725, 1.77596, 5e-6);
}

TEST_CASE("formula 2: quartz") {  // Ghosh 1999, Opt. Commun. 163, 95; n_D 1.54425, 1.55336:
                                  // Handbook of Optics
  const auto quartz_o = numbered(2, {0.28604141, 1.07044083, 1.00585997e-2, 1.10202242, 100});
  const auto quartz_e = numbered(2, {0.28851804, 1.09509924, 1.02101864e-2, 1.15662475, 100});
  check_index(quartz_o, sodium_nm, 1.54425, 1e-4);
  check_index(quartz_e, sodium_nm, 1.55336, 1e-4);
  check_index(quartz_o, 580, 1.5445892642786214, 1e-12);  // computed independently
  check_index(quartz_e, 580, 1.55370246900579, 1e-12);
  IndexFormula mean;  // the isotropic crystal of Kozlov & Debelov 2014
  mean.kind = IndexFormula::Kind::mean;
  mean.parts = {quartz_o, quartz_e};
  check_index(mean, sodium_nm, (1.54425 + 1.55336) / 2, 1e-4);
}

TEST_CASE("calcite") {  // Handbook of Optics: n_o 1.65835, n_e 1.48640 at 589.3 nm
  check_index(calcite_ordinary(), sodium_nm, 1.65835, 5e-5);
  check_index(calcite_extraordinary(), sodium_nm, 1.48640, 3e-4);  // Ghosh's fit gives 1.48613
}

TEST_CASE("formula 3: BK7 by Schott's former polynomial") {  // Schott catalogue 1967
  const auto bk7 = numbered(3, {2.2718929, -1.0108077e-2, 2, 1.0592509e-2, -2, 2.0816965e-4, -4,
                                -7.6472538e-6, -6, 4.9240991e-7, -8});
  check_index(bk7, d_line_nm, 1.51680, 1e-5);
  check_index(bk7, 435.8343, 1.52669, 1e-5);
}

TEST_CASE("formula 4: rutile") {  // DeVore 1951, J. Opt. Soc. Am. 41, 416; n_D: Handbook of Optics
  check_index(numbered(4, {5.913, 0.2441, 0, 0.0803, 1, 0, 0, 0, 1}), sodium_nm, 2.613, 1e-3);
  check_index(numbered(4, {7.197, 0.3322, 0, 0.0843, 1}), sodium_nm, 2.909, 1e-3);
}

TEST_CASE("formula 4: each coefficient in its place") {
  const double l = 0.5;
  const auto formula = numbered(4, {1.5, 0.2, 2, 0.3, 2, 0.1, 1, 0.2, 3, 0.05, 4, -0.01, -2});
  const double n2 = 1.5 + 0.2 * l * l / (l * l - 0.09) + 0.1 * l / (l * l - 0.008) +
                    0.05 * std::pow(l, 4) - 0.01 / (l * l);
  CHECK(refractive_index(formula, 500) == doctest::Approx(std::sqrt(n2)).epsilon(1e-14));
}

TEST_CASE("formula 5 and cauchy: silicon carbide") {  // Shaffer 1971, Appl. Opt. 10, 1034: 2.6525
                                                      // at 589 nm
  check_index(numbered(5, {2.5538, 0.0342, -2}), 589, 2.6525, 5e-4);
  check_index(of_kind(IndexFormula::Kind::cauchy, {2.5538, 0.0342}), 589, 2.6525, 5e-4);
  const double l2 = 0.36;
  CHECK(refractive_index(of_kind(IndexFormula::Kind::cauchy, {1.5, 0.004, 0.0001}), 600) ==
        doctest::Approx(1.5 + 0.004 / l2 + 0.0001 / (l2 * l2)).epsilon(1e-14));
}

TEST_CASE("formula 6: air") {
  // Ciddor 1996, Appl. Opt. 35, 1566, equation 1, against Edlen 1953, J. Opt. Soc. Am. 43, 339,
  // equation 15
  const auto air = numbered(6, {0, 0.05792105, 238.0185, 0.00167917, 57.362});
  for (const double lambda_nm : {404.7, 589.3, 780.0}) {
    const double sigma2 = 1e6 / (lambda_nm * lambda_nm);
    const double edlen = 1 + 1e-8 * (6432.8 + 2949810 / (146 - sigma2) + 25540 / (41 - sigma2));
    check_index(air, lambda_nm, edlen, 3e-8);
  }
}

TEST_CASE("formula 7: silicon") {
  // Edwards & Ochoa 1980, Appl. Opt. 19, 4130, against Salzberg & Villa 1957, J. Opt. Soc. Am. 47,
  // 244
  const auto silicon = numbered(7, {3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9});
  check_index(silicon, 2437.3, 3.4408, 4e-3);
  check_index(silicon, 10000, 3.4179, 4e-3);
  const double l2 = 0.25, big_l = 1 / (l2 - 0.028);
  CHECK(refractive_index(numbered(7, {1, 0.01, 0.02, 0.3, 0.4, 0.5}), 500) ==
        doctest::Approx(1 + 0.01 * big_l + 0.02 * big_l * big_l + 0.3 * l2 + 0.4 * l2 * l2 +
                        0.5 * l2 * l2 * l2));
}

TEST_CASE(
    "formula 8: silver bromide") {  // Schroeter 1931, Z. Phys. 67, 24; n_D 2.253: CRC Handbook
  const std::vector<double> c{0.452505, 0.09939, 0.070537, -0.000150};
  check_index(numbered(8, c), sodium_nm, 2.253, 5e-3);
  const double n = refractive_index(numbered(8, c), 500);
  CHECK((n * n - 1) / (n * n + 2) ==
        doctest::Approx(c[0] + c[1] * 0.25 / (0.25 - c[2]) + c[3] * 0.25).epsilon(1e-12));
}

TEST_CASE("formula 9: urea") {  // Rosker 1985, IEEE J. Quantum Electron. 21, 1600; n_e 1.602: CRC
                                // Handbook
  check_index(numbered(9, {2.51527, 0.0240, 0.0300, 0.020, 1.52, 0.8771}), sodium_nm, 1.602, 5e-3);
  const double l = 0.5, shift = l - 0.2;
  CHECK(
      refractive_index(numbered(9, {2, 0.02, 0.03, 0.4, 0.2, 0.6}), 500) ==
      doctest::Approx(std::sqrt(2 + 0.02 / (l * l - 0.03) + 0.4 * shift / (shift * shift + 0.6))));
}

TEST_CASE(
    "ior and dispersion as POV-Ray has them") {  // dispersion = n(violet, 380 nm) / n(red, 730 nm)
  const auto glass = of_kind(IndexFormula::Kind::povray, {1.5, 1.02});
  CHECK(refractive_index(glass, 555) == doctest::Approx(1.5));
  CHECK(refractive_index(glass, 380) / refractive_index(glass, 730) == doctest::Approx(1.02));
  CHECK(refractive_index(glass, 380) > refractive_index(glass, 730));
}

TEST_CASE("values that do not exist are NaN") {
  CHECK(std::isnan(refractive_index(numbered(2, {0, 1, 0.25}), 500)));          // on the pole
  CHECK(std::isnan(refractive_index(numbered(2, {0, 1, 0.3}), 500)));           // n^2 < 0
  CHECK(std::isnan(refractive_index(table({{400, 1.5}, {700, 1.4}}), 399.9)));  // outside the table
  CHECK(std::isnan(refractive_index(table({{400, 1.5}, {700, 1.4}}), 700.1)));
  CHECK(std::isnan(refractive_index(numbered(2, {0, 1}), 500)));  // wrong coefficients
  CHECK(std::isnan(refractive_index(of_kind(IndexFormula::Kind::cauchy, {1.5}), 0)));
}

TEST_CASE("a table meets its points and stays between them") {
  const auto quartz = table({{400, 1.5577}, {500, 1.5487}, {600, 1.5438}, {700, 1.5406}});
  CHECK(refractive_index(quartz, 400) == 1.5577);
  CHECK(refractive_index(quartz, 500) == 1.5487);
  CHECK(refractive_index(quartz, 700) == 1.5406);
  CHECK(refractive_index(quartz, 550) ==
        doctest::Approx(1.5460).epsilon(2e-4));  // Ghosh 1999: 1.54599
  CHECK(rc::check("monotone cubic: no overshoot", [] {
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(1, 50), rc::gen::inRange(-1000, 1000)));
    RC_PRE(steps.size() >= 2);
    Points points;
    double x = 300;
    for (const auto& [step, y] : steps) points.emplace_back(x += step, y);
    const double place = *rc::gen::inRange(0, 1001) / 1000.0;
    const auto i = *rc::gen::inRange<std::size_t>(0, points.size() - 1);
    const double at = points[i].first * (1 - place) + points[i + 1].first * place;
    const double value = monotone_cubic(points, at);
    RC_ASSERT(value >= std::min(points[i].second, points[i + 1].second) - 1e-9);
    RC_ASSERT(value <= std::max(points[i].second, points[i + 1].second) + 1e-9);
  }));
}

TEST_CASE("wrong coefficients are named") {
  CHECK(check(numbered(2, {1, 2, 3, 4})) == "formula 2 takes 1 + 2m coefficients, 4 given");
  CHECK(check(numbered(4, {1, 2, 3})) == "formula 4 takes 1, 5 or 9 + 2m coefficients, 3 given");
  CHECK(check(numbered(8, {1})) == "formula 8 takes 4 coefficients, 1 given");
  CHECK(check(numbered(0, {1})) == "there is no formula 0: the formulas are 1 to 9");
  CHECK(check(numbered(10, {1})) == "there is no formula 10: the formulas are 1 to 9");
  CHECK(check(of_kind(IndexFormula::Kind::sellmeier, {1, 2, 3})) ==
        "the Sellmeier formula takes 2m coefficients B, C, 3 given");
  CHECK(check(of_kind(IndexFormula::Kind::constant, {-1.5})) ==
        "a refractive index must be positive");
  CHECK(check(of_kind(IndexFormula::Kind::cauchy, {1.5, NAN})) == "coefficient 2 is not finite");
  CHECK(check(table({{500, 1.5}})) == "a table takes 2 or more points, 1 given");
  CHECK(check(table({{500, 1.5}, {500, 1.4}})) ==
        "point 2 of the table is not at a longer wavelength than the one before");
  IndexFormula mean;
  mean.kind = IndexFormula::Kind::mean;
  mean.parts = {of_kind(IndexFormula::Kind::constant, {1.5}), numbered(9, {1})};
  CHECK(check(mean) == "formula 9 takes 6 coefficients, 1 given");
}
