// The straight way of a camera ray through a slab, against Snell's law written out.
#include "host/app/chord.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

using namespace nicol;

namespace {

// A box of half-widths (50, half_mm, 50) around `centre`, index n, under a camera that looks down
// its y axis.
struct Slab {
  Scene scene;
  Geometry geometry;

  Slab(double half_mm, double n, const Vec3& centre_mm) {
    scene.lambda_nm = {589};
    scene.weight_nm = {1};
    scene.media.resize(2);
    scene.media[0].n.fill({1});
    scene.media[1].n.fill({n});
    scene.camera.location = {0, 100, 0};
    scene.camera.direction = {0, -1, 0};
    scene.camera.right = {2, 0, 0};
    scene.camera.up = {0, 0, 2};
    geometry.cells.resize(1);
    add_box({50, half_mm, 50}, centre_mm);
  }

  void add_box(const Vec3& half_mm, const Vec3& centre_mm) {
    Cell cell;
    cell.medium = 1;
    cell.centre_mm = centre_mm;
    cell.first_face = static_cast<int>(geometry.faces.size());
    cell.face_count = 6;
    for (const double sign : {-1.0, 1.0}) {
      add_face({sign, 0, 0}, half_mm.x);
      add_face({0, sign, 0}, half_mm.y);
      add_face({0, 0, sign}, half_mm.z);
    }
    geometry.cells[0].children.push_back(static_cast<int>(geometry.cells.size()));
    geometry.cells.push_back(cell);
  }

  void add_face(const Vec3& normal, double offset_mm) {
    Face face;
    face.plane = {normal, offset_mm};
    geometry.faces.push_back(face);
  }
};

}  // namespace

TEST_CASE("straight through the middle the chord is the thickness") {
  const Slab slab(8, 1.5, {0, 8, 0});
  const auto chord = app::first_chord(slab.scene, slab.geometry, {0.5, 0.5}, 0);
  REQUIRE(chord);
  CHECK(chord->cell == 1);
  CHECK(chord->length_mm == doctest::Approx(16).epsilon(1e-14));
}

TEST_CASE("an oblique ray follows Snell's law") {
  CHECK(rc::check([] {
    const double n = 1 + *rc::gen::inRange(0, 1500) / 1000.0;
    const double x = *rc::gen::inRange(1, 999) / 1000.0;
    const Slab slab(2, n, {0, 0, 0});
    const auto chord = app::first_chord(slab.scene, slab.geometry, {x, 0.5}, 0);
    const double tan_i = 2 * (x - 0.5);
    if (std::fabs(tan_i) * 98 > 45) return;  // beside the slab, or out through its side
    RC_ASSERT(chord.has_value());
    const double sin_t = std::sin(std::atan(tan_i)) / n;
    RC_ASSERT(std::fabs(chord->length_mm - 4 / std::sqrt(1 - sin_t * sin_t)) < 1e-11);
  }));
}

TEST_CASE("a parallel ray of an orthographic camera keeps its place") {
  Slab slab(3, 2, {0, 0, 0});
  slab.scene.camera.orthographic = true;
  slab.scene.camera.right = {200, 0, 0};
  CHECK(app::first_chord(slab.scene, slab.geometry, {0.7, 0.5}, 0)->length_mm ==
        doctest::Approx(6));
  CHECK_FALSE(app::first_chord(slab.scene, slab.geometry, {0.8, 0.5}, 0));
}

TEST_CASE("of two solids the nearer one is met") {
  Slab slab(3, 1.5, {0, -20, 0});
  slab.add_box({50, 1, 50}, {0, 20, 0});
  const auto chord = app::first_chord(slab.scene, slab.geometry, {0.5, 0.5}, 0);
  REQUIRE(chord);
  CHECK(chord->cell == 2);
  CHECK(chord->length_mm == doctest::Approx(2));
}

TEST_CASE("a ray that looks away meets nothing") {
  Slab slab(3, 1.5, {0, 0, 0});
  slab.scene.camera.direction = {0, 1, 0};
  CHECK_FALSE(app::first_chord(slab.scene, slab.geometry, {0.5, 0.5}, 0));
}
