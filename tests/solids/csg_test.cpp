// CSG of half-space solids: volumes, cells, seams and surfaces against closed forms.
#include "csg_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace nicol;
using namespace nicol::test;

namespace {

const std::vector<Affine> askew{rotate_x(33), rotate_y(25), translate(0.1, 0.2, 0.3),
                                scale(1, 1, -1)};

struct Expected {
  double volume, area;
  int cells;
};

void check(const CsgNode& node, const Expected& expected) {
  for (const std::vector<Affine>& moves : {std::vector<Affine>{}, askew}) {
    const Built built = built_csg(node, moves);
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    const Geometry& geometry = built.geometry;
    CHECK(total_volume(geometry) == doctest::Approx(expected.volume).epsilon(1e-12));
    CHECK(outer_area(geometry) == doctest::Approx(expected.area).epsilon(1e-12));
    CHECK(static_cast<int>(geometry.cells.size()) == expected.cells + 1);
    CHECK(fault_in_seams(geometry) == "");
    const Vec3 closed = outer_area_vector(geometry);
    CHECK(std::sqrt(dot(closed, closed)) < 1e-12 * expected.area);
    for (std::size_t i = 1; i < geometry.cells.size(); ++i) {
      CHECK(counts(geometry, geometry.cells[i]).closed);
      CHECK(geometry.cells[i].centre_mm.x == geometry.cells[1].centre_mm.x);
    }
  }
}

const CsgNode cube = csg_box({0, 0, 0}, {2, 2, 2});

}  // namespace

TEST_CASE("a cube without a corner: three cells") {
  check(differing({cube, csg_box({1, 1, 1}, {3, 3, 3})}), {7, 24, 3});
}

TEST_CASE("a cube without half of it stays one cell") {
  check(differing({cube, csg_box({-1, 1, -1}, {3, 3, 3})}), {4, 16, 1});
}

TEST_CASE("a tunnel, a cavity, a frame") {
  check(differing({csg_box({0, 0, 0}, {3, 3, 3}), csg_box({1, 1, -1}, {2, 2, 4})}), {24, 64, 4});
  check(differing({csg_box({0, 0, 0}, {3, 3, 3}), csg_box({1, 1, 1}, {2, 2, 2})}), {26, 60, 6});
  const CsgNode x = csg_box({-1, 1, 1}, {4, 2, 2}), y = csg_box({1, -1, 1}, {2, 4, 2}),
                z = csg_box({1, 1, -1}, {2, 2, 4});
  // The Menger sponge's first step: 20 of 27 cubes; 6 faces of 8 squares, 6 tunnels of 4.
  const Built sponge = built_csg(differing({csg_box({0, 0, 0}, {3, 3, 3}), merged({x, y, z})}));
  CHECK(total_volume(sponge.geometry) == doctest::Approx(20).epsilon(1e-14));
  CHECK(outer_area(sponge.geometry) == doctest::Approx(72).epsilon(1e-14));
  CHECK(sponge.geometry.cells.size() <= 1 + 16);
  CHECK(fault_in_seams(sponge.geometry) == "");
}

TEST_CASE("merge: overlapping, crossing, touching, in one another, identical") {
  check(merged({cube, csg_box({1, 1, 1}, {3, 3, 3})}), {15, 42, 4});
  check(merged({csg_box({-3, -1, -1}, {3, 1, 1}), csg_box({-1, -3, -1}, {1, 3, 1})}),
        {40, 2 * 20 + 24 * 2, 3});
  check(merged({cube, csg_box({2, 0, 0}, {4, 2, 2})}), {16, 40, 1});  // together convex
  check(merged({cube, csg_box({2, 0, 0}, {4, 1, 1})}), {10, 24 + 8, 2});
  check(merged({cube, csg_box({0.5, 0.5, 0.5}, {1, 1, 1})}), {8, 24, 1});
  check(merged({cube, cube, cube}), {8, 24, 1});
  check(merged({cube, csg_box({2, 2, 0}, {4, 4, 2})}), {16, 48, 2});  // along an edge
  check(merged({cube, csg_box({2, 2, 2}, {4, 4, 4})}), {16, 48, 2});  // in a corner
  check(merged({cube, csg_box({5, 0, 0}, {6, 1, 1})}), {9, 30, 2});
}

TEST_CASE("intersections of what is not convex") {
  const CsgNode ell = csg_leaf(PrismShape{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}, 0, 1});
  check(intersected({ell, csg_box({0, 0, 0}, {2, 1, 2})}), {3, 2 * 3 + 8, 2});
  check(intersected({ell, csg_box({0, 0, 0}, {1, 1, 1})}), {1, 6, 1});
  check(differing({ell, csg_box({-1, -1, 1}, {4, 4, 4})}), {3, 14, 1});
  // A stella octangula within the cube: two tetrahedra, 8 corners on an octahedron in common.
  ConvexShape one{{{{1, 1, 1}, 1}, {{1, -1, -1}, 1}, {{-1, 1, -1}, 1}, {{-1, -1, 1}, 1}}}, two = one;
  for (HalfSpace& face : two.faces) face.normal = -1 * face.normal;
  const double tetrahedron = 8.0 / 3, octahedron_in = tetrahedron / 2;
  check(intersected({csg_leaf(one), csg_leaf(two)}), {octahedron_in, 8 * std::sqrt(3) / 2, 1});
  const Built star = built_csg(merged({csg_leaf(one), csg_leaf(two)}));
  CHECK(total_volume(star.geometry) ==
        doctest::Approx(2 * tetrahedron - octahedron_in).epsilon(1e-12));
  CHECK(outer_area(star.geometry) == doctest::Approx(24 * std::sqrt(3) / 2).epsilon(1e-12));
  CHECK(star.geometry.cells.size() == 1 + 5);
}

TEST_CASE("planes and inverses: what is open may cut, and be bounded") {
  check(differing({cube, half_space({1, 0, 0}, 1)}), {4, 16, 1});
  check(differing({cube, inverse(half_space({1, 0, 0}, 0.5))}), {2, 2 * 4 + 4, 1});
  check(intersected({cube, inverse(csg_box({1, 1, 1}, {3, 3, 3}))}), {7, 24, 3});
  check(intersected({half_space({1, 0, 0}, 1), half_space({0, 1, 0}, 1), half_space({0, 0, 1}, 1),
                     half_space({-1, 0, 0}, 0), inverse(half_space({0, 1, 0}, 0)),
                     inverse(half_space({0, 0, 1}, 0))}),
        {1, 6, 1});
  // Two open wedges merged, then bounded: a cube without a quarter.
  check(intersected({merged({half_space({1, 0, 0}, 1), half_space({0, 1, 0}, 1)}), cube}),
        {6, 2 * 3 + 8 * 2, 2});
  check(inverse(merged({inverse(cube), half_space({1, 0, 0}, 1)})), {4, 16, 1});
}

TEST_CASE("an L from CSG is the L that a prism gives, cell by cell") {
  const PrismShape outline{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}, 0, 2};
  const CsgNode ell = differing({csg_box({0, 0, 0}, {3, 2, 3}), csg_box({1, -1, 1}, {4, 3, 4})});
  for (const std::vector<Affine>& moves : {std::vector<Affine>{}, askew}) {
    Object prism = solid(outline, 1);
    prism.transforms = moves;
    const Built one = build({prism}), other = built_csg(ell, moves);
    CHECK(outer_area(one.geometry) == doctest::Approx(outer_area(other.geometry)).epsilon(1e-14));
    CHECK(one.geometry.cells.size() == other.geometry.cells.size());
    const auto planes = [](const Geometry& geometry) {
      std::vector<std::array<double, 4>> out;
      for (const Face& face : geometry.faces) {
        const Vec3& n = face.plane.normal;
        if (face.shape_face >= 0) out.push_back({n.x, n.y, n.z, face.plane.offset_mm});
      }
      std::sort(out.begin(), out.end());
      out.erase(std::unique(out.begin(), out.end()), out.end());
      return out;
    };
    CHECK(planes(one.geometry) == planes(other.geometry));  // to the last bit
  }
}

TEST_CASE("faces tell which face of which leaf they are, seams none") {
  const Built built = built_csg(differing({cube, csg_box({1, 1, -1}, {3, 3, 3})}));
  REQUIRE(built.geometry.cells.size() == 3);
  int of_cutter = 0, seams = 0;
  for (const Face& face : built.geometry.faces) {
    if (face.shape_face < 0) {
      ++seams;
      continue;
    }
    REQUIRE(face.shape_face < 12);
    if (face.shape_face < 6) continue;
    ++of_cutter;  // -x or -y of the second box, turned inside out
    CHECK((face.shape_face == 6 || face.shape_face == 8));
    CHECK((face.shape_face == 6 ? face.plane.normal.x : face.plane.normal.y) == 1);
  }
  CHECK(of_cutter == 2);
  CHECK(seams == 1);
}

TEST_CASE("a cut along an inner plane of a prism counts as the face that lies in it") {
  const CsgNode ell = csg_leaf(PrismShape{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}, 0, 1});
  for (const auto& cut : {csg_box({1, -1, -1}, {9, 9, 9}), csg_box({-1, -1, 1}, {9, 9, 9})}) {
    const Built built = built_csg(differing({ell, cut}));
    REQUIRE(built.geometry.cells.size() == 2);
    for (const Face& face : built.geometry.faces) CHECK(face.shape_face >= 0);
  }
}

TEST_CASE("empty, open and unsound trees are errors that name both places") {
  CsgNode far = csg_box({5, 5, 5}, {6, 6, 6});
  far.where.line = 7;
  CsgNode both = intersected({cube, far});
  both.where.line = 3;
  const Built empty = built_csg(both);
  CHECK(empty.says("'intersection' at line 3 encloses nothing: 'box' at line 7 leaves nothing"));
  CHECK(empty.messages.at(0).where.line == 7);
  CHECK(built_csg(differing({cube, csg_box({-1, -1, -1}, {3, 3, 3})})).says("leaves nothing"));
  CHECK(built_csg(differing({cube, cube})).says("leaves nothing"));

  CsgNode plane = half_space({0, 1, 0}, 0);
  plane.where.line = 9;
  const Built open = built_csg(merged({cube, plane}));
  CHECK(open.says("'merge' at line 0 is not closed"));
  CHECK(open.says("nothing bounds 'plane' at line 9"));
  CHECK(open.messages.at(0).where.line == 9);
  CHECK(built_csg(inverse(cube)).says("not closed"));
  CHECK(built_csg(intersected({plane, inverse(cube)})).says("<0, -1, 0>"));

  CHECK(built_csg(differing({cube, csg_box({0, 0, 0}, {1, 0, 1})})).says("encloses nothing"));
  CHECK(built_csg(differing({cube, csg_box({0, 0, 0}, {1, 1, 1}, {scale(1, 0, 1)})}))
            .says("flattened"));
  CHECK(built_csg(differing({cube, csg_leaf(PrismShape{{{{0, 0}, {1, 1}}}, 0, 1})}))
            .says("encloses no area"));
  CHECK(built_csg(merged({})).says("holds no solid"));
}

TEST_CASE("faces that should coincide but were rounded apart are told of") {
  const double x = std::nextafter(2.0, 3.0);
  CHECK(built_csg(merged({cube, csg_box({x, 0, 0}, {4, 2, 2})})).says("mm of each other"));  // a slit
  CHECK(built_csg(merged({cube, csg_box({0, 0, 0}, {x, 1, 1})})).says("4.44e-16 mm of each other"));
  CHECK(built_csg(differing({csg_box({0, 0, 0}, {x, 2, 2}), cube})).says("do not coincide"));
  CHECK_FALSE(built_csg(merged({cube, csg_box({2.001, 0, 0}, {4, 2, 2})})).says("of each other"));
}

TEST_CASE("more cells than there may be are an error") {
  std::vector<CsgNode> operands{csg_box({0, 0, 0}, {200, 200, 1})};
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j)
      operands.push_back(csg_box({3.0 * i + 1, 3.0 * j + 1, -1}, {3.0 * i + 2, 3.0 * j + 2, 2}));
  }
  CHECK(built_csg(differing(operands)).says("more than 2000 convex cells"));
}
