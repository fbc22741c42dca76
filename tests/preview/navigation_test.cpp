// Camera and polarizers turned by hand: where points of the scene go in the picture, and what stays.
#include <doctest/doctest.h>

#include <cmath>

#include "bound_scene.hpp"
#include "camera_view.hpp"
#include "host/preview/navigation.hpp"

namespace nicol::preview {
namespace {

constexpr double pi = 3.14159265358979323846;

Navigation turned_by(double yaw_rad, double pitch_rad) {
  Navigation n;
  n.yaw_rad = yaw_rad;
  n.pitch_rad = pitch_rad;
  return n;
}

void check_near(Vec3 a, Vec3 b, double tolerance = 1e-12) {
  INFO("<", a.x, ",", a.y, ",", a.z, "> against <", b.x, ",", b.y, ",", b.z, ">");
  CHECK(length(a - b) <= tolerance);
}

void check_same(const Camera& a, const Camera& b, double tolerance) {
  check_near(a.location, b.location, tolerance * length(b.location));
  check_near(a.direction, b.direction, tolerance * length(b.direction));
  check_near(a.right, b.right, tolerance * length(b.right));
  check_near(a.up, b.up, tolerance * length(b.up));
}

const std::string settings = "global_settings { mm_per_unit 1 } background { rgb 1 }\n";
const std::string cube = "box { -1, 1 interior { ior 1.5 } }\n";
const std::string tilted = "camera { location <3, 5, -8> look_at 0 right 1.5*x angle 40 ";

const char* const kinds[] = {"}", "orthographic }", "right -1.5*x }", "orthographic right -1.5*x }"};

}  // namespace

TEST_CASE("navigation: the pivot lies on the camera's axis beside the solids") {
  const Loaded s = load(settings + "camera { location <0.5, 0, -10> } box { -1, <1, 1, 3> interior { ior 1.5 } }");
  check_near(pivot_of(s.scene, s.geometry), {0.5, 0, -1});
  // Behind the camera: ahead of it, as far as the middle is.
  const Loaded behind = load(settings + "camera { location <0, 0, 10> } " + cube);
  check_near(pivot_of(behind.scene, behind.geometry), {0, 0, -20});
  // In the middle.
  const Loaded inside = load(settings + "camera { location 0 } " + cube);
  const Vec3 pivot = pivot_of(inside.scene, inside.geometry);
  CHECK(dot(pivot, inside.scene.camera.direction) > 0);
  // No solids.
  const Loaded sheets = load(settings + "camera { location -6*z } disc { z, z, 1 luminous { spectrum { d65 } } }");
  check_near(pivot_of(sheets.scene, sheets.geometry), {0, 0, -1});
  const Loaded empty = load(settings + "camera { location -6*z }");
  CHECK(dot(pivot_of(empty.scene, empty.geometry) - empty.scene.camera.location, empty.scene.camera.direction) > 0);
}

TEST_CASE("navigation: what the mouse has not touched is as the scene says, bit for bit") {
  const Loaded s = load(settings + tilted + "polarizer { calcite angle 30 } }" + cube);
  Geometry geometry = s.geometry;
  const Scene seen = navigate(s.scene, geometry, {}, Analyzer::as_scene, 0, 0);
  CHECK(seen.camera.location.x == s.scene.camera.location.x);
  CHECK(seen.camera.up.z == s.scene.camera.up.z);
  check_near(seen.polarizers[0].transmission_axis, s.scene.polarizers[0].transmission_axis, 1e-15);
}

TEST_CASE("navigation: content follows the mouse, in mirrored pictures too") {
  for (const char* kind : kinds) {
    INFO(kind);
    const Loaded s = load(settings + tilted + kind + cube);
    const Camera& base = s.scene.camera;
    const Vec3 pivot = pivot_of(s.scene, s.geometry);
    const Vec3 near = pivot - normalize(base.direction);  // on the side of the camera
    const auto shown = [&](const Navigation& n) { return place_in_picture(moved(base, n, pivot), near); };
    CHECK(shown({})[0] == doctest::Approx(0));
    CHECK(shown(turned_by(0.1, 0))[0] > 0.01);
    CHECK(shown(turned_by(0.1, 0))[1] == doctest::Approx(0));
    CHECK(shown(turned_by(0, 0.1))[1] > 0.01);
    CHECK(shown(turned_by(0, 0.1))[0] == doctest::Approx(0));
    Navigation pan;
    pan.pan_right = 0.25;
    pan.pan_up = -0.5;
    const auto place = place_in_picture(moved(base, pan, pivot), pivot);
    CHECK(place[0] == doctest::Approx(0.25));
    CHECK(place[1] == doctest::Approx(-0.5));
    // Panned, it turns about where the pivot is seen.
    pan.yaw_rad = 0.7;
    pan.pitch_rad = -0.3;
    pan.zoom = 1.5;
    CHECK(place_in_picture(moved(base, pan, pivot), pivot)[0] == doctest::Approx(0.25));
    CHECK(place_in_picture(moved(base, pan, pivot), pivot)[1] == doctest::Approx(-0.5));
  }
}

TEST_CASE("navigation: orbits keep distance, shape and handedness, and come back") {
  for (const char* kind : kinds) {
    INFO(kind);
    const Loaded s = load(settings + tilted + kind + cube);
    const Camera& base = s.scene.camera;
    const Vec3 pivot = pivot_of(s.scene, s.geometry);
    for (const Navigation& n : {turned_by(1, 0.5), turned_by(-2.5, 1.4), turned_by(0.2, -3)}) {
      const Camera c = moved(base, n, pivot);
      CHECK(length(c.location - pivot) == doctest::Approx(length(base.location - pivot)).epsilon(1e-13));
      CHECK(length(c.right) == doctest::Approx(length(base.right)).epsilon(1e-13));
      CHECK(dot(c.right, c.up) == doctest::Approx(dot(base.right, base.up)).epsilon(1e-12));
      CHECK(dot(c.direction, c.up) == doctest::Approx(dot(base.direction, base.up)).epsilon(1e-12));
      CHECK(dot(cross(c.right, c.up), c.direction) == doctest::Approx(dot(cross(base.right, base.up), base.direction)));
    }
    check_same(moved(base, turned_by(2 * pi, 0), pivot), base, 1e-14);
    check_same(moved(base, turned_by(0, -2 * pi), pivot), base, 1e-14);
    // Half a turn: the other side.
    const Camera across = moved(base, turned_by(pi, 0), pivot);
    check_near(across.up, base.up, 1e-13);
    check_near(across.right, -base.right, 1e-13);
  }
}

TEST_CASE("navigation: zoom comes nearer, or shows less of a parallel view") {
  const Loaded s = load(settings + tilted + "}" + cube);
  const Vec3 pivot = pivot_of(s.scene, s.geometry);
  Navigation n;
  n.zoom = 2;
  const Camera c = moved(s.scene.camera, n, pivot);
  CHECK(length(c.location - pivot) == doctest::Approx(length(s.scene.camera.location - pivot) / 4));
  CHECK(length(c.right) == doctest::Approx(length(s.scene.camera.right)));
  Camera parallel = s.scene.camera;
  parallel.orthographic = true;
  const Camera p = moved(parallel, n, pivot);
  check_near(p.location, parallel.location, 1e-13);
  CHECK(length(p.right) == doctest::Approx(length(parallel.right) / 4));
  CHECK(length(p.up) == doctest::Approx(length(parallel.up) / 4));
}

TEST_CASE("navigation: the analyzer turns with the camera, counter-clockwise as the picture shows it") {
  for (const char* kind : kinds)
    for (const char* polarizer : {"polarizer { ideal angle 20 } ", "polarizer { calcite angle 20 } "}) {
      INFO(kind);
      const Loaded s = load(settings + tilted + polarizer + kind + cube);
      Geometry geometry = s.geometry;
      Navigation n = turned_by(0.8, -0.6);
      n.zoom = 0.5;
      const Scene seen = navigate(s.scene, geometry, n, Analyzer::as_scene, 0.3, 1.1);
      REQUIRE(seen.camera.polarizer);
      const Polarizer& p = seen.polarizers[static_cast<std::size_t>(*seen.camera.polarizer)];
      const double azimuth = 20 * pi / 180 + 0.3;
      const Vec3 right = normalize(seen.camera.right), up = normalize(seen.camera.up);
      check_near(p.transmission_axis, right * std::cos(azimuth) + up * std::sin(azimuth));
      check_near(p.normal, normalize(cross(seen.camera.right, seen.camera.up)));
    }
}

TEST_CASE("navigation: an analyzer taken away or put in") {
  const Loaded with = load(settings + tilted + "polarizer { ideal angle 90 } }" + cube);
  Geometry geometry = with.geometry;
  CHECK_FALSE(navigate(with.scene, geometry, {}, Analyzer::none, 0, 0).camera.polarizer);
  CHECK(navigate(with.scene, geometry, {}, Analyzer::added, 0, 0).polarizers.size() == 1);

  for (const char* kind : kinds) {
    const Loaded without = load(settings + tilted + kind + cube);
    geometry = without.geometry;
    const Scene seen = navigate(without.scene, geometry, turned_by(1, 0.4), Analyzer::added, pi / 6, 0);
    REQUIRE(seen.camera.polarizer);
    const Polarizer& p = seen.polarizers[static_cast<std::size_t>(*seen.camera.polarizer)];
    CHECK(p.kind == Polarizer::Kind::ideal);
    check_near(p.transmission_axis, normalize(seen.camera.right) * std::cos(pi / 6) + normalize(seen.camera.up) * 0.5);
  }
}

TEST_CASE("navigation: polarizers of lights and sheets turn about their normal, and only they") {
  const Loaded s = load(settings + tilted + "polarizer { ideal angle 0 } }" + cube +
                        "polygon { 4, <-9,-3,-9>, <9,-3,-9>, <9,-3,9>, <-9,-3,9>"
                        "  luminous { spectrum { d65 } polarizer { ideal angle 0 } } }"
                        "disc { 3*y, y, 1 polarizer { ideal angle 10 } }");
  Geometry geometry = s.geometry;
  const Scene seen = navigate(s.scene, geometry, {}, Analyzer::as_scene, 0, 0.4);
  REQUIRE(seen.polarizers.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Polarizer &was = s.scene.polarizers[i], &is = seen.polarizers[i];
    const bool analyzer = static_cast<int>(i) == *s.scene.camera.polarizer;
    CHECK(dot(was.transmission_axis, is.transmission_axis) == doctest::Approx(analyzer ? 1 : std::cos(0.4)));
    const double sine = dot(cross(was.transmission_axis, is.transmission_axis), was.normal);
    CHECK(sine == doctest::Approx(analyzer ? 0 : std::sin(0.4)));
    check_near(is.normal, was.normal);
  }
}

TEST_CASE("navigation: a polarizer shared by camera and light turns for each in its own way") {
  Loaded s = load(settings + tilted + "polarizer { ideal angle 0 } }" + cube +
                  "disc { -3*y, y, 9 luminous { spectrum { d65 } } }");
  s.scene.emissions.at(0).polarizer = s.scene.camera.polarizer;
  Geometry geometry = s.geometry;
  const Scene seen = navigate(s.scene, geometry, {}, Analyzer::as_scene, 0.5, 0);
  REQUIRE(seen.polarizers.size() == 2);
  CHECK(seen.camera.polarizer != seen.emissions[0].polarizer);
  check_near(seen.polarizers[static_cast<std::size_t>(*seen.emissions[0].polarizer)].transmission_axis,
             s.scene.polarizers[0].transmission_axis, 0);
}

TEST_CASE("navigation: the cell around the camera is the one that exact arithmetic finds") {
  const std::string solids =
      "box { -3, 3 interior { ior 1.5 } } box { -1, 1 interior { ior 1.7 } rotate <20, 30, 40> }"
      "difference { box { <5, -2, -2>, <9, 2, 2> } box { <6, -1, -3>, <8, 3, 3> } interior { ior 1.6 } }"  // a trough
      "prism { 0, 4, 6, <0,10>, <6,10>, <6,12>, <2,12>, <2,16>, <0,16> interior { ior 1.4 } }";
  int inside = 0;
  for (int i = 0; i < 24; ++i) {
    const double t = i * 2.399963;  // golden angle
    const Vec3 p{3 + 5.5 * std::cos(t), 0.17 * (i - 9), (i % 3 ? 0.0 : 12.0) + 3.1 * std::sin(t)};
    const std::string at = std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z);
    const Loaded s = load(settings + "camera { location <" + at + "> }" + solids);
    INFO(at);
    CHECK(cell_around(s.geometry, s.scene.camera.location) == s.geometry.camera_cell);
    inside += s.geometry.camera_cell > 0;
  }
  CHECK(inside > 4);
  CHECK(inside < 20);
}

TEST_CASE("navigation: on a face the cell is the outer one, on a seam a part of the solid") {
  const Loaded s = load(settings + "camera { location -20*z } box { -3, 3 interior { ior 1.5 } }"
                        "box { -1, 1 interior { ior 1.7 } }"
                        "prism { 0, 4, 6, <0,10>, <6,10>, <6,12>, <2,12>, <2,16>, <0,16> interior { ior 1.4 } }");
  CHECK(cell_around(s.geometry, {0, 0, 3}) == 0);
  CHECK(cell_around(s.geometry, {0, 1, 0}) == 1);
  CHECK(cell_around(s.geometry, {0, 0.999, 0}) == 2);
  for (int i = 1; i < 12; ++i) CHECK(cell_around(s.geometry, {0.5 * i, 1, -11}) > 2);
  for (int i = 1; i < 12; ++i) CHECK(cell_around(s.geometry, {1, 1, -10 - 0.5 * i}) > 2);
  CHECK(cell_around(s.geometry, {4, 1, -14}) == 0);
}

TEST_CASE("navigation: a camera that zooms into a crystal stands in its cell") {
  const Loaded s = load(settings + "camera { location -8*z } " + cube);
  Geometry geometry = s.geometry;
  CHECK(geometry.camera_cell == 0);
  Navigation n;
  n.zoom = 4;
  navigate(s.scene, geometry, n, Analyzer::as_scene, 0, 0);
  CHECK(geometry.camera_cell == 1);
  navigate(s.scene, geometry, {}, Analyzer::as_scene, 0, 0);
  CHECK(geometry.camera_cell == 0);
}

}  // namespace nicol::preview
