// POV-Ray's camera: its defaults, its fixed order, its traps. mm_per_unit 1 unless the test is
// about it.
#include "bound.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

const std::string mm =
    "global_settings { mm_per_unit 1 } background { rgb 1 } box { 0, 1 interior { ior 1.5 } }\n";

Camera camera(const std::string& text) { return bind_clean(mm + text).scene.camera; }

}  // namespace

TEST_CASE("camera: POV-Ray's defaults, z turned round") {
  const Camera c = camera("camera { location 0 }");
  CHECK_FALSE(c.orthographic);
  check_near(c.location, {0, 0, 0});
  check_near(c.direction, {0, 0, -1});
  check_near(c.right, {4.0 / 3, 0, 0});
  check_near(c.up, {0, 1, 0});
}

TEST_CASE("camera: right, up and the way back to the eye form a right-handed triad") {
  const Camera c = camera("camera { location <1, 2, -7> look_at <3, 1, 4> rotate <10, 20, 30> }");
  CHECK(dot(cross(c.right, c.up), c.direction) < 0);
  CHECK(dot(c.right, c.up) == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("camera: lengths become millimetres") {
  const Camera c = bind_clean(
                       "background { rgb 1 } box { 0, 1 interior { ior 1.5 } }"
                       "camera { location <1, 2, 3> }")
                       .scene.camera;
  check_near(c.location, {10, 20, -30});
  check_near(c.right, {40.0 / 3, 0, 0}, 1e-11);
}

TEST_CASE("camera: angle is the full horizontal angle and wins over the length of direction") {
  const Camera c = camera("camera { angle 90 right 2*x direction 5*z }");
  check_near(c.direction, {0, 0, -1});
  const Camera order = camera("camera { direction 5*z right 2*x angle 90 }");
  check_near(order.direction, c.direction);
}

TEST_CASE("camera: look_at keeps lengths and sky, whatever the order of writing") {
  for (const char* text : {"camera { location <0, 3, -4> look_at 0 right x direction 2*z }",
                           "camera { look_at 0 direction 2*z right x location <0, 3, -4> }"}) {
    const Camera c = camera(text);
    check_near(c.direction, Vec3{0, -0.6, -0.8} * 2);
    check_near(c.right, {1, 0, 0});
    check_near(c.up, {0, 0.8, -0.6});
  }
}

TEST_CASE("camera: transforms come last even if look_at is written after them") {
  const Camera c = camera("camera { location -4*z translate 2*x look_at 0 right x }");
  check_near(c.location, {2, 0, 4});
  check_near(c.direction, {0, 0, -1});
  const Camera turned = camera("camera { location -4*z right x rotate 90*y }");
  check_near(turned.location, {-4, 0, 0});
  check_near(turned.direction, {1, 0, 0});
}

TEST_CASE("camera: a mirrored right mirrors the picture") {
  const Camera c = camera("camera { location -4*z right -x look_at 0 }");
  check_near(c.right, {-1, 0, 0});
  check_near(c.up, {0, 1, 0});
}

TEST_CASE("camera: orthographic takes right and up as sizes") {
  const Camera c = camera("camera { orthographic location -10*z right 4*x up 3*y direction 9*z }");
  CHECK(c.orthographic);
  check_near(c.direction, {0, 0, -1});
  check_near(c.right, {4, 0, 0});
  check_near(c.up, {0, 3, 0});
}

TEST_CASE("camera: orthographic angle shows what a perspective one sees at look_at") {
  // Measured on POV-Ray 3.7: 8.0385 with look_at 15 away, 5.8949 with the default look_at <0,0,1>.
  const Camera c = camera("camera { orthographic location -10*z right x angle 30 look_at 5*z }");
  CHECK(length(c.right) == doctest::Approx(8.0385).epsilon(1e-4));
  CHECK(length(c.up) == doctest::Approx(8.0385).epsilon(1e-4));
  const Camera d = camera("camera { orthographic location -10*z right x angle 30 }");
  CHECK(length(d.right) == doctest::Approx(5.8949).epsilon(1e-4));
}

TEST_CASE("camera: look_at along sky warns and keeps right") {
  const Bound b = bind_text(mm + "camera { location 10*y look_at 0 right x }");
  CHECK(b.count(sdl::Severity::warning) == 1);
  CHECK(b.text().find("Camera location to look_at direction and sky") != std::string::npos);
  check_near(b.scene.camera.right, {1, 0, 0});
  check_near(b.scene.camera.direction, {0, -1, 0});
  CHECK(length(b.scene.camera.up) == doctest::Approx(1));
}

TEST_CASE("camera: the last one wins with a warning") {
  const Bound b = bind_text(mm + "camera { location x } camera { location 2*x }");
  CHECK(b.text().find("More than one camera in scene. Ignoring previous camera(s).") !=
        std::string::npos);
  check_near(b.scene.camera.location, {2, 0, 0});
}

TEST_CASE("camera: the default width in a square picture is told of, a written one is not") {
  BindOptions square;
  square.width = square.height = 100;
  CHECK(bind_text(mm + "camera { location -z }", square).count(sdl::Severity::note) == 1);
  bind_clean(mm + "camera { location -z right x }", square);
}

TEST_CASE("camera: a declared camera can be used and changed") {
  const Camera c =
      camera("#declare C = camera { location <1, 2, 3> angle 40 } camera { C location 9*x }");
  check_near(c.location, {9, 0, 0});
  CHECK(length(c.direction) == doctest::Approx(2.0 / 3 / std::tan(radians(20))));
}

TEST_CASE("camera: focal blur warns once for each of its words") {
  const Bound b =
      bind_text(mm + "camera { location -z aperture 0.4 blur_samples 20 focal_point 0 }");
  CHECK(b.count(sdl::Severity::warning) == 3);
  CHECK(b.count(sdl::Severity::error) == 0);
}

TEST_CASE("camera: the analyzer's angle runs from the picture's right towards its up") {
  const Bound b = bind_clean(
      mm + "camera { location 10*y sky z look_at 0 right x polarizer { ideal angle 30 } }");
  REQUIRE(b.scene.camera.polarizer);
  const Polarizer& p = b.scene.polarizers[*b.scene.camera.polarizer];
  check_near(b.scene.camera.up, {0, 0, -1});  // POV-Ray's z
  check_near(p.transmission_axis, {std::sqrt(0.75), 0, -0.5});
  check_near(p.normal, {0, 1, 0});  // towards the eye
}

TEST_CASE("camera: the analyzer turns with the camera") {
  const Bound b =
      bind_clean(mm + "camera { location -10*z right x polarizer { ideal angle 90 } rotate 90*z }");
  check_near(b.scene.polarizers[0].transmission_axis, {-1, 0, 0});
}

}  // namespace nicol
