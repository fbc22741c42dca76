// False colours and ellipses: Stokes vectors whose polarization is known.
#include <cmath>

#include "host/preview/ellipse.hpp"
#include "host/preview/view.hpp"
#include "host/preview/view_colours.hpp"
#include "traced.hpp"

namespace nicol::preview {
namespace {

constexpr double pi = 3.14159265358979323846;

View of(Quantity quantity) { return {quantity, std::nullopt}; }

Rgb shown(const Stokes& stokes, Quantity quantity) {
  return colour_at(develop(uniform(2, 2, stokes), of(quantity)).rgb, 2, 1, 1);
}

bool alike(const Rgb& a, const Rgb& b, float tolerance = 1e-5f) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::fabs(a[k] - b[k]) <= tolerance)) return false;
  return true;
}

// Where on the scale the colour stands, and that it does.
double value_on_scale(const Rgb& colour, Quantity quantity) {
  const Scale scale = scale_of(of(quantity));
  for (std::size_t i = 0; i < scale.rgb.size(); ++i)
    if (alike(scale.rgb[i], colour))
      return scale.low + (scale.high - scale.low) * static_cast<double>(i) / static_cast<double>(scale.rgb.size() - 1);
  return NAN;
}

// Back to Oklab (Ottosson 2020), to see what the eye sees.
std::array<double, 3> oklab(const Rgb& c) {
  const double l = std::cbrt(0.4122214708 * c[0] + 0.5363325363 * c[1] + 0.0514459929 * c[2]);
  const double m = std::cbrt(0.2119034982 * c[0] + 0.6806995451 * c[1] + 0.1073969566 * c[2]);
  const double s = std::cbrt(0.0883024619 * c[0] + 0.2817188376 * c[1] + 0.6299787005 * c[2]);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

}  // namespace

TEST_CASE("view: every quantity has one name") {
  CHECK(all_quantities().size() == 8);
  for (const Quantity quantity : all_quantities()) CHECK(quantity_named(name_of(quantity)) == quantity);
  CHECK_FALSE(quantity_named("hue"));
}

TEST_CASE("view: ellipses of known Stokes vectors") {
  const auto near = [](const Ellipse& e, double azimuth_deg, double ellipticity_deg, double degree) {
    CHECK(e.azimuth_rad * 180 / pi == doctest::Approx(azimuth_deg).epsilon(1e-9));
    CHECK(e.ellipticity_rad * 180 / pi == doctest::Approx(ellipticity_deg).epsilon(1e-9));
    CHECK(e.degree == doctest::Approx(degree).epsilon(1e-9));
  };
  near(ellipse_of({2, 2, 0, 0}), 0, 0, 1);                                  // horizontal
  near(ellipse_of({1, -0.5, 0, 0}), 90, 0, 0.5);                            // half of it vertical
  near(ellipse_of({1, 0, 1, 0}), 45, 0, 1);                                 // counter-clockwise from the right
  near(ellipse_of({1, 0, -1, 0}), -45, 0, 1);
  near(ellipse_of({1, 0, 0, 1}), 0, 45, 1);                                 // right circular
  near(ellipse_of({1, 0, 0, -0.2}), 0, -45, 0.2);                           // left
  near(ellipse_of({1, 0, std::sqrt(0.75), 0.5}), 45, 15, 1);
  near(ellipse_of({0, 0, 0, 0}), 0, 0, 0);
}

TEST_CASE("view: horizontal light everywhere") {
  const Stokes horizontal{1, 1, 0, 0};
  CHECK(value_on_scale(shown(horizontal, Quantity::degree), Quantity::degree) == 1);
  CHECK(value_on_scale(shown(horizontal, Quantity::angle), Quantity::angle) == 0);
  CHECK(value_on_scale(shown(horizontal, Quantity::ellipticity), Quantity::ellipticity) == 0);
  CHECK(value_on_scale(shown(horizontal, Quantity::s1), Quantity::s1) == doctest::Approx(1));
  CHECK(value_on_scale(shown(horizontal, Quantity::s2), Quantity::s2) == doctest::Approx(0));
}

TEST_CASE("view: the scale tells the value that the picture shows") {
  CHECK(alike(shown({1, 0, 1, 0}, Quantity::angle), angle_colour(0, 1)));
  CHECK(value_on_scale(shown({1, -0.5f, -std::sqrt(0.75f), 0}, Quantity::angle), Quantity::angle) == doctest::Approx(120));
  CHECK(value_on_scale(shown({1, -1, 0, 0}, Quantity::angle), Quantity::angle) == doctest::Approx(90));
  CHECK(value_on_scale(shown({4, 0, 0, 4}, Quantity::ellipticity), Quantity::ellipticity) == doctest::Approx(45));
  CHECK(value_on_scale(shown({4, 0, 0, -1}, Quantity::ellipticity), Quantity::ellipticity) == doctest::Approx(-45));
  CHECK(value_on_scale(shown({1, std::sqrt(0.75f), 0, -0.5f}, Quantity::ellipticity), Quantity::ellipticity) ==
        doctest::Approx(-15));
  CHECK(value_on_scale(shown({5, 0, 0, -1}, Quantity::s3), Quantity::s3) == doctest::Approx(-0.2));
  CHECK(value_on_scale(shown({5, 1, 0, 0}, Quantity::degree), Quantity::degree) == doctest::Approx(0.2));
}

TEST_CASE("view: unpolarized light has no hue, darkness no colour") {
  const Rgb grey = shown({1, 0, 0, 0}, Quantity::angle);
  CHECK(grey[0] == doctest::Approx(grey[1]).epsilon(1e-4));
  CHECK(grey[1] == doctest::Approx(grey[2]).epsilon(1e-4));
  CHECK(alike(shown({1, 0, 0, 0}, Quantity::ellipticity), nothing_there()));
  for (const Quantity quantity : {Quantity::degree, Quantity::angle, Quantity::ellipticity, Quantity::s1})
    CHECK(alike(shown({0, 0, 0, 0}, quantity), nothing_there()));
}

TEST_CASE("view: false colours are in sRGB, and equal steps look equally far apart") {
  for (const Quantity quantity : {Quantity::degree, Quantity::angle, Quantity::ellipticity, Quantity::s1}) {
    INFO(name_of(quantity));
    const Scale scale = scale_of(of(quantity));
    REQUIRE(scale.rgb.size() % 2 == 1);  // 0 in the middle
    double least = INFINITY, most = 0;
    for (std::size_t i = 0; i < scale.rgb.size(); ++i) {
      INFO(i, ": ", scale.rgb[i][0], " ", scale.rgb[i][1], " ", scale.rgb[i][2]);
      for (const float c : scale.rgb[i]) CHECK((c >= 0 && c <= 1));
      if (i == 0) continue;
      const auto a = oklab(scale.rgb[i - 1]), b = oklab(scale.rgb[i]);
      const double step = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      least = std::min(least, step);
      most = std::max(most, step);
    }
    CHECK(most < 1.1 * least);
  }
  const Scale angle = scale_of(of(Quantity::angle));
  CHECK(alike(angle.rgb.front(), angle.rgb.back()));
  CHECK(angle.high == 180);
  for (const Rgb& c : angle.rgb) CHECK(oklab(c)[0] == doctest::Approx(oklab(angle.rgb[0])[0]).epsilon(1e-3));
  CHECK(scale_of(of(Quantity::colour)).rgb.empty());
}

TEST_CASE("view: colours are the picture's, ellipses dim them") {
  const Picture picture = uniform(3, 2, {0.01f, 0, 0, 0});
  const Developed colours = develop(picture, of(Quantity::colour)), dim = develop(picture, of(Quantity::ellipses));
  CHECK(colours.width == 3);
  CHECK(colours.height == 2);
  CHECK(colours.exposed);
  CHECK(dim.exposed);
  CHECK_FALSE(develop(picture, of(Quantity::degree)).exposed);
  CHECK(colours.rgb == picture.rgb);
  CHECK(dim.rgb[4] < 0.5f * colours.rgb[4]);
  CHECK(dim.rgb[4] > 0);
}

TEST_CASE("view: one wavelength is as bright as equal-energy light of its radiance") {
  Picture picture = uniform(4, 4, {0.01f, 0, 0, 0});
  const Developed grey = develop(picture, {Quantity::colour, 1});
  CHECK(grey.rgb[0] == grey.rgb[1]);
  CHECK(grey.rgb[1] == grey.rgb[2]);
  CHECK(grey.rgb[0] == doctest::Approx(picture.stokes_y[0]));

  // Its own Stokes vector, not the spectrum's.
  for (std::size_t p = 0; p < picture.frame.plane(); ++p) picture.frame.component(1, 1)[p] = -0.01f;
  CHECK(alike(colour_at(develop(picture, {Quantity::s1, 1}).rgb, 4, 3, 3), diverging_colour(-1)));
  CHECK(alike(colour_at(develop(picture, {Quantity::s1, 0}).rgb, 4, 3, 3), diverging_colour(0)));
}

TEST_CASE("view: blocks at one wavelength show their traced corner") {
  Picture picture = make_picture(9, 8, {550}, {1});
  trace(picture, 0, 0, {1, 1, 0, 0});
  trace(picture, 8, 0, {1, -1, 0, 0});
  const View view{Quantity::s1, 0};
  const Developed developed = develop(picture, view);
  CHECK(alike(colour_at(developed.rgb, 9, 7, 7), diverging_colour(1)));
  CHECK(alike(colour_at(developed.rgb, 9, 8, 5), diverging_colour(-1)));
  const Picture untraced = make_picture(9, 8, {550}, {1});
  for (const Quantity quantity : all_quantities())
    for (const View& v : {View{quantity, 0}, View{quantity, std::nullopt}}) {
      if (quantity == Quantity::ellipses && !v.wavelength) continue;  // dimmed
      CHECK(alike(colour_at(develop(untraced, v).rgb, 9, 3, 3), nothing_there()));
    }
}

TEST_CASE("view: half-finished passes show what shown_pixel says") {
  for (const int step : {0, 2, 8, 64}) {
    Picture picture = make_picture(150, 70, {550}, {1});
    unsigned noise = 1;
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 150; ++x) {
        noise = noise * 1664525 + 1013904223;
        const bool whole = step > 0 && x % step == 0 && y % step == 0;
        if (!whole && noise >> 24 > 20) continue;
        trace(picture, x, y, {1, static_cast<float>(noise >> 16 & 255) / 255, 0, 0});
      }
    picture.step = step;
    const Developed developed = develop(picture, {Quantity::s1, 0});
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 150; ++x) {
        const auto p = shown_pixel(picture, x, y);
        const Rgb wanted = p < 0 ? nothing_there() : diverging_colour(picture.frame.component(1, 0)[p]);
        CHECK_MESSAGE(alike(colour_at(developed.rgb, 150, x, y), wanted), "pixel ", x, " ", y, " of step ", step);
      }
  }
}

TEST_CASE("view: ellipses stand where there is polarized light") {
  Picture picture = uniform(40, 20, {1, 0, 0.5f, 0});
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) trace(picture, x, y, x < 10 ? Stokes{1, 0, 0, 0} : Stokes{5e-5f, 5e-5f, 0, 0});
  const auto all = ellipses(picture, of(Quantity::ellipses), 10);
  REQUIRE(all.size() == 4);  // of 8: neither the unpolarized nor the dark ones
  for (const Ellipse& e : all) {
    CHECK(e.x > 20);
    CHECK(e.azimuth_rad == doctest::Approx(pi / 4));
    CHECK(e.degree == doctest::Approx(0.5));
  }
  CHECK(all[0].x == 25.5);
  CHECK(all[0].y == 5.5);
  CHECK(ellipses(make_picture(40, 20, {550}, {1}), of(Quantity::ellipses), 10).empty());
}

}  // namespace nicol::preview
