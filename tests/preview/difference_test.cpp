// Two pictures compared: against themselves, and against ones that differ by a known amount.
#include <cmath>

#include "host/accuracy/colour_difference.hpp"
#include "host/preview/difference.hpp"
#include "traced.hpp"

namespace nicol::preview {

TEST_CASE("difference: of a picture with itself there is none") {
  const Picture picture = uniform(8, 4, {0.5f, 0.2f, -0.1f, 0.3f});
  const Difference d = difference(picture, picture, {});
  CHECK(d.comparable);
  CHECK(d.rms == 0);
  CHECK(d.largest == 0);
  CHECK(d.delta_e_largest == 0);
  for (const float c : d.developed.rgb) CHECK(c == 0);
}

TEST_CASE("difference: twice the light differs by all of the light") {
  const Picture one = uniform(8, 4, {0.005f, 0.003f, 0, 0.004f}), two = uniform(8, 4, {0.01f, 0.006f, 0, 0.008f});
  const Difference d = difference(one, two, {});
  CHECK(d.rms == doctest::Approx(std::sqrt(2)));  // |S| = sqrt 2 S0 where light is polarized
  CHECK(d.largest == doctest::Approx(std::sqrt(2)));
  for (std::size_t i = 0; i < d.developed.rgb.size(); ++i) CHECK(d.developed.rgb[i] == doctest::Approx(one.rgb[i]));
  CHECK(d.developed.exposed);
  const auto colour = [](const Picture& p) {
    return lab_of_xyz(xyz_of_linear_srgb({p.rgb[0], p.rgb[1], p.rgb[2]}));
  };
  CHECK(d.delta_e_largest == doctest::Approx(ciede2000(colour(one), colour(two))).epsilon(1e-5));
}

TEST_CASE("difference: the worst pixel is found, with its colour") {
  const Picture left = uniform(10, 10, {0.01f, 0, 0, 0});
  Picture right = left;
  trace(right, 7, 2, {0.01f, 0.004f, 0, 0});
  trace(right, 3, 8, {0.012f, 0, 0, 0});
  const Difference d = difference(left, right, {});
  CHECK(d.x == 7);
  CHECK(d.y == 2);
  CHECK(d.largest == doctest::Approx(0.4));
  CHECK(d.rms == doctest::Approx(std::sqrt((0.16 + 0.04) / 100)));
  CHECK(d.delta_e_largest > 1);  // of (3, 8): polarization has no colour

  const Difference grey = difference(left, right, {Quantity::angle, 1});
  CHECK(colour_at(grey.developed.rgb, 10, 7, 2)[0] == 0);
  const auto brighter = colour_at(grey.developed.rgb, 10, 3, 8);
  CHECK(brighter[0] > 0);
  CHECK(brighter[0] == brighter[2]);
}

TEST_CASE("difference: the largest difference of colours is the largest over all pixels") {
  Picture left = make_picture(30, 30, {450, 550, 650}, {100, 100, 100}), right = left;
  double largest = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x) {
      trace(left, x, y, {1, 0, 0, 0});
      trace(right, x, y, {1, 0, 0, 0});
      const std::size_t p = 3 * (static_cast<std::size_t>(y) * 30 + x);
      std::array<double, 3> a{}, b{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto wave = [&](double f, double g) { return 0.5 + 0.45 * std::sin(f * x + g * y + static_cast<double>(k)); };
        left.rgb[p + k] = static_cast<float>(wave(0.3, 0.7));
        right.rgb[p + k] = static_cast<float>(wave(0.31, 0.68));
        a[k] = static_cast<double>(left.rgb[p + k]);
        b[k] = static_cast<double>(right.rgb[p + k]);
      }
      largest = std::max(largest, ciede2000(lab_of_xyz(xyz_of_linear_srgb(a)), lab_of_xyz(xyz_of_linear_srgb(b))));
    }
  CHECK(largest > 5);
  CHECK(difference(left, right, {}).delta_e_largest == doctest::Approx(largest));
}

TEST_CASE("difference: only what both have traced counts") {
  const Picture left = uniform(4, 4, {0.01f, 0, 0, 0});
  Picture right = make_picture(4, 4, left.frame.lambda_nm, left.frame.weight_nm);
  CHECK_FALSE(difference(left, right, {}).comparable);
  trace(right, 0, 0, {0.02f, 0, 0, 0});
  const Difference d = difference(left, right, {});
  CHECK(d.comparable);
  CHECK(d.rms == doctest::Approx(1));
  CHECK_FALSE(difference(left, uniform(4, 5, {0.01f, 0, 0, 0}), {}).comparable);
}

TEST_CASE("difference: pictures of other wavelengths are compared where they have the same ones, else by luminance") {
  Picture coarse = make_picture(2, 1, {450, 550}, {100, 100}), fine = make_picture(2, 1, {450, 500, 550}, {50, 50, 50});
  Picture other = make_picture(2, 1, {470, 570}, {100, 100});
  for (int x = 0; x < 2; ++x) {
    trace(coarse, x, 0, {0.01f, 0, 0, 0});
    trace(fine, x, 0, {0.01f, 0.002f, 0, 0});
    trace(other, x, 0, {0.01f, 0.002f, 0, 0});
  }
  for (Picture* picture : {&coarse, &fine, &other}) picture->mean_radiance = 0.01;
  const Difference d = difference(coarse, fine, {Quantity::colour, 1});
  CHECK(d.comparable);
  CHECK(d.rms == doctest::Approx(0.2));
  for (const float value : d.developed.rgb) CHECK(value == doctest::Approx(0).epsilon(1e-6));   // both at 550 nm

  const Difference by_luminance = difference(coarse, other, {});
  CHECK(by_luminance.comparable);
  CHECK(by_luminance.rms > 0.2);
  CHECK(std::isfinite(by_luminance.rms));
}

}  // namespace nicol::preview
