// interior { }: index, rotation, absorption, surroundings.
#include "bound.hpp"

namespace nicol {

namespace {

const std::string at_580 = "global_settings { wavelengths { 580 } }\n" + lit;

Medium medium(const std::string& interior, const std::string& before = at_580) {
  const Bound b = bind_clean(before + "box { 0, 1 interior { " + interior + " } }");
  REQUIRE(b.scene.media.size() == 2);
  return b.scene.media[1];
}

// Mean of quartz's indices at 580 nm by Ghosh 1999, worked out apart: (1.544582 + 1.553708)/2.
constexpr double n_mean_580 = 1.549145;

}  // namespace

TEST_CASE("index: every formula gives its n") {
  CHECK(medium("ior 1.5").n[0][0] == 1.5);
  CHECK(medium("index { constant 1.6 }").n[0][0] == 1.6);
  CHECK(medium("index { cauchy 1.5, 0.0046 }").n[0][0] == doctest::Approx(1.5 + 0.0046 / 0.3364));
  CHECK(medium("index { sellmeier 1, 0.01 }").n[0][0] ==
        doctest::Approx(std::sqrt(1 + 0.3364 / 0.3264)));
  CHECK(medium("index { table { 500, 1.52, 600, 1.50 } }").n[0][0] == doctest::Approx(1.504));
  CHECK(medium("index { table 500, 1.52, 600, 1.50 }").n[0][0] == doctest::Approx(1.504));
  CHECK(medium("index { mean index { constant 1.4 } index { constant 1.6 } }").n[0][0] ==
        doctest::Approx(1.5));
  CHECK(
      medium(
          "index { mean index { formula 2, 0.28604141, 1.07044083, 1.00585997e-2, 1.10202242, 100 }"
          " index { formula 2, 0.28851804, 1.09509924, 1.02101864e-2, 1.15662475, 100 } }")
          .n[0][0] == doctest::Approx(n_mean_580).epsilon(1e-5));
}

TEST_CASE("index: POV-Ray's ior and dispersion, n = ior D^(-(l - 555)/350)") {
  CHECK(medium("ior 1.5 dispersion 1.02").n[0][0] ==
        doctest::Approx(1.5 * std::pow(1.02, -25.0 / 350)));
  CHECK(medium("dispersion 1.02 ior 1.5").n[0][0] ==
        doctest::Approx(1.5 * std::pow(1.02, -25.0 / 350)));
}

TEST_CASE("index: a declared one stands for its contents, a later word wins") {
  const std::string declared = at_580 + "#declare I = index { constant 1.7 } ";
  CHECK(medium("index { I }", declared).n[0][0] == 1.7);
  CHECK(medium("ior 1.5 index { I }", declared).n[0][0] == 1.7);
  CHECK(medium("index { I } ior 1.5", declared).n[0][0] == 1.5);
}

TEST_CASE("interior: a declared one can be changed") {
  const std::string declared =
      at_580 + "#declare Q = interior { ior 1.54 rotation { constant 20 } } ";
  const Medium m = medium("Q rotation { constant 5 left }", declared);
  CHECK(m.n[0][0] == 1.54);
  CHECK(m.rotation_deg_per_mm[0] == -5);
}

TEST_CASE("rotation: every formula, its scale and its hand") {
  const auto turn = [](const std::string& r) {
    return medium("ior 1.5 rotation { " + r + " }").rotation_deg_per_mm[0];
  };
  CHECK(medium("ior 1.5").rotation_deg_per_mm[0] == 0);
  CHECK(turn("constant 3") == 3);
  CHECK(turn("biot 7") == doctest::Approx(7 / 0.3364));
  CHECK(turn("drude 7, 0.01") == doctest::Approx(7 / 0.3264));
  CHECK(turn("chandrasekhar 7.19, 0.0926283 scale 75") * 16 ==
        doctest::Approx(27008.17).epsilon(1e-6));
  CHECK(turn("chandrasekhar 7.19, 0.0926283 scale 2 left") < 0);
  CHECK(turn("table { 500, 10, 600, 20 }") == doctest::Approx(18));
}

TEST_CASE("absorption becomes the extinction coefficient: k = a lambda / (4 pi)") {
  const double pi = 3.14159265358979323846;
  CHECK(medium("ior 1.5").k[0][0] == 0);
  CHECK(medium("ior 1.5 absorption { constant 2 }").k[0][0] == doctest::Approx(2 * 580e-6 / (4 * pi)));
  CHECK(medium("ior 1.5 absorption { table { 400, 1, 700, 4 } }").k[0][0] > 580e-6 / (4 * pi));
  CHECK(medium("ior 1.5 extinction { constant 1e-4 }").k[0][0] == doctest::Approx(1e-4));
}

TEST_CASE("interior: the rest of its words") {
  const Medium m = medium("ior 1.5 name \"glass\" source \"a catalogue\"");
  CHECK(m.name == "glass");
  CHECK(m.source == "a catalogue");
}

TEST_CASE("surroundings are vacuum unless said") {
  CHECK(bind_clean(at_580 + "box { 0, 1" + glass + "}").scene.media[0].n[0][0] == 1);
  const Bound b =
      bind_clean(at_580 + "surroundings { interior { ior 1.33 } } box { 0, 1" + glass + "}");
  CHECK(b.scene.media[0].n[0][0] == 1.33);
}

TEST_CASE("wavelengths outside a table are named") {
  const Bound b =
      bind_text(lit + "box { 0, 1 interior { index { table { 500, 1.5, 600, 1.5 } } } }");
  CHECK(b.text().find("'index' has no value at 380 nm and 14 more") != std::string::npos);
}

}  // namespace nicol
