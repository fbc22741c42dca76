// Spectra, sky, luminous sheets, polarizers.
#include "bound.hpp"
#include "host/optics/colour.hpp"

namespace nicol {

namespace {

const std::string eye = "camera { location -10*z } box { 0, 1 interior { ior 1.5 } }\n";

std::array<double, 3> xyz(const Scene& scene, const Samples& radiance) {
  return Observer(scene.lambda_nm, scene.weight_nm).xyz(radiance.data());
}

Polarizer polygon_polarizer(const std::string& inside, const std::string& modifiers = "") {
  const Bound b = bind_clean("background { rgb 1 }" + eye +
                             "polygon { 5, 0, 2*x, 2*x+z, z, 0 luminous { polarizer { " + inside +
                             " } } " + modifiers + "}");
  return b.scene.polarizers.at(*b.scene.emissions.at(0).polarizer);
}

}  // namespace

TEST_CASE("spectra of scale 1 have Y = 1") {
  for (const char* spectrum : {"d65", "D65", "a", "e", "equal_energy", "blackbody 3000", "line 580",
                               "rgb 1", "table { 300, 1, 900, 2 }", "table 300, 1, 900, 2"}) {
    const Bound b = bind_clean(eye + "background { spectrum { " + spectrum + " } }");
    INFO(spectrum);
    CHECK(xyz(b.scene, b.scene.sky)[1] == doctest::Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("a declared spectrum is scaled where it is used") {
  const Bound b = bind_clean(
      eye + "#declare S = spectrum { d65 scale 2 } background { spectrum { S scale 0.4 } }");
  CHECK(xyz(b.scene, b.scene.sky)[1] == doctest::Approx(0.8));
}

TEST_CASE("sky: background, sky_sphere, nothing") {
  const Bound a = bind_clean(eye + "background { color rgb <0.2, 0.4, 0.6> }");
  const Bound b = bind_clean(eye + "sky_sphere { pigment { rgb <0.2, 0.4, 0.6> } }");
  const auto rgb = linear_srgb(xyz(a.scene, a.scene.sky));
  CHECK(rgb[0] == doctest::Approx(0.2).epsilon(0.02));
  CHECK(rgb[2] == doctest::Approx(0.6).epsilon(0.02));
  CHECK(a.scene.sky == b.scene.sky);
  const Bound black = bind_clean(eye + "background { rgb 0 } disc { 0, y, 1 luminous { } }");
  CHECK(xyz(black.scene, black.scene.sky)[1] == 0);
}

TEST_CASE("a luminous sheet is D65 unless said") {
  const Bound b = bind_clean(
      eye +
      "disc { 0, y, 1 luminous { one_sided } } disc { y, y, 1 luminous { spectrum { d65 } } }");
  REQUIRE(b.scene.emissions.size() == 2);
  CHECK(b.scene.emissions[0].radiance == b.scene.emissions[1].radiance);
  CHECK(b.scene.emissions[0].one_sided);
  CHECK_FALSE(b.scene.emissions[1].one_sided);
}

TEST_CASE("polygon: the angle runs from the first edge towards the last corner") {
  check_near(polygon_polarizer("ideal angle 0").transmission_axis, {1, 0, 0});
  check_near(polygon_polarizer("ideal angle 90").transmission_axis, {0, 0, -1});  // POV-Ray's z
  check_near(polygon_polarizer("ideal angle 30").transmission_axis, {std::sqrt(0.75), 0, -0.5});
  check_near(polygon_polarizer("ideal angle 0", "rotate 90*z").transmission_axis, {0, 1, 0});
}

TEST_CASE(
    "disc: the angle runs from the shape's x, counter-clockwise seen from where the normal "
    "points") {
  const Bound b = bind_clean("background { rgb 1 }" + eye +
                             "disc { 0, y, 1 polarizer { ideal angle 90 } }"
                             "disc { 0, x, 1 polarizer { ideal angle 0 } translate 3*x }");
  check_near(b.scene.polarizers.at(0).normal, {0, 1, 0});
  check_near(b.scene.polarizers[0].transmission_axis, {0, 0, -1});
  check_near(b.scene.polarizers.at(1).normal, {1, 0, 0});
  check_near(b.scene.polarizers[1].transmission_axis, {0, 0, -1});  // the shape's z stands in for x
}

TEST_CASE("axis names the direction that passes, and turns with its sheet") {
  check_near(polygon_polarizer("axis <1, 5, 1>").transmission_axis, normalize(Vec3{1, 0, -1}));
  check_near(polygon_polarizer("axis x", "rotate 90*y").transmission_axis, {0, 0, 1});
}

TEST_CASE("kinds of polarizers") {
  CHECK(polygon_polarizer("angle 0").kind == Polarizer::Kind::ideal);
  CHECK(polygon_polarizer("ideal angle 0 projection absorption").kind ==
        Polarizer::Kind::ideal_absorbing);
  const Polarizer calcite = polygon_polarizer("calcite angle 0");
  CHECK(calcite.kind == Polarizer::Kind::calcite);
  CHECK(calcite.n_o.at(10) == doctest::Approx(1.6584).epsilon(1e-3));  // Ghosh 1999 near 589 nm
  CHECK(calcite.n_e.at(10) == doctest::Approx(1.4864).epsilon(1e-3));
  CHECK(polygon_polarizer("calcite angle 0 index_o { constant 1.7 }").n_o.at(0) == 1.7);
}

TEST_CASE("a declared polarizer can be turned where it is used") {
  const Bound b = bind_clean("background { rgb 1 }" + eye +
                             "#declare P = polarizer { calcite angle 0 }"
                             "disc { 0, y, 1 polarizer { P angle 90 } }");
  CHECK(b.scene.polarizers.at(0).kind == Polarizer::Kind::calcite);
  check_near(b.scene.polarizers[0].transmission_axis, {0, 0, -1});
}

}  // namespace nicol
