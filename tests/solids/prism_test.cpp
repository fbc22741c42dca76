// Prisms: even-odd outlines as convex cells that meet in whole faces.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

using Outline = std::vector<std::array<double, 2>>;

Built built_prism(std::vector<Outline> contours, const std::vector<Affine>& moves = {}) {
  Object object = solid(PrismShape{std::move(contours), -0.5, 1.5}, 4);
  object.kind = "prism";
  object.transforms = moves;
  return build({object});
}

double total_volume(const Geometry& geometry) {
  double sum = 0;
  for (std::size_t i = 1; i < geometry.cells.size(); ++i)
    sum += volume(geometry, geometry.cells[i]);
  return sum;
}

// Each seam covers a whole face, has its twin, and seams alone have shape_face -1.
void check_seams(const Geometry& geometry) {
  std::size_t seam_faces = 0;
  for (const Face& face : geometry.faces) seam_faces += face.shape_face == -1;
  CHECK(geometry.patches.size() == seam_faces);
  for (std::size_t cell = 1; cell < geometry.cells.size(); ++cell) {
    for (const Patch* patch : patches_of(geometry, static_cast<int>(cell))) {
      CHECK(patch->behind == Patch::Behind::seam);
      CHECK(patch->edges.empty());
      CHECK(geometry.faces[patch->face].shape_face == -1);
      int twins = 0;
      for (const Patch* twin : patches_of(geometry, patch->other_cell)) {
        twins += twin->face == patch->other_face && twin->other_face == patch->face &&
                 twin->other_cell == static_cast<int>(cell);
      }
      CHECK(twins == 1);
      const Plane &own = geometry.faces[patch->face].plane,
                  &other = geometry.faces[patch->other_face].plane;
      CHECK(own.normal.x == -other.normal.x);
      CHECK(own.normal.y == -other.normal.y);
      CHECK(own.normal.z == -other.normal.z);
      CHECK(own.offset_mm == -other.offset_mm);
    }
  }
}

Outline regular(int count, double radius) {
  Outline out;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * pi * i / count;
    out.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return out;
}

}  // namespace

TEST_CASE("a convex outline gives one cell, points on straight stretches or given twice included") {
  for (const Outline& outline :
       {Outline{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, Outline{{0, 2}, {2, 2}, {2, 0}, {0, 0}},
        Outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 0}}}) {
    const Built built = built_prism({outline});
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    REQUIRE(built.geometry.cells.size() == 2);
    CHECK(built.geometry.cells[1].face_count == 6);
    CHECK(total_volume(built.geometry) == doctest::Approx(8).epsilon(1e-14));
  }
  const Built round = built_prism({regular(100, 3)});
  REQUIRE(round.geometry.cells.size() == 2);
  CHECK(round.geometry.cells[1].face_count == 102);
  CHECK(total_volume(round.geometry) ==
        doctest::Approx(2 * 50 * 9 * std::sin(2 * pi / 100)).epsilon(1e-12));
}

TEST_CASE("faces of a prism tell which edge of the outline they stand on") {
  const Built built = built_prism({{{0, 0}, {3, 0}, {3, 1}, {0, 1}}});
  REQUIRE(built.geometry.faces.size() == 6);
  const std::vector<Vec3> normals{{0, -1, 0}, {0, 1, 0}, {0, 0, -1},
                                  {1, 0, 0},  {0, 0, 1}, {-1, 0, 0}};
  for (int i = 0; i < 6; ++i) {
    const Face& face = built.geometry.faces[i];
    CHECK(face.shape_face == i);
    CHECK(dot(face.plane.normal, normals[i]) == 1);
  }
}

TEST_CASE("an L and a cross: volumes, few cells, whole seams") {
  const Outline ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Outline cross_outline{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                              {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  for (const std::vector<Affine>& moves :
       {std::vector<Affine>{},
        {rotate_x(33), rotate_y(25), translate(0.1, 0.2, 0.3), scale(1, 1, -1)}}) {
    const Built one = built_prism({ell}, moves);
    REQUIRE_MESSAGE(one.messages.empty(), one.first());
    CHECK(one.geometry.cells.size() == 3);
    CHECK(total_volume(one.geometry) == doctest::Approx(10).epsilon(1e-12));
    check_seams(one.geometry);

    const Built two = built_prism({cross_outline}, moves);
    REQUIRE_MESSAGE(two.messages.empty(), two.first());
    CHECK(two.geometry.cells.size() <= 6);
    CHECK(total_volume(two.geometry) == doctest::Approx(10).epsilon(1e-12));
    check_seams(two.geometry);
  }
}

TEST_CASE("a concave prism with a hole: cells share a centre and add up to area times height") {
  const Outline outer{{0, 0}, {6, 0}, {6, 5}, {3, 3.5}, {0, 5}};
  const Outline hole{{1, 1}, {4, 1}, {4, 2}, {2.5, 1.5}, {1, 2}};
  const double outer_area = 30 - 6 * 1.5 / 2, hole_area = 3 - 3 * 0.5 / 2;
  for (const std::vector<Affine>& moves :
       {std::vector<Affine>{}, {rotate_x(33), rotate_y(25), scale(1, 1, -1)}}) {
    const Built built = built_prism({outer, hole}, moves);
    REQUIRE_MESSAGE(built.messages.empty(), built.first());
    CHECK(total_volume(built.geometry) ==
          doctest::Approx(2 * (outer_area - hole_area)).epsilon(1e-12));
    check_seams(built.geometry);
    for (std::size_t i = 1; i < built.geometry.cells.size(); ++i) {
      CHECK(built.geometry.cells[i].centre_mm.x == built.geometry.cells[1].centre_mm.x);
      CHECK(counts(built.geometry, built.geometry.cells[i]).closed);
    }
  }
}

TEST_CASE("outlines that cross themselves or each other follow the even-odd rule") {
  // A bow tie, and two squares that overlap in a unit square, which is out.
  CHECK(total_volume(built_prism({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}).geometry) ==
        doctest::Approx(1).epsilon(1e-14));
  const Built two =
      built_prism({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  CHECK(total_volume(two.geometry) == doctest::Approx(12).epsilon(1e-14));
  check_seams(two.geometry);
  // A pentagram drawn in one stroke: its five points without the core.
  Outline star;
  for (int i = 0; i < 5; ++i) star.push_back({std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5)});
  const Built points = built_prism({star});
  REQUIRE_MESSAGE(points.messages.empty(), points.first());
  const double tip_height =
      1 - std::cos(2 * pi / 5);  // from a tip to the core, which is cos(72 deg) from the centre
  CHECK(points.geometry.cells.size() == 6);
  CHECK(total_volume(points.geometry) ==
        doctest::Approx(2 * 5 * tip_height * tip_height * std::tan(pi / 10)).epsilon(1e-12));
}

TEST_CASE("outlines without area and prisms without height are errors") {
  CHECK(built_prism({{{0, 0}, {1, 1}, {2, 2}}}).says("encloses no area"));
  CHECK(built_prism({}).says("encloses no area"));
  CHECK(built_prism({{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 0}, {1, 1}}}).says("encloses no area"));
  Object flat = solid(PrismShape{{{{0, 0}, {1, 0}, {1, 1}}}, 2, 2}, 4);
  CHECK(build({flat}).says("no height"));
}
