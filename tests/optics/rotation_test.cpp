// Optical rotation of quartz against measurements, and absorption.
#include <doctest/doctest.h>

#include <cmath>

#include "host/optics/media.hpp"

using namespace nicol;

namespace {

RotationFormula rotation(RotationFormula::Kind kind, std::vector<double> coefficients,
                         double scale = 1) {
  RotationFormula formula;
  formula.kind = kind;
  formula.coefficients = std::move(coefficients);
  formula.scale = scale;
  return formula;
}

using Kind = RotationFormula::Kind;

}  // namespace

TEST_CASE("Chandrasekhar's formula for quartz") {
  // Chandrasekhar 1961, Proc. Indian Acad. Sci. A 53, 1: k 7.19, lambda0 0.0926283 um.
  // Measured at 20 degrees C: Lowry & Coode-Adams 1927, Phil. Trans. R. Soc. A 226, 391
  const auto quartz = rotation(Kind::chandrasekhar, {7.19, 0.0926283});
  CHECK(rotation_deg_per_mm(quartz, 589.3) == doctest::Approx(21.724).epsilon(0.004));
  CHECK(rotation_deg_per_mm(quartz, 435.8) == doctest::Approx(41.548).epsilon(0.004));
  CHECK(rotation_deg_per_mm(quartz, 643.8) == doctest::Approx(18.023).epsilon(0.006));
}

TEST_CASE("the strong crystal of Kozlov & Debelov 2014 turns by about 300 right angles") {
  const auto strong = rotation(Kind::chandrasekhar, {7.19, 0.0926283}, 75);
  CHECK(rotation_deg_per_mm(strong, 580) * 16 == doctest::Approx(27008.17).epsilon(1e-6));
  const auto left = rotation(Kind::chandrasekhar, {7.19, 0.0926283}, -1);
  CHECK(rotation_deg_per_mm(left, 580) == doctest::Approx(-27008.17 / 75 / 16).epsilon(1e-6));
}

TEST_CASE("Drude's and Biot's formulas") {
  // Lowry & Coode-Adams 1927, Phil. Trans. R. Soc. A 226, 391: two terms and a constant for quartz,
  // 20 degrees C
  const auto quartz = rotation(Kind::drude, {9.5639, 0.0127493, -2.3113, 0.000974, -0.1905});
  CHECK(rotation_deg_per_mm(quartz, 589.3) == doctest::Approx(21.724).epsilon(1e-4));
  CHECK(rotation_deg_per_mm(quartz, 435.83) == doctest::Approx(41.548).epsilon(1e-4));
  const double l2 = 0.36;
  CHECK(rotation_deg_per_mm(rotation(Kind::drude, {7, 0.02, -0.5}), 600) ==
        doctest::Approx(7 / (l2 - 0.02) - 0.5).epsilon(1e-14));
  CHECK(rotation_deg_per_mm(rotation(Kind::biot, {7, 0.2}), 600) ==
        doctest::Approx(7 / l2 + 0.2 / (l2 * l2)).epsilon(1e-14));
}

TEST_CASE("constant, none and table") {
  CHECK(rotation_deg_per_mm(rotation(Kind::none, {}), 500) == 0);
  CHECK(rotation_deg_per_mm(rotation(Kind::constant, {5}, 2), 500) == 10);
  auto table = rotation(Kind::table, {}, -1);
  table.points = {{400, 49}, {500, 31}, {600, 21}};
  CHECK(rotation_deg_per_mm(table, 500) == -31);
  CHECK(std::isnan(rotation_deg_per_mm(table, 601)));
  CHECK(std::isnan(rotation_deg_per_mm(rotation(Kind::drude, {1, 0.25}), 500)));  // on the pole
}

TEST_CASE("wrong coefficients of a rotation are named") {
  CHECK(check(rotation(Kind::chandrasekhar, {7.19})) ==
        "Chandrasekhar's formula takes 2 coefficients k, lambda0, 1 given");
  CHECK(check(rotation(Kind::drude, {7})) ==
        "Drude's formula takes 2 or more coefficients, 1 given");
  CHECK(check(rotation(Kind::biot, {})) == "Biot's formula takes 1 or more coefficients, 0 given");
  CHECK(check(rotation(Kind::constant, {1}, NAN)) == "the scale of the rotation is not finite");
}

TEST_CASE("absorption") {
  AbsorptionFormula tint;
  CHECK(absorb_per_mm(tint, 500) == 0);
  tint.kind = AbsorptionFormula::Kind::constant;
  tint.per_mm = 0.3;
  CHECK(absorb_per_mm(tint, 500) == 0.3);
  tint.per_mm = -1;
  CHECK(check(tint) == "an absorption must not be negative");
  CHECK(std::isnan(absorb_per_mm(tint, 500)));
  tint.kind = AbsorptionFormula::Kind::table;
  tint.points = {{400, 1}, {500, 0}, {600, 0}};
  CHECK(absorb_per_mm(tint, 550) == 0);
  CHECK(absorb_per_mm(tint, 450) > 0);
  CHECK(absorb_per_mm(tint, 450) < 1);
  tint.points[1].second = -0.1;
  CHECK(check(tint) == "point 2 of the table is negative");
}
