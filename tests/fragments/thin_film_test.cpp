// thin_film against Airy's formula, r = (r01 + r12 exp(2 i beta))/(1 + r01 r12 exp(2 i beta)) (Born & Wolf, 7th ed., 1.6.4, eq. 57), seen as
// the sky in the front of a dark block; and that light is kept.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

using Number = std::complex<double>;
constexpr double pi = 3.14159265358979323846;

double airy(double lambda_nm, double sine, double film, double glass, double thickness_nm, bool s) {
  const auto cosine = [sine](double n) { return std::sqrt(Number(1 - sine * sine / (n * n))); };
  const auto face = [&](double a, double b) {
    const Number x = s ? a * cosine(a) : b * cosine(a), y = s ? b * cosine(b) : a * cosine(b);
    return (x - y) / (x + y);
  };
  const Number turn = std::exp(Number(0, 4 * pi / lambda_nm * thickness_nm) * film * cosine(film));
  const Number r01 = face(1, film), r12 = face(film, glass);
  return std::norm((r01 + r12 * turn) / (1.0 + r01 * r12 * turn));
}

// Radiance of the sky in a block's front face, over that of the sky.
double reflected(double angle_deg, const std::string& polarizer, const std::string& film, bool real_double = true) {
  const double a = angle_deg * pi / 180;
  const std::string camera = "camera { orthographic location <0, " + std::to_string(20 * std::sin(a)) + ", " +
                             std::to_string(-20 * std::cos(a)) + "> look_at 0 right x up y " + polarizer + " }";
  const std::string settings = "global_settings { mm_per_unit 1 } background { spectrum { e } } ";
  const std::string block = "box { <-500, -500, 0>, <500, 500, 900> interior { ior 1.52 absorption { constant 0.05 } } " + film + " }";
  return centre(shoot(settings + camera + block, real_double, "550")) /
         centre(shoot(settings + "camera { location -z look_at 0 " + polarizer + " }", real_double, "550"));
}

std::string film(double n, double thickness_nm) {
  return "surface { plugin { \"thin_film\" n " + std::to_string(n) + " thickness_nm " + std::to_string(thickness_nm) + " } }";
}

}  // namespace

TEST_CASE("a quarter wave of magnesium fluoride") {
  const double quarter_nm = 550 / (4 * 1.38);
  const double closed_form = std::pow((1.52 - 1.38 * 1.38) / (1.52 + 1.38 * 1.38), 2);   // 1.26 %
  CHECK(reflected(0, "", film(1.38, quarter_nm)) == doctest::Approx(closed_form).epsilon(1e-5));
  CHECK(reflected(0, "", film(1.38, quarter_nm), false) == doctest::Approx(closed_form).epsilon(1e-4));
  CHECK(reflected(0, "", "") == doctest::Approx(std::pow(0.52 / 2.52, 2)).epsilon(1e-5));
}

TEST_CASE("any film at any angle, s and p") {
  for (const double angle : {20.0, 80.0})
    for (const double n : {1.38, 2.35})
      for (const double thickness : {0.0, 37.0, 400.0}) {
        CAPTURE(angle);
        CAPTURE(n);
        CAPTURE(thickness);
        const double sine = std::sin(angle * pi / 180);
        CHECK(std::fabs(reflected(angle, "polarizer { ideal angle 0 }", film(n, thickness)) - airy(550, sine, n, 1.52, thickness, true)) < 2e-6);
        CHECK(std::fabs(reflected(angle, "polarizer { ideal angle 90 }", film(n, thickness)) - airy(550, sine, n, 1.52, thickness, false)) < 2e-6);
      }
}

TEST_CASE("a coated block in a furnace") {
  const std::string furnace = R"(
    global_settings { mm_per_unit 1 max_trace_level 40 adc_bailout 1e-5 }
    camera { location <3, 5, -20> right x angle 8 look_at <0, 0, 0> }
    background { spectrum { e } }
    box { -1, 1 rotate <20, 30, 0> interior { ior 1.5 } surface { plugin { "thin_film" n 1.9 thickness_nm 130 } } }
  )";
  const Frame frame = shoot(furnace, true, "589");
  const double full = centre(shoot("global_settings { mm_per_unit 1 } camera { location -z look_at 0 } background { spectrum { e } }", true, "589"));
  for (std::size_t i = 0; i < frame.plane(); ++i)
    CHECK(frame.component(0, 0)[i] / full + frame.cut_off[i] == doctest::Approx(1).epsilon(1e-6));
}
