// Solids that touch: whole faces, parts of faces, shifted, in optical contact.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::vector<std::vector<Affine>> moves{
    {}, {rotate_x(25), rotate_y(25), translate(0.1, 100.0 / 3, 1e-3), left_to_right()}};

Built pair(const ConvexShape& a, const ConvexShape& b, const std::vector<Affine>& move) {
  Object first = solid(a, 1), second = solid(b, 2);
  first.transforms = second.transforms = move;
  return build({first, second});
}

// The two patches of two solids are each other's mirror, and have this area in units of the shapes.
void check_gap(const Built& built, double expected_area, const std::vector<Affine>& move) {
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  const auto a = patches_of(built.geometry, 1), b = patches_of(built.geometry, 2);
  REQUIRE(a.size() == 1);
  REQUIRE(b.size() == 1);
  CHECK(a[0]->behind == Patch::Behind::cell_gap);
  CHECK(a[0]->other_cell == 2);
  CHECK(b[0]->other_cell == 1);
  CHECK(a[0]->other_face == b[0]->face);
  CHECK(b[0]->other_face == a[0]->face);
  const double scale = move.empty() ? 1 : 100;
  CHECK(patch_area(built.geometry, 1, *a[0]) ==
        doctest::Approx(expected_area * scale).epsilon(1e-11));
  CHECK(patch_area(built.geometry, 2, *b[0]) ==
        doctest::Approx(expected_area * scale).epsilon(1e-11));
}

}  // namespace

TEST_CASE("two cubes share a whole face: no edges on either side") {
  for (const auto& move : moves) {
    const Built built = pair(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}), move);
    check_gap(built, 1, move);
    for (const Patch& patch : built.geometry.patches) CHECK(patch.edges.empty());
  }
}

TEST_CASE("a small cube on a large one covers a part of its face") {
  for (const auto& move : moves) {
    const Built built = pair(box({0, 0, 0}, {3, 1, 3}), box({1, 1, 1}, {2, 2, 2.5}), move);
    check_gap(built, 1.5, move);
    CHECK(patches_of(built.geometry, 1)[0]->edges.size() == 4);
    CHECK(patches_of(built.geometry, 2)[0]->edges.empty());
  }
}

TEST_CASE("shifted cubes touch in a part of both faces") {
  for (const auto& move : moves) {
    const Built built = pair(box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, -0.5}, {2, 1.25, 0.5}), move);
    check_gap(built, 0.375, move);
    for (const Patch& patch : built.geometry.patches) CHECK(patch.edges.size() == 2);
  }
}

TEST_CASE("a diamond on a square: the overlap is the octagon of both outlines") {
  ConvexShape diamond{{{{0, -1, 0}, -1},
                       {{0, 1, 0}, 2},
                       {{1, 0, 1}, 1.5},
                       {{1, 0, -1}, 1.5},
                       {{-1, 0, 1}, 1.5},
                       {{-1, 0, -1}, 1.5}}};
  for (const auto& move : moves)
    check_gap(pair(box({-1, 0, -1}, {1, 1, 1}), diamond, move), 4 - 4 * 0.125, move);
}

TEST_CASE("edges and corners alone are no contact") {
  for (const auto& move : moves) {
    CHECK(
        pair(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}), move).geometry.patches.empty());
    CHECK(
        pair(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}), move).geometry.patches.empty());
  }
}

TEST_CASE("optical contact of either makes it one interface") {
  Object first = solid(box({0, 0, 0}, {1, 1, 1}), 1), second = solid(box({1, 0, 0}, {2, 1, 1}), 2);
  second.optical_contact = true;
  const Built built = build({first, second});
  REQUIRE(built.geometry.patches.size() == 2);
  for (const Patch& patch : built.geometry.patches)
    CHECK(patch.behind == Patch::Behind::cell_contact);
}

TEST_CASE("a face that meets two others has a patch for each") {
  const Built built =
      build({solid(box({0, 0, 0}, {2, 1, 1}), 1), solid(box({0, 1, 0}, {1, 2, 1}), 2),
             solid(box({1, 1, 0}, {2, 2, 1}), 3)});
  REQUIRE(built.messages.empty());
  CHECK(patches_of(built.geometry, 1).size() == 2);
  CHECK(patches_of(built.geometry, 2).size() == 2);
  for (const Patch* patch : patches_of(built.geometry, 1)) {
    CHECK(patch->edges.size() == 1);
    CHECK(patch_area(built.geometry, 1, *patch) == doctest::Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("the hypotenuses of two right prisms meet exactly though their numbers are not round") {
  const PrismShape first{{{{0.1, 0.1}, {0.7, 0.1}, {0.1, 0.4}}}, 0, 0.3};
  const PrismShape second{{{{0.7, 0.4}, {0.7, 0.1}, {0.1, 0.4}}}, 0, 0.3};
  for (const auto& move : moves) {
    Object a = solid(first, 1), b = solid(second, 2);
    a.transforms = b.transforms = move;
    check_gap(build({a, b}), 0.3 * std::hypot(0.6, 0.3), move);
  }
}
