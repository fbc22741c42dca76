// All that is known of one pixel: the same numbers as the picture's file gets.
#include <cmath>

#include "host/preview/pixel_info.hpp"
#include "traced.hpp"

namespace nicol::preview {
namespace {

// Spectra that differ from pixel to pixel.
Picture varied() {
  const std::vector<double> lambda_nm{420, 480, 540, 600, 660};
  Picture picture = make_picture(6, 5, lambda_nm, wavelength_weights(lambda_nm));
  picture.frame.exposure = 0.7;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x) {
      trace(picture, x, y, {1, 0, 0, 0});
      const std::size_t p = static_cast<std::size_t>(y) * 6 + x;
      for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
        picture.frame.component(0, i)[p] = 0.002f * static_cast<float>(1 + x + 2 * y + i);
        picture.frame.component(2, i)[p] = 0.001f * static_cast<float>(i);
        picture.frame.component(3, i)[p] = -0.001f;
      }
      picture.frame.cut_off[p] = 0.001f * static_cast<float>(x);
      picture.frame.samples[p] = static_cast<std::uint32_t>(1 + y);
    }
  picture.brightest_radiance = 4;
  return picture;
}

}  // namespace

TEST_CASE("pixel: the window's exposure counts for its colours, not for its light") {
  const Picture picture = varied();
  const auto plain = pixel_info(picture, {}, 2, 3), brighter = pixel_info(picture, {}, 2, 3, 2);
  REQUIRE(plain);
  REQUIRE(brighter);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(brighter->xyz[k] == doctest::Approx(2 * plain->xyz[k]));
    CHECK(brighter->rgb[k] == doctest::Approx(2 * plain->rgb[k]));
  }
  CHECK(brighter->stokes == plain->stokes);
  CHECK(brighter->stokes_y == plain->stokes_y);
}

TEST_CASE("pixel: its colour is the one that is written to files") {
  const Picture picture = varied();
  const auto rgb = linear_rgb(picture.frame);
  for (const auto& at : {std::array<int, 2>{0, 0}, {5, 4}, {2, 3}}) {
    const auto info = pixel_info(picture, {}, at[0], at[1]);
    REQUIRE(info);
    const std::size_t p = static_cast<std::size_t>(at[1]) * 6 + at[0];
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(info->rgb[k] == doctest::Approx(static_cast<double>(rgb[3 * p + k])).epsilon(1e-6));
      CHECK(info->srgb[k] == std::lround(255 * srgb_encode(static_cast<double>(rgb[3 * p + k]))));
    }
    CHECK(info->xyz[1] == doctest::Approx(0.7 * info->stokes_y[0]));
    CHECK(info->samples == 1 + at[1]);
    CHECK(info->cut_off == doctest::Approx(0.001 * at[0]));
    CHECK(info->cut_off_radiance == doctest::Approx(0.004 * at[0]));
    CHECK(info->block == 1);
    CHECK(info->stokes[0].size() == 5);
  }
}

TEST_CASE("pixel: the ellipse is that of the view's wavelength, or of all") {
  const Picture picture = varied();
  const auto at_first = pixel_info(picture, {Quantity::colour, 0}, 1, 1);
  const auto at_last = pixel_info(picture, {Quantity::colour, 4}, 1, 1);
  constexpr double pi = 3.14159265358979323846;
  CHECK(at_first->ellipse.ellipticity_rad == doctest::Approx(-pi / 4));  // S2 = 0: left circular
  CHECK(at_last->ellipse.azimuth_rad == doctest::Approx(pi / 4));
  CHECK(at_last->ellipse.ellipticity_rad == doctest::Approx(std::asin(-1 / std::sqrt(17)) / 2));
  CHECK(at_last->ellipse.degree == doctest::Approx(std::sqrt(17) / 16));

  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t s = 0; s < 4; ++s)
      sum[s] += colour_matching(picture.frame.lambda_nm[i])[1] * picture.frame.weight_nm[i] * at_first->stokes[s][i];
  const auto all = pixel_info(picture, {}, 1, 1);
  CHECK(all->ellipse.degree == doctest::Approx(std::hypot(sum[1], sum[2], sum[3]) / sum[0]));
  CHECK(all->ellipse.azimuth_rad == doctest::Approx(std::atan2(sum[2], sum[1]) / 2));
}

TEST_CASE("pixel: one of a block tells of the block's corner") {
  Picture picture = make_picture(20, 20, {550}, {1});
  trace(picture, 8, 16, {2, 0, 0, 2});
  const auto info = pixel_info(picture, {}, 11, 19);
  REQUIRE(info);
  CHECK(info->block == 4);
  CHECK(info->x == 11);
  CHECK(info->stokes[0][0] == 2);
  CHECK_FALSE(pixel_info(picture, {}, 3, 3));
  CHECK_FALSE(pixel_info(picture, {}, -1, 3));
  CHECK_FALSE(pixel_info(picture, {}, 20, 3));
}

}  // namespace nicol::preview
