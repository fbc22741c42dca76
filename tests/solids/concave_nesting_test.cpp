// Solids in and beside solids of several cells: split by the seams of what is around them; twins.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "csg_shapes.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::vector<Affine> askew{rotate_x(33), rotate_y(25), translate(0.1, 0.2, 0.3),
                                scale(1, 1, -1)};

// A cube of edge 6 without a quarter (x and z above 2): an L.
Object ell(std::uint32_t line, const std::vector<Affine>& moves = {}) {
  return csg_object(differing({csg_box({0, 0, 0}, {6, 6, 6}), csg_box({2, -1, 2}, {7, 7, 7})}), line,
                    moves);
}

Object boxed(const Vec3& low, const Vec3& high, std::uint32_t line,
             const std::vector<Affine>& moves = {}) {
  Object object = solid(box(low, high), line);
  object.transforms = moves;
  return object;
}

// Every cell of `inner` lies in a cell of `outer`.
void check_inside(const Geometry& geometry, int inner, int outer) {
  for (const Cell& cell : geometry.cells) {
    if (cell.object == inner) CHECK(geometry.cells[cell.parent].object == outer);
  }
}

int cells_of_object(const Geometry& geometry, int object) {
  int count = 0;
  for (const Cell& cell : geometry.cells) count += cell.object == object;
  return count;
}

// Area in contact between two solids, by the patches of either.
std::map<std::pair<int, int>, double> contact_areas(const Geometry& geometry) {
  std::map<std::pair<int, int>, double> areas;
  for (int c = 1; c < static_cast<int>(geometry.cells.size()); ++c) {
    for (const Patch* patch : patches_of(geometry, c)) {
      const std::pair<int, int> objects{geometry.cells[c].object,
                                        geometry.cells[patch->other_cell].object};
      areas[objects] += patch_area(geometry, c, *patch);
    }
  }
  return areas;
}

}  // namespace

TEST_CASE("a child across the seams of its parent is split there, its volume and surface kept") {
  for (const auto& moves : {std::vector<Affine>{}, askew}) {
    const Built built = build({ell(1, moves), boxed({0.5, 1, 0.5}, {1.5, 2, 5}, 2, moves),
                               boxed({3, 1, 0.5}, {4, 2, 1}, 3, moves),
                               boxed({0.5, 3, 0.5}, {5, 4, 1.5}, 4, moves)});
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    const Geometry& geometry = built.geometry;
    for (int child : {1, 2, 3}) check_inside(geometry, child, 0);
    CHECK(cells_of_object(geometry, 0) == 2);
    CHECK(cells_of_object(geometry, 1) + cells_of_object(geometry, 3) == 3);  // one crosses
    CHECK(cells_of_object(geometry, 2) == 1);
    CHECK(total_volume(geometry, 1) == doctest::Approx(4.5).epsilon(1e-12));
    CHECK(total_volume(geometry, 3) == doctest::Approx(4.5).epsilon(1e-12));
    CHECK(outer_area(geometry, 1) == doctest::Approx(20).epsilon(1e-12));
    CHECK(outer_area(geometry, 3) == doctest::Approx(20).epsilon(1e-12));
    CHECK(fault_in_seams(geometry) == "");
  }
}

TEST_CASE("a concave solid in a concave solid, and a solid across the seams of both") {
  const auto bracket = [](double edge, double width, double y, std::uint32_t line) {
    return csg_object(differing({csg_box({0.5, y, 0.5}, {edge, 6 - y, edge}),
                                 csg_box({width, -1, width}, {7, 7, 7})}),
                      line);
  };
  const Built built = build(
      {boxed({0.75, 2.5, 0.75}, {1.25, 3, 4}, 3), bracket(5, 1.5, 1, 2), ell(1)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  check_inside(built.geometry, 1, 2);
  check_inside(built.geometry, 0, 1);
  CHECK(total_volume(built.geometry, 1) == doctest::Approx(4 * (4.5 + 3.5)).epsilon(1e-12));
  CHECK(total_volume(built.geometry, 0) == doctest::Approx(0.5 * 0.5 * 3.25).epsilon(1e-12));
  CHECK(outer_area(built.geometry, 0) == doctest::Approx(0.5 + 4 * 0.5 * 3.25).epsilon(1e-12));
  CHECK(fault_in_seams(built.geometry) == "");
}

TEST_CASE("sisters across a seam touch, whichever cells they lie in") {
  const Built built =
      build({ell(1), boxed({0.5, 1, 0.5}, {1, 2, 5}, 2), boxed({1, 1, 0.5}, {1.5, 2, 5}, 3),
             boxed({1, 1, 5}, {1.5, 2, 5.5}, 4)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  auto areas = contact_areas(built.geometry);
  CHECK(areas[{1, 2}] == doctest::Approx(4.5).epsilon(1e-12));
  CHECK(areas[{2, 1}] == doctest::Approx(4.5).epsilon(1e-12));
  CHECK(areas[{2, 3}] == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(areas[{1, 3}] == 0);
  CHECK(areas[{0, 1}] == 0);
}

TEST_CASE("a solid in the notch of another is its neighbour, and touches both walls") {
  for (const auto& moves : {std::vector<Affine>{}, askew}) {
    const Built built = build({ell(1, moves), boxed({2, 1, 2}, {5, 3, 4}, 2, moves)});
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    for (const Cell& cell : built.geometry.cells) CHECK(cell.parent == 0);
    auto areas = contact_areas(built.geometry);
    CHECK(areas[{0, 1}] == doctest::Approx(2 * 3 + 2 * 2).epsilon(1e-12));
    CHECK(areas[{1, 0}] == doctest::Approx(2 * 3 + 2 * 2).epsilon(1e-12));
  }
}

TEST_CASE("a solid that fills the notch across several cells closes the cube") {
  const Built built = build({ell(1), boxed({2, 0, 2}, {6, 6, 6}, 2)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  auto areas = contact_areas(built.geometry);
  CHECK(areas[{0, 1}] == doctest::Approx(2 * 24).epsilon(1e-12));
  CHECK(outer_area(built.geometry, 0) + outer_area(built.geometry, 1) - 4 * 24 ==
        doctest::Approx(6 * 36).epsilon(1e-12));
}

TEST_CASE("penetration twins: a cross and what it leaves of a cube are in contact all over") {
  // Two bars of 2 x 2 x 6 that cross, and the cube around them without the cross.
  const CsgNode cross_bars =
      merged({csg_box({-3, -1, -1}, {3, 1, 1}), csg_box({-1, -1, -3}, {1, 1, 3})});
  for (const auto& moves : {std::vector<Affine>{}, askew}) {
    Object inner = csg_object(cross_bars, 1, moves);
    Object outer = csg_object(differing({csg_box({-3, -2, -3}, {3, 2, 3}), cross_bars}), 2, moves);
    outer.optical_contact = true;
    const Built built = build({inner, outer});
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    const Geometry& geometry = built.geometry;
    CHECK(fault_in_seams(geometry) == "");
    // Walls: 8 of 2 x 2; top and bottom: twice the cross of 20. The four ends lie bare.
    auto areas = contact_areas(geometry);
    CHECK(areas[{0, 1}] == doctest::Approx(8 * 4 + 2 * 20).epsilon(1e-12));
    CHECK(areas[{1, 0}] == doctest::Approx(8 * 4 + 2 * 20).epsilon(1e-12));
    CHECK(outer_area(geometry, 0) - areas[{0, 1}] == doctest::Approx(4 * 4).epsilon(1e-12));
    for (const Patch& patch : geometry.patches) {
      const bool own = patch.behind == Patch::Behind::seam;
      CHECK((own || patch.behind == Patch::Behind::cell_contact));
    }
  }
}

TEST_CASE("overlaps with concave solids are errors still") {
  CHECK(build({ell(1), boxed({1, 1, 1}, {3, 2, 3}, 2)}).says("overlap"));
  CHECK(build({ell(1), ell(2)}).says("fill the same space"));
  CHECK(build({ell(1), boxed({-1, -1, -1}, {7, 7, 7}, 2)}).messages.empty());  // around all of it
}

TEST_CASE("a camera on a seam stands inside, on the surface outside") {
  Scene scene = scene_of({ell(1)});
  const auto cell_at = [&](const Vec3& p) {
    scene.camera.location = p;
    return build(scene);
  };
  for (const Vec3& p : {Vec3{1, 3, 1}, Vec3{1, 3, 2}, Vec3{2, 3, 1}}) {  // one is on a seam
    const Built built = cell_at(p);
    CHECK(built.geometry.camera_cell > 0);
    CHECK(built.messages.empty());
  }
  CHECK(cell_at({2, 3, 5}).geometry.camera_cell == 0);
  CHECK(cell_at({2, 3, 5}).says("exactly on a surface"));
}

TEST_CASE("sheets in a concave solid are cut at its seams; one in a seam is an error") {
  const Built built =
      build({ell(1), light(polygon({{0.5, 1, 0.5}, {0.5, 1, 5}, {1.5, 1, 5}, {1.5, 1, 0.5}}), 2),
             light(polygon({{0.5, 2, 1}, {5, 2, 1}, {5, 2, 1.5}, {0.5, 2, 1.5}}), 3)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  double sum = 0;
  for (const Sheet& sheet : built.geometry.sheets) {
    CHECK(built.geometry.cells[sheet.cell].object == 0);
    sum += area(sheet.corners);
  }
  CHECK(built.geometry.sheets.size() == 3);
  CHECK(sum == doctest::Approx(4.5 + 2.25).epsilon(1e-13));
  // One of these two planes is a seam, the other is none.
  const Built x = build({ell(1), light(polygon({{2, 1, 0.5}, {2, 2, 0.5}, {2, 2, 1}, {2, 1, 1}}), 2)});
  const Built z = build({ell(1), light(polygon({{0.5, 1, 2}, {0.5, 2, 2}, {1, 2, 2}, {1, 1, 2}}), 2)});
  CHECK(x.failed != z.failed);
  CHECK((x.failed ? x : z).says("just where two of its convex parts meet"));
}

TEST_CASE("random boxes in a random concave solid: what fits inside nests, volumes are kept") {
  const bool ok = rc::check([] {
    const auto number = [](int low, int high) { return 0.5 * *rc::gen::inRange(low, high); };
    const Vec3 cut{number(1, 11), number(1, 11), number(1, 11)};
    const CsgNode outer = differing({csg_box({0, 0, 0}, {6, 6, 6}), csg_box(cut, {9, 9, 9})});
    const Vec3 low{number(0, 10), number(0, 10), number(0, 10)};
    const Vec3 high{low.x + number(1, 8), low.y + number(1, 8), low.z + number(1, 8)};
    const CsgNode inner = csg_box(low, high);
    const bool fits = volume_of(differing({inner, outer})) == 0;
    const bool apart = volume_of(intersected({inner, outer})) == 0;
    const Built built = build({csg_object(inner, 1), csg_object(outer, 2)});
    RC_ASSERT(built.failed == (!fits && !apart));
    if (built.failed) return;
    RC_ASSERT(fault_in_seams(built.geometry) == "");
    for (const Cell& cell : built.geometry.cells) {
      if (cell.object == 0) RC_ASSERT((cell.parent > 0) == fits);
    }
    const Vec3 size = high - low;
    const double volume = size.x * size.y * size.z;
    RC_ASSERT(std::abs(total_volume(built.geometry, 0) - volume) < 1e-12 * volume);
    const double surface = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
    RC_ASSERT(std::abs(outer_area(built.geometry, 0) - surface) < 1e-12 * surface);
  });
  CHECK(ok);
}
