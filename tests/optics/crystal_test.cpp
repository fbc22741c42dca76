// Optical activity and optic axes of crystals: host/optics/crystal.hpp.
#include <doctest/doctest.h>

#include <cmath>

#include "host/optics/crystal.hpp"

namespace nicol {

TEST_CASE("gyration and rotation: quartz turns 21.7 deg/mm by g = 1.097e-4") {
  // g = 2 n kappa, kappa = rho lambda/(2 pi) = 3.552e-5 at 589.3 nm, n = 1.5443.
  CHECK(gyration_of_rotation(21.7, 1.5443, 589.3) == doctest::Approx(1.0971e-4).epsilon(2e-4));
  CHECK(rotation_of_gyration(gyration_of_rotation(21.7, 1.5443, 589.3), 1.5443, 589.3) ==
        doctest::Approx(21.7).epsilon(1e-14));
}

TEST_CASE("optic axes: handbook angles from handbook indices") {
  // Aragonite 1.530, 1.681, 1.6855: 2V = 18 deg about alpha (Deer, Howie & Zussman).
  CHECK(2 * (90 - optic_axis_from_gamma_deg(1.530, 1.681, 1.6855)) == doctest::Approx(18.23).epsilon(1e-3));
  // Topaz 1.606, 1.609, 1.616: about gamma, and the same for the indices in any order.
  const double topaz = optic_axis_from_gamma_deg(1.606, 1.609, 1.616);
  CHECK(std::cos(topaz * std::acos(-1.0) / 180) ==
        doctest::Approx(1.606 / 1.609 *
                        std::sqrt((1.616 * 1.616 - 1.609 * 1.609) / (1.616 * 1.616 - 1.606 * 1.606))));
  CHECK(optic_axis_from_gamma_deg(1.616, 1.606, 1.609) == topaz);
  CHECK(optic_axis_from_gamma_deg(1.5, 1.5, 1.6) == 0);
  CHECK(optic_axis_from_gamma_deg(1.5, 1.6, 1.6) == doctest::Approx(90));
}

TEST_CASE("gyration along a direction, scaled and by table") {
  GyrationFormula f;
  f.kind = GyrationFormula::Kind::scaled;
  f.tensor = {1, 2, 3, 4, 5, 6};
  f.at_nm = 600;
  CHECK(gyration(f, 300)[5] == doctest::Approx(12));
  CHECK(gyration_along(f.tensor, {1, 0, 0}) == 1);
  CHECK(gyration_along(f.tensor, {0.6, 0, 0.8}) == doctest::Approx(0.36 + 1.92 + 2 * 5 * 0.48));
  f.kind = GyrationFormula::Kind::table;
  for (auto& points : f.points) points = {{400, 1}, {500, 3}};
  CHECK(gyration(f, 500)[2] == 3);
  CHECK(std::isnan(gyration(f, 600)[0]));
  CHECK(check(f).empty());
  f.points[0].pop_back();
  CHECK_FALSE(check(f).empty());
}

}  // namespace nicol
