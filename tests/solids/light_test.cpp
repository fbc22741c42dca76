// Solids on lights: the founding scene, with and without common transforms.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

// A cube of 2 on the floor and a light in the floor, both moved alike.
Built on_light(const PolygonShape& shape, const std::vector<Affine>& moves) {
  Object cube = solid(box({-1, 0, -1}, {1, 2, 1}), 1), lamp = light(shape, 2);
  cube.transforms = lamp.transforms = moves;
  return build({cube, lamp});
}

std::vector<std::vector<Affine>> common_moves() {
  return {{},
          {left_to_right()},
          {rotate_y(25), left_to_right()},
          {translate(0.1, 0.2, 0.3), rotate_x(25), rotate_y(25), translate(-0.7, 1e3 / 3, 0.1),
           left_to_right()}};
}

double scale_of(const std::vector<Affine>& moves) { return moves.empty() ? 1 : 10; }

const Patch& only_patch(const Built& built) {
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  REQUIRE(built.geometry.patches.size() == 1);
  const Patch& patch = built.geometry.patches[0];
  CHECK(patch.behind == Patch::Behind::light);
  CHECK(patch.emission == 0);
  CHECK(built.geometry.faces[patch.face].shape_face == 2);
  return patch;
}

}  // namespace

TEST_CASE("a light that covers the whole face has no edges, whatever the common transforms") {
  for (double reach : {1.0, 1.5, 40.0}) {
    for (const auto& moves : common_moves()) {
      const Built built = on_light(floor_square(-reach, reach, 0), moves);
      CHECK(only_patch(built).edges.empty());
      CHECK(built.geometry.sheets.size() == 1);
      CHECK(built.geometry.sheets[0].cell == 0);
    }
  }
}

TEST_CASE("a smaller light is a patch with its own edges") {
  for (const auto& moves : common_moves()) {
    const Built built = on_light(floor_square(-0.5, 0.25, 0), moves);
    const Patch& patch = only_patch(built);
    CHECK(patch.edges.size() == 4);
    const double s = scale_of(moves);
    CHECK(patch_area(built.geometry, 1, patch) ==
          doctest::Approx(0.75 * 0.75 * s * s).epsilon(1e-11));
    const Vec3 normal = built.geometry.faces[patch.face].plane.normal;
    for (const Plane& edge : patch.edges) {
      CHECK(std::abs(dot(edge.normal, normal)) < 1e-15);
      CHECK(dot(edge.normal, edge.normal) == doctest::Approx(1).epsilon(1e-15));
    }
  }
}

TEST_CASE("a light that overhangs cuts the face only where its edges do") {
  for (const auto& moves : common_moves()) {
    const Built built = on_light(floor_square(0.5, 3, 0), moves);
    const Patch& patch = only_patch(built);
    CHECK(patch.edges.size() == 2);
    const double s = scale_of(moves);
    CHECK(patch_area(built.geometry, 1, patch) == doctest::Approx(0.25 * s * s).epsilon(1e-11));
  }
}

TEST_CASE("a light beside the face, sharing an edge or a corner, does not touch") {
  CHECK(on_light(floor_square(1, 3, 0), {}).geometry.patches.empty());
  CHECK(on_light(polygon({{1, 0, -1}, {1, 0, 1}, {2, 0, 0}}), {}).geometry.patches.empty());
}

TEST_CASE("a concave light comes in pieces whose edges between them are exactly opposite") {
  const PolygonShape ell =
      polygon({{-3, 0, -3}, {-3, 0, 3}, {0.3, 0, 3}, {0.3, 0, 0.2}, {3, 0, 0.2}, {3, 0, -3}});
  for (const auto& moves : common_moves()) {
    const Built built = on_light(ell, moves);
    REQUIRE(built.messages.empty());
    REQUIRE(built.geometry.sheets.size() == 2);
    REQUIRE(built.geometry.patches.size() == 2);
    double area_sum = 0;
    for (const Patch& patch : built.geometry.patches)
      area_sum += patch_area(built.geometry, 1, patch);
    const double s = scale_of(moves);
    CHECK(area_sum == doctest::Approx((4 - 0.7 * 0.8) * s * s).epsilon(1e-11));
    int opposite_pairs = 0;
    for (const Plane& a : built.geometry.sheets[0].edges) {
      for (const Plane& b : built.geometry.sheets[1].edges) {
        opposite_pairs += a.normal.x == -b.normal.x && a.normal.y == -b.normal.y &&
                          a.normal.z == -b.normal.z && a.offset_mm == -b.offset_mm;
      }
    }
    CHECK(opposite_pairs == 1);
  }
}

TEST_CASE("a light between two solids comes before what is behind it, on both sides") {
  Scene scene = scene_of({solid(box({-1, 0, -1}, {1, 2, 1}), 1), light(floor_square(-1, 1, 0), 2),
                          solid(box({-1, -2, -1}, {1, 0, 1}), 3)});
  const Built built = build(scene);
  REQUIRE(built.messages.empty());
  CHECK(built.geometry.sheets[0].plane.normal.y == 1);
  const auto above = patches_of(built.geometry, 1), below = patches_of(built.geometry, 2);
  REQUIRE(above.size() == 2);  // the light, and behind it the other cube
  REQUIRE(below.size() == 2);
  CHECK(above[0]->behind == Patch::Behind::light);
  CHECK(above[0]->emission == 0);
  CHECK(above[1]->behind == Patch::Behind::cell_gap);
  CHECK(below[0]->behind == Patch::Behind::light);
  CHECK(below[0]->emission == 0);
  CHECK(below[0]->sheet == 0);
  CHECK(below[1]->behind == Patch::Behind::cell_gap);
}

TEST_CASE("a cube on a polarizer sheet") {
  const Built built =
      build({solid(box({-1, 0, -1}, {1, 2, 1}), 1), polarizer(floor_square(-2, 2, 0), 2)});
  REQUIRE(built.geometry.patches.size() == 1);
  CHECK(built.geometry.patches[0].behind == Patch::Behind::polarizer);
  CHECK(built.geometry.patches[0].sheet == 0);
}

TEST_CASE("a cube on a disc has a ring in its own coordinates") {
  Object cube = solid(box({-1, 0, -1}, {1, 2, 1}), 1),
         lamp = light(DiscShape{{0.5, 0, 0}, {0, 1, 0}, 0.75, 0.25}, 2);
  cube.transforms = lamp.transforms = {rotate_x(25), translate(5, 6, 7), left_to_right()};
  const Built built = build({cube, lamp});
  const Patch& patch = only_patch(built);
  REQUIRE(patch.has_disc);
  CHECK(patch.edges.empty());
  CHECK(patch.disc.radius_mm == doctest::Approx(7.5).epsilon(1e-14));
  CHECK(patch.disc.hole_radius_mm == doctest::Approx(2.5).epsilon(1e-14));
  const Vec3 c = patch.disc.centre_mm;  // the cube's centre is 10 mm above the floor
  CHECK(std::sqrt(dot(c, c)) == doctest::Approx(std::hypot(5, 10)).epsilon(1e-13));
  CHECK(built.geometry.sheets[0].has_disc);
  CHECK(build({cube, light(DiscShape{{9, 0, 0}, {0, 1, 0}, 1, 0}, 2)}).geometry.patches.empty());
}

TEST_CASE("a shining face of a neighbour is a light, its own face shines both ways") {
  Object lamp = solid(box({-2, -1, -2}, {2, 0, 2}), 2);
  lamp.face_emissions = {{3, 1}};
  const Built built = build({solid(box({-1, 0, -1}, {1, 2, 1}), 1), lamp});
  REQUIRE(built.messages.empty());
  const auto patches = patches_of(built.geometry, 1);
  REQUIRE(patches.size() == 1);
  CHECK(patches[0]->behind == Patch::Behind::light);
  CHECK(patches[0]->emission == 1);
  CHECK(patches[0]->sheet == -1);
  CHECK(built.geometry.faces[patches[0]->other_face].emission == 1);
  CHECK(patches_of(built.geometry, 2).empty());
}
