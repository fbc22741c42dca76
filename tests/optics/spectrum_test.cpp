// Spectra of lights: their scale on any grid, and colours that come back as they were given.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "host/optics/colour.hpp"

using namespace nicol;

namespace {

using Kind = SpectrumFormula::Kind;

std::vector<double> steps(double first_nm, double last_nm, double step_nm) {
  std::vector<double> lambda_nm;
  for (double l = first_nm; l <= last_nm + 1e-9; l += step_nm) lambda_nm.push_back(l);
  return lambda_nm;
}

SpectrumFormula of_kind(Kind kind, std::vector<double> numbers = {}, double scale = 1) {
  SpectrumFormula formula;
  formula.kind = kind;
  formula.numbers = std::move(numbers);
  formula.scale = scale;
  return formula;
}

std::vector<double> sampled(const SpectrumFormula& formula, const std::vector<double>& lambda_nm,
                            std::string& error) {
  return sample_spectrum(formula, lambda_nm, wavelength_weights(lambda_nm), error);
}

std::vector<double> sampled(const SpectrumFormula& formula, const std::vector<double>& lambda_nm) {
  std::string error;
  auto radiance = sampled(formula, lambda_nm, error);
  REQUIRE(error == "");
  REQUIRE(radiance.size() == lambda_nm.size());
  return radiance;
}

std::array<double, 3> xyz(const std::vector<double>& lambda_nm,
                          const std::vector<double>& radiance) {
  return Observer(lambda_nm, wavelength_weights(lambda_nm)).xyz(radiance.data());
}

std::string error_of(const SpectrumFormula& formula, const std::vector<double>& lambda_nm) {
  std::string error;
  CHECK(sampled(formula, lambda_nm, error).empty());
  return error;
}

}  // namespace

TEST_CASE("every light has the luminance of its scale on the grid of the scene") {
  SpectrumFormula lamp = of_kind(Kind::table, {}, 0.7);
  lamp.points = {{300, 1}, {500, 3}, {900, 2}};
  const std::vector<SpectrumFormula> lights{
      of_kind(Kind::d65, {}, 0.4),   of_kind(Kind::a),
      of_kind(Kind::e, {}, 3),       of_kind(Kind::blackbody, {1200}),
      of_kind(Kind::line, {580}, 2), lamp};
  for (const auto& lambda_nm :
       {steps(380, 780, 20), steps(380, 780, 5), steps(580, 580, 1), steps(570, 590, 10)})
    for (const auto& light : lights)
      CHECK(xyz(lambda_nm, sampled(light, lambda_nm))[1] ==
            doctest::Approx(light.scale).epsilon(1e-12));
}

TEST_CASE("D65 by its table") {  // CIE 015:2018
  const auto lambda_nm = std::vector<double>{400, 402, 405, 560, 700, 830, 840};
  const auto radiance = sampled(of_kind(Kind::d65), lambda_nm);
  CHECK(radiance[0] / radiance[3] == doctest::Approx(0.827549));
  CHECK(radiance[1] / radiance[3] == doctest::Approx((0.6 * 82.7549 + 0.4 * 87.1204) / 100));
  CHECK(radiance[4] / radiance[3] == doctest::Approx(0.716091));
  CHECK(radiance[5] / radiance[3] == doctest::Approx(0.603125));
  CHECK(radiance[6] == 0);
}

TEST_CASE("illuminant A by its table") {  // CIE 015:2018: 9.79510 at 380 nm, 241.675 at 780 nm
  const auto radiance = sampled(of_kind(Kind::a), {380, 560, 780});
  CHECK(radiance[0] / radiance[1] == doctest::Approx(0.0979510).epsilon(1e-6));
  CHECK(radiance[2] / radiance[1] == doctest::Approx(2.41675).epsilon(1e-5));
}

TEST_CASE("a line goes to the nearest wavelength") {
  const auto radiance = sampled(of_kind(Kind::line, {589.3}), {560, 580, 600, 620});
  CHECK(radiance[0] == 0);
  CHECK(radiance[1] > 0);
  CHECK(radiance[2] == 0);
  CHECK(error_of(of_kind(Kind::line, {600}), {560, 580}) ==
        "the line lies outside the wavelengths of the scene");
  CHECK(error_of(of_kind(Kind::line, {589.3}), {580}) ==
        "the line lies outside the wavelengths of the scene");
}

TEST_CASE("colours come back, greys are D65") {
  CHECK(rc::check("rgb", [] {
    const auto step_nm = *rc::gen::element(1.0, 5.0, 10.0, 20.0);
    const auto lambda_nm = steps(380, 780, step_nm);
    std::vector<double> rgb(3);
    for (double& c : rgb) c = *rc::gen::inRange(0, 1001) / 1000.0;
    const double scale = *rc::gen::inRange(0, 50) / 10.0;
    const auto radiance = sampled(of_kind(Kind::rgb, rgb, scale), lambda_nm);
    const auto white = linear_srgb(xyz(lambda_nm, sampled(of_kind(Kind::d65), lambda_nm)));
    const auto back = linear_srgb(xyz(lambda_nm, radiance));
    for (int k = 0; k < 3; ++k) RC_ASSERT(std::abs(back[k] - rgb[k] * white[k] * scale) < 1e-9);
    for (const double value : radiance) RC_ASSERT(value >= 0);
  }));
  for (const auto& lambda_nm :
       {steps(380, 780, 20), steps(380, 780, 1), steps(580, 580, 1), steps(450, 650, 100)}) {
    const auto grey = sampled(of_kind(Kind::rgb, {0.4, 0.4, 0.4}), lambda_nm);
    const auto light = sampled(of_kind(Kind::d65, {}, 0.4), lambda_nm);
    for (std::size_t i = 0; i < grey.size(); ++i)
      CHECK(grey[i] == doctest::Approx(light[i]).epsilon(1e-12));
  }
}

TEST_CASE("white on fine grids is white") {
  for (const double step_nm : {1.0, 5.0}) {
    const auto lambda_nm = steps(380, 780, step_nm);
    const auto back =
        linear_srgb(xyz(lambda_nm, sampled(of_kind(Kind::rgb, {1, 1, 1}), lambda_nm)));
    for (int k = 0; k < 3; ++k) CHECK(back[k] == doctest::Approx(1).epsilon(6e-4));
  }
}

TEST_CASE("where there are too few wavelengths for colours their luminance remains") {
  for (const auto& lambda_nm : {steps(580, 580, 1), steps(560, 600, 40), steps(640, 660, 10)}) {
    const auto radiance = sampled(of_kind(Kind::rgb, {1, 0, 0}, 2), lambda_nm);
    CHECK(xyz(lambda_nm, radiance)[1] == doctest::Approx(2 * 0.2126).epsilon(1e-3));
  }
}

TEST_CASE("a black body holds at any temperature") {
  for (const double temperature_k : {300.0, 2000.0, 6500.0, 1e5, 1e8}) {
    const auto radiance = sampled(of_kind(Kind::blackbody, {temperature_k}), steps(380, 780, 20));
    for (const double value : radiance) CHECK(std::isfinite(value));
  }
}

TEST_CASE("lights that cannot be are named") {
  const auto visible = steps(380, 780, 20);
  CHECK(error_of(of_kind(Kind::d65), {900, 910}) ==
        "the light has no visible power at the wavelengths of the scene");
  CHECK(error_of(of_kind(Kind::d65), {}) == "the scene has no wavelengths");
  CHECK(error_of(of_kind(Kind::blackbody, {-3}), visible) == "a temperature must be positive");
  CHECK(error_of(of_kind(Kind::blackbody), visible) == "a black body takes 1 number, 0 given");
  CHECK(error_of(of_kind(Kind::rgb, {1, 2}), visible) == "a colour takes 3 numbers, 2 given");
  CHECK(error_of(of_kind(Kind::rgb, {1, -0.1, 0}), visible) ==
        "a colour of light must not be negative");
  CHECK(error_of(of_kind(Kind::d65, {}, -1), visible) == "a light's strength must be 0 or more");
  SpectrumFormula dark = of_kind(Kind::table);
  dark.points = {{400, 0}, {700, 0}};
  CHECK(error_of(dark, visible) ==
        "the light has no visible power at the wavelengths of the scene");
  dark.points = {{400, 1}, {300, 1}};
  CHECK(error_of(dark, visible) ==
        "point 2 of the table is not at a longer wavelength than the one before");
}
