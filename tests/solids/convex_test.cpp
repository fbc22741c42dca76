// Convex solids from half-spaces: counts, volumes in closed form, and what cannot be a solid.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

void add_ring(ConvexShape& shape, int count, double tilt_deg, double offset, double turn_deg = 0) {
  const double up = std::sin(tilt_deg * pi / 180), out = std::cos(tilt_deg * pi / 180);
  for (int i = 0; i < count; ++i) {
    const double a = 2 * pi * i / count + turn_deg * pi / 180;
    shape.faces.push_back({{out * std::cos(a), up, out * std::sin(a)}, offset});
  }
}

const Cell& only_cell(const Built& built) {
  REQUIRE_MESSAGE(!built.failed, built.first());
  REQUIRE(built.geometry.cells.size() == 2);
  return built.geometry.cells[1];
}

}  // namespace

TEST_CASE("a cube has 8 corners, 12 edges, 6 faces and exact axis-aligned planes") {
  const Built built = build({solid(box({-1, -1, -1}, {1, 1, 1}), 1)});
  const Cell& cell = only_cell(built);
  const Counts c = counts(built.geometry, cell);
  CHECK(c.corners == 8);
  CHECK(c.edges == 12);
  CHECK(c.faces == 6);
  CHECK(c.closed);
  CHECK(volume(built.geometry, cell) == doctest::Approx(8).epsilon(1e-15));
  for (int i = 0; i < 6; ++i) {
    const Face& face = built.geometry.faces[i];
    const double sign = i % 2 ? 1 : -1;
    CHECK(face.shape_face == i);
    CHECK(face.plane.offset_mm == 1);
    CHECK(face.plane.normal.x == (i / 2 == 0 ? sign : 0));
    CHECK(face.plane.normal.y == (i / 2 == 1 ? sign : 0));
    CHECK(face.plane.normal.z == (i / 2 == 2 ? sign : 0));
    CHECK(dot(area_vector(face.corners), face.plane.normal) == 4);
  }
}

TEST_CASE("four planes through one corner give one corner: the octahedron") {
  ConvexShape shape;
  for (int i = 0; i < 8; ++i) {
    shape.faces.push_back({{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}, 1});
  }
  const Built built = build({solid(shape, 1)});
  const Counts c = counts(built.geometry, only_cell(built));
  CHECK(c.corners == 6);
  CHECK(c.edges == 12);
  CHECK(c.faces == 8);
  CHECK(volume(built.geometry, only_cell(built)) == doctest::Approx(4.0 / 3).epsilon(1e-14));
}

TEST_CASE("a quartz-like prism with two pyramids has 18 faces and its closed-form volume") {
  // Six sides at distance 1, heights from 0.5 to the tips: a prism and two six-sided pyramids whose
  // faces tilt 45 degrees.
  ConvexShape shape;
  add_ring(shape, 6, 0, 1);
  for (double sign : {1.0, -1.0}) {
    for (int i = 0; i < 6; ++i) {
      const HalfSpace& side = shape.faces[i];
      shape.faces.push_back({{side.normal.x, sign, side.normal.z}, 1.5});
    }
  }
  const Built built = build({solid(shape, 1)});
  const Cell& cell = only_cell(built);
  const double hexagon = 2 * std::sqrt(3.0);
  CHECK(counts(built.geometry, cell).faces == 18);
  CHECK(counts(built.geometry, cell).closed);
  CHECK(volume(built.geometry, cell) == doctest::Approx(hexagon * (1 + 2.0 / 3)).epsilon(1e-12));
}

TEST_CASE(
    "a brilliant-like cut of 89 faces, all tangent to one sphere, closes by Euler's formula") {
  ConvexShape shape;
  shape.faces.push_back({{0, 1, 0}, 1});
  add_ring(shape, 16, 0, 1, 4);
  add_ring(shape, 16, 41, 1, 11);
  add_ring(shape, 16, 33, 1, 0);
  add_ring(shape, 8, 20, 1, 22.5);
  add_ring(shape, 16, -42, 1, 11);
  add_ring(shape, 16, -60, 1, 0);
  REQUIRE(shape.faces.size() == 89);
  const Built built = build({solid(shape, 1)});
  const Cell& cell = only_cell(built);
  const Counts c = counts(built.geometry, cell);
  CHECK(c.closed);
  CHECK(c.corners - c.edges + c.faces == 2);
  CHECK(c.faces == 89);
  // Every face at distance 1 from the sphere's centre: volume is a third of the area.
  double area_sum = 0;
  for (const Face& face : built.geometry.faces) area_sum += area(face.corners);
  CHECK(volume(built.geometry, cell) == doctest::Approx(area_sum / 3).epsilon(1e-12));
}

TEST_CASE("256 sides: a regular polygon's area in closed form") {
  ConvexShape shape;
  shape.faces = {{{0, -1, 0}, 1}, {{0, 1, 0}, 1}};
  add_ring(shape, 254, 0, 3);
  const Built built = build({solid(shape, 1)});
  const Counts c = counts(built.geometry, only_cell(built));
  CHECK(c.faces == 256);
  CHECK(c.corners == 508);
  CHECK(c.closed);
  CHECK(volume(built.geometry, only_cell(built)) ==
        doctest::Approx(2 * 9 * 254 * std::tan(pi / 254)).epsilon(1e-12));
}

TEST_CASE("planes that bound nothing leave no face; a light on one is told") {
  ConvexShape shape = box({0, 0, 0}, {1, 1, 1});
  shape.faces.push_back({{1, 1, 0}, 5});  // far off
  shape.faces.push_back({{1, 1, 0}, 2});  // touches an edge
  shape.faces.push_back({{1, 1, 1}, 3});  // touches a corner
  shape.faces.push_back({{3, 0, 0}, 3});  // face 1 again
  Object object = solid(shape, 7);
  object.face_emissions = {{9, 2}, {3, 1}};
  const Built built = build({object});
  const Cell& cell = only_cell(built);
  CHECK(cell.face_count == 6);
  CHECK(volume(built.geometry, cell) == 1);
  CHECK(built.geometry.faces[3].emission == 1);
  REQUIRE(built.messages.size() == 1);
  CHECK(built.says("face 9 of box at line 7"));
}

TEST_CASE("solids that are empty, flat, open or collapsed are errors with their place") {
  ConvexShape empty = box({0, 0, 0}, {1, 1, 1});
  empty.faces.push_back({{1, 0, 0}, -1});
  CHECK(build({solid(empty, 3)}).says("encloses nothing: face 6"));

  CHECK(build({solid(box({0, 0, 0}, {1, 0, 1}), 3)}).says("encloses nothing: face 3"));

  ConvexShape open = box({0, 0, 0}, {1, 1, 1});
  open.faces.erase(open.faces.begin() + 3);
  CHECK(build({solid(open, 3)}).says("open towards <0, 1, 0>"));
  CHECK(build({solid(ConvexShape{}, 3)}).says("not closed"));

  Object collapsed = solid(box({0, 0, 0}, {1, 1, 1}), 12);
  collapsed.transforms = {scale(1, 0, 1), left_to_right()};
  const Built built = build({collapsed});
  CHECK(built.says("flattened"));
  CHECK(built.messages[0].where.line == 12);

  Object broken = solid(box({0, 0, 0}, {1, 1, std::nan("")}), 5);
  CHECK(build({broken}).failed);
}

TEST_CASE("transforms are exact, mirrors keep the outside out, offsets stay sharp far away") {
  Object object = solid(box({0, 0, 0}, {1, 2, 3}), 1);
  object.transforms = {rotate_x(25), rotate_y(-40), translate(1e6, -3e5, 7e5), left_to_right()};
  const Built built = build({object});
  const Cell& cell = only_cell(built);
  CHECK(volume(built.geometry, cell) ==
        doctest::Approx(6000).epsilon(1e-9));  // corners are at 1e7 mm
  for (int i = 0; i < 6; i += 2) {
    const Plane &a = built.geometry.faces[i].plane, &b = built.geometry.faces[i + 1].plane;
    CHECK(a.normal.x == -b.normal.x);
    CHECK(a.normal.y == -b.normal.y);
    CHECK(a.normal.z == -b.normal.z);
    CHECK(a.offset_mm + b.offset_mm == doctest::Approx(10.0 * (i / 2 + 1)).epsilon(1e-14));
    CHECK(dot(area_vector(built.geometry.faces[i].corners), a.normal) > 0);
  }
}
