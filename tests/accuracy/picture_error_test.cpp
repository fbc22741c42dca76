// Measures of a picture's error on pictures made by hand, and the spectral step on known spectra.
#include "host/accuracy/picture_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "host/accuracy/colour_difference.hpp"
#include "host/optics/colour.hpp"

namespace {

using nicol::Frame;

Frame make_frame(int width, int height, std::vector<double> lambda_nm,
                 const std::function<double(int, double, std::size_t)>& stokes) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.weight_nm = nicol::wavelength_weights(lambda_nm);
  frame.lambda_nm = std::move(lambda_nm);
  frame.stokes.resize(4 * frame.lambda_nm.size() * frame.plane());
  frame.row_done.assign(static_cast<std::size_t>(height), 1);
  frame.rows_done = height;
  for (int s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i)
      for (std::size_t p = 0; p < frame.plane(); ++p)
        frame.component(s, i)[p] = static_cast<float>(stokes(s, frame.lambda_nm[i], p));
  return frame;
}

std::vector<double> grid(double from, double to, double step) {
  std::vector<double> lambda_nm;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) lambda_nm.push_back(from + i * step);
  return lambda_nm;
}

double flat(int s, double, std::size_t) { return s == 0 ? 2 : 0; }

}  // namespace

TEST_CASE("a picture has no error against itself") {
  const Frame frame = make_frame(3, 2, grid(400, 700, 10), flat);
  const auto error = nicol::picture_error(frame, frame);
  CHECK(error.rms() == 0);
  CHECK(error.stokes_max == 0);
  CHECK(error.xyz_max == 0);
  CHECK(error.ciede_worst == 0);
  CHECK(error.pixels == 6);
  CHECK(error.wavelengths == 31);
}

TEST_CASE("one wrong Stokes component counts by its length, over pixels and wavelengths") {
  const Frame reference = make_frame(2, 2, grid(500, 560, 20), flat);
  Frame picture = reference;
  picture.component(3, 1)[2] = 0.5f;  // one of 4 pixels, one of 4 wavelengths, S0 = 2
  const auto error = nicol::picture_error(picture, reference);
  CHECK(error.stokes_max == doctest::Approx(0.25));
  CHECK(error.stokes_rms == doctest::Approx(0.25 / 4));
  CHECK(error.xyz_rms == 0);
  CHECK(error.rms() == doctest::Approx(0.25 / 4));
  picture.component(2, 1)[2] = 0.5f;
  CHECK(nicol::picture_error(picture, reference).stokes_max == doctest::Approx(0.25 * std::sqrt(2)));
}

TEST_CASE("a brighter picture: XYZ all three relative to Y, CIEDE2000 at the exposure") {
  Frame reference = make_frame(2, 1, grid(380, 780, 5), [](int s, double, std::size_t) { return s == 0 ? 0.004 : 0; });
  const Frame picture =
      make_frame(2, 1, grid(380, 780, 5),
                 [](int s, double, std::size_t p) { return s == 0 ? (p == 0 ? 0.0044 : 0.004) : 0; });
  reference.exposure = 3;
  const auto xyz = nicol::Observer(reference.lambda_nm, reference.weight_nm).xyz(reference.component(0, 0), 2);
  const double length = std::sqrt(xyz[0] * xyz[0] + xyz[1] * xyz[1] + xyz[2] * xyz[2]);
  const auto error = nicol::picture_error(picture, reference);
  CHECK(error.xyz_max == doctest::Approx(0.1 * length / xyz[1]).epsilon(1e-5));
  CHECK(error.xyz_rms == doctest::Approx(0.1 * length / xyz[1] / std::sqrt(2)).epsilon(1e-5));
  CHECK(error.stokes_max == doctest::Approx(0.1).epsilon(1e-5));
  CHECK(error.rms() == error.xyz_rms);
  const auto lab = [&](double factor) {
    return nicol::lab_of_xyz({xyz[0] * factor, xyz[1] * factor, xyz[2] * factor});
  };
  const double difference = nicol::ciede2000(lab(3.3), lab(3));
  CHECK(error.ciede_worst == doctest::Approx(difference).epsilon(1e-4));
  CHECK(error.ciede_95 == error.ciede_worst);
  CHECK(error.ciede_mean == doctest::Approx(difference / 2).epsilon(1e-4));
}

TEST_CASE("95 % of the pixels stay below ciede_95") {
  const auto lambda_nm = grid(400, 700, 20);
  const Frame reference = make_frame(100, 1, lambda_nm, flat);
  const auto picture = [&](std::size_t wrong) {
    return make_frame(100, 1, lambda_nm,
                      [=](int s, double, std::size_t p) { return s != 0 ? 0 : p < wrong ? 1.0 : 2.0; });
  };
  CHECK(nicol::picture_error(picture(5), reference).ciede_95 == 0);
  CHECK(nicol::picture_error(picture(6), reference).ciede_95 > 1);
  CHECK(nicol::picture_error(picture(5), reference).ciede_worst > 1);
}

TEST_CASE("other wavelengths: Stokes where both have one, XYZ by all") {
  const auto slope = [](int s, double lambda_nm, std::size_t) { return s == 0 ? lambda_nm / 500 : 0; };
  const Frame coarse = make_frame(1, 1, grid(380, 780, 20), slope), fine = make_frame(1, 1, grid(380, 780, 5), slope);
  const auto error = nicol::picture_error(coarse, fine);
  CHECK(error.wavelengths == 21);
  CHECK(error.stokes_rms == 0);
  CHECK(error.xyz_rms > 1e-5);
  CHECK(error.xyz_rms < 1e-2);
  const Frame apart = make_frame(1, 1, grid(385, 780, 20), slope);
  CHECK(nicol::picture_error(apart, fine).wavelengths == 20);
  CHECK(nicol::picture_error(apart, coarse).wavelengths == 0);
  CHECK(nicol::picture_error(apart, coarse).rms() > 0);
}

TEST_CASE("rows that one of the pictures lacks do not count") {
  const Frame reference = make_frame(2, 3, grid(500, 540, 20), flat);
  Frame picture = reference;
  picture.row_done = {1, 0, 1};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t p = 2; p < 4; ++p) picture.component(0, i)[p] = 0;
  CHECK(nicol::picture_error(picture, reference).rms() == 0);
  CHECK(nicol::picture_error(picture, reference).pixels == 4);
  picture.row_done = {1, 1, 1};
  CHECK(nicol::picture_error(picture, reference).stokes_rms == doctest::Approx(std::sqrt(1.0 / 3)));
}

TEST_CASE("what is not a number shows, black is no division by zero, sizes must fit") {
  const auto black = [](int, double, std::size_t) { return 0.0; };
  const Frame dark = make_frame(2, 1, grid(500, 540, 20), black), light = make_frame(2, 1, grid(500, 540, 20), flat);
  CHECK(nicol::picture_error(dark, dark).rms() == 0);
  CHECK(std::isinf(nicol::picture_error(light, dark).rms()));
  Frame broken = light;
  broken.component(0, 0)[0] = NAN;
  CHECK(std::isnan(nicol::picture_error(broken, light).rms()));
  CHECK(std::isnan(nicol::picture_error(broken, light).ciede_mean));
  CHECK_THROWS_AS(nicol::picture_error(make_frame(1, 2, {500}, flat), make_frame(2, 1, {500}, flat)),
                  std::invalid_argument);
}

TEST_CASE("the spectral step of a smooth spectrum is estimated to its order") {
  // The window ends where the observer sees: the error of the trapezoid rule is h^2/12 [f'] to leading order.
  const auto bump = [](int s, double lambda_nm, std::size_t) {
    return s == 0 ? 0.01 * (1 + std::cos((lambda_nm - 380) / 60)) : 0;
  };
  const auto true_error = [&](double step_nm) {
    return nicol::picture_error(make_frame(1, 1, grid(440, 660, step_nm), bump),
                                make_frame(1, 1, grid(440, 660, 0.5), bump))
        .xyz_rms;
  };
  for (const double step_nm : {5.0, 10.0}) {
    const auto step = nicol::spectral_step(make_frame(1, 1, grid(440, 660, step_nm), bump));
    REQUIRE(step.known);
    CAPTURE(step_nm);
    CHECK(step.order > 1.9);
    CHECK(step.xyz_rms == doctest::Approx(true_error(step_nm)).epsilon(0.1));
    CHECK(step.xyz_max == step.xyz_rms);
    CHECK(step.ciede_mean == step.ciede_worst);
    CHECK(step.ciede_mean > 0);
  }
}

TEST_CASE("spectra with a step somewhere: the error goes as the step of wavelength") {
  const auto edge = [](int s, double lambda_nm, std::size_t p) {
    return s == 0 && lambda_nm > 470 + 0.37 * static_cast<double>(p) ? 0.01 : 0;
  };
  const auto made = [&](double step_nm) { return make_frame(400, 1, grid(440, 680, step_nm), edge); };
  for (const double step_nm : {5.0, 10.0}) {
    const auto step = nicol::spectral_step(made(step_nm));
    const double error = nicol::picture_error(made(step_nm), made(0.25)).xyz_rms;
    CAPTURE(step_nm);
    CHECK(step.order < 1.2);
    CHECK(step.xyz_rms > error);
    CHECK(step.xyz_rms < 3 * error);
  }
}

TEST_CASE("an even number of wavelengths keeps its last one") {
  const auto bump = [](int s, double lambda_nm, std::size_t) {
    return s == 0 ? 0.01 * (1 + std::cos(lambda_nm / 40)) : 0;
  };
  const auto even = nicol::spectral_step(make_frame(1, 1, grid(380, 775, 5), bump));
  const auto odd = nicol::spectral_step(make_frame(1, 1, grid(380, 780, 5), bump));
  REQUIRE(even.known);
  CHECK(even.xyz_rms == doctest::Approx(odd.xyz_rms).epsilon(0.2));
}

TEST_CASE("a spectral step is not known for one or two wavelengths, nor for lines") {
  CHECK(nicol::spectral_step(make_frame(1, 1, {589.3}, flat)).reason == "1 wavelength");
  CHECK(nicol::spectral_step(make_frame(1, 1, {486.1, 656.3}, flat)).reason == "2 wavelengths");
  const auto lines = nicol::spectral_step(make_frame(1, 1, {486.1, 589.3, 656.3}, flat));
  CHECK_FALSE(lines.known);
  CHECK(lines.reason == "the wavelengths are not equally spaced");
  CHECK(nicol::spectral_step(make_frame(1, 1, {480, 570, 660}, flat)).known);
}
