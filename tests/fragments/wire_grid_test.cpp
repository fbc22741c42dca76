// wire_grid at normal incidence against the same physics written another way: the grid's modes by the secant method on tan itself, and an
// isotropic layer of that index by its characteristic matrix (Born & Wolf, 1.6); that it is passive and reciprocal in both precisions; and that
// it polarizes as such grids do.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

using Number = std::complex<double>;
constexpr double pi = 3.14159265358979323846;

// Rakic et al., Appl. Opt. 37, 5271 (1998), table 2.
Number aluminium(double lambda_nm) {
  const double e = 1239.841984 / lambda_nm, wp = 14.98;
  const double table[5][3] = {{0.523, 0, 0.047}, {0.227, 0.162, 0.333}, {0.050, 1.544, 0.312}, {0.166, 1.808, 1.351}, {0.030, 3.473, 3.382}};
  Number eps = 1;
  for (const auto& row : table) eps += row[0] * wp * wp / Number(row[1] * row[1] - e * e, -e * row[2]);
  return eps;
}

// Rytov's equation for N^2; zero at a mode.
Number rytov(Number mode, double k0, Number eps_m, double gap, double width, bool across) {
  const Number a_d = k0 * std::sqrt(1.0 - mode), a_m = k0 * std::sqrt(eps_m - mode);
  return a_d * std::tan(a_d * gap / 2.0) + (across ? 1.0 / eps_m : 1.0) * a_m * std::tan(a_m * width / 2.0);
}

Number mode_of(double lambda_nm, double period, double width, bool across) {
  const double k0 = 2 * pi / lambda_nm, gap = period - width;
  const Number eps_m = aluminium(lambda_nm);
  Number x0 = across ? Number(1.3, 0.05) : Number(1 - std::pow(lambda_nm / (2 * gap + 60), 2), 0.5), x1 = x0 * Number(1.01, 0.001);
  for (int i = 0; i < 60; ++i) {
    const Number f0 = rytov(x0, k0, eps_m, gap, width, across), f1 = rytov(x1, k0, eps_m, gap, width, across);
    if (std::abs(f1 - f0) == 0) break;
    const Number x2 = x1 - f1 * (x1 - x0) / (f1 - f0);
    x0 = x1;
    x1 = x2;
  }
  return x1;
}

struct Layer {
  double t, r;
};
Layer layer(Number eps, double lambda_nm, double height) {
  const Number n = std::sqrt(eps), beta = 2 * pi / lambda_nm * height * n;
  const Number b = std::cos(beta) - Number(0, 1) * std::sin(beta) / n, c = std::cos(beta) - Number(0, 1) * n * std::sin(beta);
  return {std::norm(2.0 / (b + c)), std::norm((b - c) / (b + c))};
}

const std::string settings = "global_settings { mm_per_unit 1 max_trace_level 10 adc_bailout 1e-12 } background { spectrum { e } } ";

// Share of the sky's light in the polarization `angle` that gets through a grid on the camera.
double passed(double angle, const std::string& grid, const std::string& lambda) {
  const std::string camera = "camera { orthographic location -10*z look_at 0 right x up y polarizer { ideal angle " + std::to_string(angle) + " } }";
  const std::string sheet = "disc { 0, -z, 5 polarizer { " + grid + " angle 0 } }";
  const std::string light = "disc { 2*z, -z, 9 luminous { spectrum { e } } } ";
  const std::string dark = "global_settings { mm_per_unit 1 max_trace_level 10 adc_bailout 1e-12 } ";
  return centre(shoot(dark + camera + light + sheet, true, lambda)) / centre(shoot(dark + camera + light, true, lambda));
}

}  // namespace

TEST_CASE("aluminium is Rakic's") {
  // refractiveindex.info, Al, Rakic 1998: LD, at 550.33 and 632.8 nm (there 0.96708, 6.4617; between 1.3198, 7.2578 and 1.3441, 7.3089)
  const Number green = std::sqrt(aluminium(550.33)), red = std::sqrt(aluminium(632.8));
  CHECK(green.real() == doctest::Approx(0.96708).epsilon(1e-4));
  CHECK(green.imag() == doctest::Approx(6.4617).epsilon(1e-4));
  CHECK(red.real() > 1.3198);
  CHECK(red.imag() < 7.3089);
}

TEST_CASE("a grid at normal incidence") {
  for (const double lambda : {420.0, 550.0, 700.0}) {
    CAPTURE(lambda);
    const std::string grid = "plugin { \"wire_grid\" period 140 width 60 height 180 }";
    const Layer across = layer(mode_of(lambda, 140, 60, true), lambda, 180), along = layer(mode_of(lambda, 140, 60, false), lambda, 180);
    CHECK(passed(0, grid, std::to_string(lambda)) == doctest::Approx(across.t).epsilon(1e-5));
    CHECK(passed(90, grid, std::to_string(lambda)) == doctest::Approx(along.t).epsilon(1e-4));
    CHECK(across.t > 0.85);                  // such grids on glass: 80 to 90 %
    CHECK(across.t / along.t > 1000);
    CHECK(along.r > 0.85);
  }
}

TEST_CASE("the grid throws back what it does not pass") {
  // seen from the front under 45 degrees, wires upright: nearly all light of that field comes back
  const std::string scene = R"(
    camera { orthographic location <-10, 0, -10> look_at 0 right x up y polarizer { ideal angle 90 } }
    disc { <-9, 0, 0.5>, <0, 0, 1>, 0.1 luminous { spectrum { e } } }
    disc { 0, -z, 5 polarizer { plugin { "wire_grid" } angle 0 } }
  )";
  const double all = centre(shoot(settings + "camera { location -z look_at 0 polarizer { ideal angle 90 } }"));
  const double back_and_through = centre(shoot(settings + scene)) / all;
  CHECK(back_and_through < 1);
  CHECK(back_and_through > 0.85);
}

TEST_CASE("the shipped fragments pass their own checks without a warning") {
  for (const bool real_double : {true, false})
    for (const char* grid : {"plugin { \"wire_grid\" }", "plugin { \"wire_grid\" period 100 width 50 height 140 }",
                             "plugin { \"wire_grid\" period 180 width 40 height 60 }"}) {
      CAPTURE(grid);
      const Read scene = read(settings + "disc { 0, -z, 5 polarizer { " + grid + " angle 0 } }", "400:780:20");
      REQUIRE_MESSAGE(scene.loaded, scene.errors);
      KernelOptions options;
      options.real_double = real_double;
      CHECK(check_fragments(*open_device(""), *scene.loaded->features.fragments, options) == "");
    }
}
