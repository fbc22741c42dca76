// Solids in solids, and overlaps that are neither nesting nor touching.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {
Object cube(double half, std::uint32_t line) {
  return solid(box({-half, -half, -half}, {half, half, half}), line);
}
}  // namespace

TEST_CASE("three cubes in one another, in any order of the text") {
  const Built built = build({cube(2, 1), cube(1, 2), cube(3, 3)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  const auto& cells = built.geometry.cells;
  CHECK(cells[3].parent == 0);
  CHECK(cells[1].parent == 3);
  CHECK(cells[2].parent == 1);
  CHECK(cells[0].children == std::vector<int>{3});
  CHECK(cells[3].children == std::vector<int>{1});
  CHECK(cells[1].children == std::vector<int>{2});
  CHECK(built.geometry.patches.empty());
}

TEST_CASE("a child may touch its parent's faces from inside, and its sister") {
  const std::vector<Affine> move{rotate_x(25), rotate_y(10), left_to_right()};
  Object parent = solid(box({0, 0, 0}, {4, 4, 4}), 1), child = solid(box({0, 0, 1}, {1, 4, 2}), 2),
         sister = solid(box({1, 0, 1}, {2, 1, 2}), 3),
         outside = solid(box({-1, 0, 0}, {0, 4, 4}), 4);
  for (Object* object : {&parent, &child, &sister, &outside}) object->transforms = move;
  const Built built = build({parent, child, sister, outside});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  CHECK(built.geometry.cells[2].parent == 1);
  CHECK(built.geometry.cells[3].parent == 1);
  CHECK(built.geometry.cells[4].parent == 0);
  // Child and sister touch; the child and what is outside do not, for the parent's face lies
  // between.
  REQUIRE(patches_of(built.geometry, 2).size() == 1);
  CHECK(patches_of(built.geometry, 2)[0]->other_cell == 3);
  REQUIRE(patches_of(built.geometry, 4).size() == 1);
  CHECK(patches_of(built.geometry, 4)[0]->other_cell == 1);
}

TEST_CASE("overlaps are errors that name both places") {
  const Built built =
      build({solid(box({0, 0, 0}, {2, 2, 2}), 12), solid(box({1, 1, 1}, {3, 3, 3}), 30)});
  REQUIRE(built.messages.size() == 1);
  CHECK(built.failed);
  CHECK(built.says("box at line 12 and box at line 30 overlap"));
  CHECK_FALSE(built.says("mm only"));
  CHECK(built.messages[0].where.line == 30);
  CHECK(build({cube(1, 1), cube(1, 2)}).says("fill the same space"));
}

TEST_CASE("an overlap by one rounding step is found, and its depth told") {
  const double x = std::nextafter(1.0, 0.0);
  const Built built =
      build({solid(box({0, 0, 0}, {1, 1, 1}), 1), solid(box({x, 0, 0}, {2, 1, 1}), 2)});
  REQUIRE(built.failed);
  CHECK(built.says("overlap by 1.11e-16 mm only"));
  CHECK(built.says("write the same numbers"));
}

TEST_CASE("boxes that overlap only as boxes, parted by no face of either, are apart") {
  // Two long thin bars askew, one above the other along the common perpendicular of two of their
  // edges.
  Object first = solid(box({-10, -1, -1}, {10, 1, 1}), 1), second = first;
  first.transforms = {rotate_x(45)};
  second.transforms = {rotate_x(45), rotate_y(90),
                       translate(0, 2.83, 0)};  // 2 sqrt 2 apart: 2.82843
  CHECK_FALSE(build({first, second}).failed);
  second.transforms.back() = translate(0, 2.82, 0);
  CHECK(build({first, second}).says("overlap"));
}

TEST_CASE("a solid inside one part of a concave prism is its child") {
  Object ell = solid(PrismShape{{{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}}, 0, 4}, 8);
  const Built inside = build({ell, solid(box({4, 1, 0.25}, {5, 2, 0.75}), 9)});
  REQUIRE_MESSAGE(inside.messages.empty(), inside.first());
  CHECK(inside.geometry.cells.size() == 4);
  CHECK(inside.geometry.cells[3].parent > 0);
  CHECK(inside.geometry.cells[inside.geometry.cells[3].parent].object == 0);
}

TEST_CASE("the camera's cell is exact") {
  Scene scene = scene_of({cube(3, 1), cube(1, 2)});
  const auto cell_at = [&](const Vec3& p) {
    scene.camera.location = p;
    return build(scene).geometry.camera_cell;
  };
  CHECK(cell_at({5, 0, 0}) == 0);
  CHECK(cell_at({2, 0, 0}) == 1);
  CHECK(cell_at({0.5, 0, 0}) == 2);
  CHECK(cell_at({std::nextafter(1.0, 0.0), 0, 0}) == 2);
  CHECK(cell_at({1, 0, 0}) == 1);
  CHECK(build(scene).says("exactly on a surface"));
  scene.camera.orthographic = true;
  CHECK(build(scene).geometry.camera_cell == 0);
  scene.camera.orthographic = false;
  scene.camera.location = {3, 1, 1};
  CHECK(build(scene).geometry.camera_cell == 0);
}
