// The CIE observer and linear sRGB against published values.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "host/optics/colour.hpp"
#include "host/optics/media.hpp"

using namespace nicol;

namespace {

std::vector<double> steps(double first_nm, double last_nm, double step_nm) {
  std::vector<double> lambda_nm;
  for (double l = first_nm; l <= last_nm + 1e-9; l += step_nm) lambda_nm.push_back(l);
  return lambda_nm;
}

SpectrumFormula of_kind(SpectrumFormula::Kind kind, std::vector<double> numbers = {}) {
  SpectrumFormula formula;
  formula.kind = kind;
  formula.numbers = std::move(numbers);
  return formula;
}

std::array<double, 3> xyz_of(const SpectrumFormula& formula, const std::vector<double>& lambda_nm) {
  const auto weight_nm = wavelength_weights(lambda_nm);
  std::string error;
  const auto radiance = sample_spectrum(formula, lambda_nm, weight_nm, error);
  REQUIRE(error == "");
  return Observer(lambda_nm, weight_nm).xyz(radiance.data());
}

void check_close(const std::array<double, 3>& value, const std::array<double, 3>& wanted,
                 double tolerance) {
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    CAPTURE(value[k]);
    CHECK(std::abs(value[k] - wanted[k]) <= tolerance);
  }
}

// XYZ of D65 through parallel polarizers with right quartz's rotation between, 380..780 nm.
std::array<double, 3> xyz_of_turned_light(double path_mm, double step_nm) {
  const auto lambda_nm = steps(380, 780, step_nm);
  const auto weight_nm = wavelength_weights(lambda_nm);
  std::string error;
  auto radiance = sample_spectrum(of_kind(SpectrumFormula::Kind::d65), lambda_nm, weight_nm, error);
  RotationFormula quartz;
  quartz.kind = RotationFormula::Kind::chandrasekhar;
  quartz.coefficients = {7.19, 0.0926283};
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double turn_rad =
        rotation_deg_per_mm(quartz, lambda_nm[i]) * path_mm * std::acos(-1.0) / 180;
    radiance[i] *= std::cos(turn_rad) * std::cos(turn_rad);
  }
  return Observer(lambda_nm, weight_nm).xyz(radiance.data());
}

}  // namespace

TEST_CASE("colour matching functions") {  // CIE 018:2019
  check_close(colour_matching(555), {0.5120501, 1, 0.005749999}, 1e-12);
  check_close(colour_matching(450), {0.3362, 0.038, 1.77211}, 1e-12);
  check_close(colour_matching(600), {1.0622, 0.631, 0.0008}, 1e-12);
  check_close(colour_matching(830), {1.251141e-6, 4.5181e-7, 0}, 1e-15);
  const auto low = colour_matching(500), high = colour_matching(501),
             middle = colour_matching(500.5);
  for (int k = 0; k < 3; ++k)
    CHECK(middle[k] == doctest::Approx((low[k] + high[k]) / 2).epsilon(1e-12));
  check_close(colour_matching(359.9), {0, 0, 0}, 0);
  check_close(colour_matching(830.1), {0, 0, 0}, 0);
}

TEST_CASE("the three functions have the same area") {  // equal energy is white
  double sum[3] = {};
  for (int l = 360; l <= 830; ++l)
    for (int k = 0; k < 3; ++k) sum[k] += colour_matching(l)[k];
  CHECK(sum[1] == doctest::Approx(106.857).epsilon(1e-5));
  CHECK(sum[0] == doctest::Approx(sum[1]).epsilon(2e-4));
  CHECK(sum[2] == doctest::Approx(sum[1]).epsilon(4e-4));
}

TEST_CASE("white points") {  // CIE 015:2018, table of tristimulus values of illuminants
  const auto visible = steps(360, 830, 1);
  check_close(xyz_of(of_kind(SpectrumFormula::Kind::d65), visible), {0.95047, 1, 1.08883}, 2e-5);
  check_close(xyz_of(of_kind(SpectrumFormula::Kind::a), visible), {1.09850, 1, 0.35585}, 2e-5);
  check_close(xyz_of(of_kind(SpectrumFormula::Kind::e), visible), {1.00003, 1, 1.00033}, 1e-4);
  // the reference of the interference colours, 380..780 nm by 1 nm
  check_close(xyz_of(of_kind(SpectrumFormula::Kind::d65), steps(380, 780, 1)),
              {0.950422817629464, 1, 1.0886100924096642}, 2e-5);
}

TEST_CASE("a black body of 2856 K is illuminant A") {  // CIE 015:2018: 2848 K with the older c2
  const auto visible = steps(360, 830, 5);
  check_close(xyz_of(of_kind(SpectrumFormula::Kind::blackbody, {2855.5}), visible),
              xyz_of(of_kind(SpectrumFormula::Kind::a), visible), 1e-4);
  const auto xyz =
      xyz_of(of_kind(SpectrumFormula::Kind::blackbody, {6500}), visible);  // on the Planckian locus
  CHECK(xyz[0] / (xyz[0] + xyz[1] + xyz[2]) == doctest::Approx(0.3135).epsilon(3e-4));
  CHECK(xyz[1] / (xyz[0] + xyz[1] + xyz[2]) == doctest::Approx(0.3237).epsilon(3e-4));
}

TEST_CASE("linear sRGB") {  // IEC 61966-2-1:1999, equations 6 to 9
  check_close(linear_srgb({1, 0, 0}), {3.2406, -0.9689, 0.0557}, 5e-4);
  check_close(linear_srgb({0, 1, 0}), {-1.5372, 1.8758, -0.2040}, 5e-4);
  check_close(linear_srgb({0, 0, 1}), {-0.4986, 0.0415, 1.0570}, 5e-4);
  check_close(xyz_of_linear_srgb({1, 1, 1}), {0.95046, 1, 1.08906}, 1e-5);
  CHECK(srgb_encode(0.0031308) == doctest::Approx(0.04045).epsilon(1e-4));
  CHECK(srgb_encode(0.5) == doctest::Approx(0.735357).epsilon(1e-6));
  CHECK(srgb_encode(1) == doctest::Approx(1).epsilon(1e-15));
  CHECK(srgb_encode(-0.1) == 0);
  CHECK(srgb_encode(2) == doctest::Approx(1).epsilon(1e-15));
  CHECK(rc::check("linear sRGB and back", [] {
    std::array<double, 3> rgb{};
    for (double& c : rgb) c = *rc::gen::inRange(-1000, 1000) / 500.0;
    const auto back = linear_srgb(xyz_of_linear_srgb(rgb));
    for (int k = 0; k < 3; ++k) RC_ASSERT(std::abs(back[k] - rgb[k]) < 1e-12);
  }));
}

TEST_CASE("the observer reads floats with a stride") {
  const std::vector<double> lambda_nm{450, 550, 650}, weight_nm{1, 2, 3}, radiance{0.5, 0.25, 2};
  const std::vector<float> planes{0.5f, 9, 0.25f, 9, 2, 9};
  const Observer observer(lambda_nm, weight_nm);
  check_close(observer.xyz(planes.data(), 2), observer.xyz(radiance.data()), 1e-12);
}

TEST_CASE("weights of wavelengths add up to their range") {
  CHECK(wavelength_weights({}) == std::vector<double>{});
  CHECK(wavelength_weights({580}) == std::vector<double>{1});
  CHECK(wavelength_weights({400, 420, 460}) == std::vector<double>{10, 30, 20});
}

// Kozlov & Debelov 2014, figures 5 and 6: colours along the axis of the cube, parallel polarizers.
// XYZ is over Y of D65. The colours (0.89, 0.73, 0.71) and (1.04, 0.84, 0.63) are encoded sRGB.
// Steps of 20 nm, as the paper took them, are off by up to 0.005.
TEST_CASE("rotatory dispersion makes the cube of 16 mm reddish, that of 8 mm yellowish") {
  check_close(xyz_of_turned_light(16, 5), {0.572, 0.544, 0.512}, 5e-4);
  check_close(xyz_of_turned_light(8, 5), {0.757, 0.740, 0.438}, 5e-4);
  check_close(xyz_of_turned_light(16, 20), {0.5758, 0.5468, 0.5134}, 1e-4);
  check_close(xyz_of_turned_light(8, 20), {0.7617, 0.7403, 0.4417}, 1e-4);
  check_close(xyz_of_turned_light(0, 20),
              xyz_of(of_kind(SpectrumFormula::Kind::d65), steps(380, 780, 20)), 1e-12);
  const auto reddish = linear_srgb(xyz_of_turned_light(16, 5));
  check_close({srgb_encode(reddish[0]), srgb_encode(reddish[1]), srgb_encode(reddish[2])},
              {0.89, 0.73, 0.71}, 5e-3);
  const auto yellowish = linear_srgb(xyz_of_turned_light(8, 5));
  CHECK(1.055 * std::pow(yellowish[0], 1 / 2.4) - 0.055 ==
        doctest::Approx(1.04).epsilon(5e-3));  // out of gamut
  CHECK(srgb_encode(yellowish[1]) == doctest::Approx(0.84).epsilon(6e-3));
  CHECK(srgb_encode(yellowish[2]) == doctest::Approx(0.63).epsilon(8e-3));
}
