// Sheets: flatness, direction, discs, and what they lie in.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {
double total_area(const Geometry& geometry, int cell) {
  double sum = 0;
  for (const Sheet& sheet : geometry.sheets) {
    if (sheet.cell == cell) sum += area(sheet.corners);
  }
  return sum;
}
}  // namespace

TEST_CASE("a sheet faces the side from which its contour runs counter-clockwise, in the world") {
  for (const std::vector<Affine>& moves :
       {std::vector<Affine>{}, {scale(1, 1, -1)}, {scale(-1, 1, -1)}}) {
    for (bool turned : {false, true}) {
      PolygonShape shape = floor_square(-1, 1, 2);
      if (turned) std::reverse(shape.contours[0].begin(), shape.contours[0].end());
      Object lamp = light(shape, 1);
      lamp.transforms = moves;
      const Built built = build({lamp});
      REQUIRE(built.geometry.sheets.size() == 1);
      const Sheet& sheet = built.geometry.sheets[0];
      const bool mirrored = moves.size() == 1 && moves[0].m[0][0] > 0;
      CHECK(sheet.plane.normal.y == (turned == mirrored ? 1 : -1));
      CHECK(dot(area_vector(sheet.corners), sheet.plane.normal) ==
            doctest::Approx(4).epsilon(1e-15));
      CHECK(sheet.centre_mm.y + sheet.plane.normal.y * sheet.plane.offset_mm == doctest::Approx(2));
      for (const Plane& edge : sheet.edges) CHECK(edge.offset_mm == 1);
    }
  }
}

TEST_CASE("a frame is a sheet with a hole") {
  PolygonShape frame = floor_square(-2, 2, 0);
  frame.contours.push_back(floor_square(-1, 1, 0).contours[0]);
  const Built built = build({light(frame, 1)});
  CHECK(total_area(built.geometry, 0) == doctest::Approx(12).epsilon(1e-14));
}

TEST_CASE("points that are not quite flat are moved to the plane; far off is told") {
  const double c = std::cos(0.3), s = std::sin(0.3);
  std::vector<Vec3> points;
  for (int i = 0; i < 7; ++i) {
    const double a = 2 * pi * i / 7;
    points.push_back({std::cos(a), c * std::sin(a), s * std::sin(a)});
  }
  const Built built = build({light(polygon(points), 1)});
  CHECK(built.messages.empty());
  CHECK(total_area(built.geometry, 0) ==
        doctest::Approx(3.5 * std::sin(2 * pi / 7)).epsilon(1e-12));
  points[3].y += 1e-3;
  CHECK(build({light(polygon(points), 1)}).says("not flat"));
  CHECK(build({light(polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), 1)}).says("one line"));
}

TEST_CASE("a sheet through a solid is cut at its surface") {
  const std::vector<Affine> move{rotate_x(25), rotate_y(25), left_to_right()};
  Object cube = solid(box({-1, -1, -1}, {1, 1, 1}), 1), lamp = light(floor_square(-3, 3, 0.5), 2);
  cube.transforms = lamp.transforms = move;
  Built built = build({cube, lamp});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  CHECK(total_area(built.geometry, 0) == doctest::Approx(3200).epsilon(1e-12));
  CHECK(total_area(built.geometry, 1) == doctest::Approx(400).epsilon(1e-12));
  CHECK(built.geometry.cells[1].sheets.size() == 1);
  CHECK(built.geometry.patches.empty());

  // Nested twice, and standing on a diagonal.
  Object core = solid(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), 3);
  Object leaf = light(polygon({{-2, -2, -2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, -2}}), 2);
  core.transforms = leaf.transforms = move;
  built = build({cube, leaf, core});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  const double r = std::sqrt(2.0) * 100;
  CHECK(total_area(built.geometry, 0) == doctest::Approx(12 * r).epsilon(1e-12));
  CHECK(total_area(built.geometry, 1) == doctest::Approx(3 * r).epsilon(1e-12));
  CHECK(total_area(built.geometry, 2) == doctest::Approx(1 * r).epsilon(1e-12));
}

TEST_CASE(
    "a sheet wholly inside a solid is its sheet; touching from inside is a contact of neither") {
  const Built built =
      build({solid(box({-1, -1, -1}, {1, 1, 1}), 1), light(floor_square(-1, 1, 0), 2),
             solid(box({-1, 0, -1}, {0, 1, 1}), 3)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  REQUIRE(built.geometry.sheets.size() == 1);
  CHECK(built.geometry.sheets[0].cell == 1);
  CHECK(patches_of(built.geometry, 1).empty());
  REQUIRE(patches_of(built.geometry, 2).size() == 1);  // the inner solid stands on the inner light
  CHECK(patches_of(built.geometry, 2)[0]->behind == Patch::Behind::light);
}

TEST_CASE("discs: circles stay circles, ellipses and cuts are errors") {
  const DiscShape disc{{0, 0, 0}, {0, 2, 0}, 1, 0};
  Object lamp = light(disc, 6);
  lamp.transforms = {scale(3, 7, 3), rotate_x(25), left_to_right()};
  Built built = build({lamp});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  CHECK(built.geometry.sheets[0].disc.radius_mm == doctest::Approx(30).epsilon(1e-14));
  CHECK(built.geometry.sheets[0].edges.empty());
  lamp.transforms = {scale(3, 7, 3.001)};
  CHECK(build({lamp}).says("ellipse"));

  const Object cube = solid(box({-2, -2, -2}, {2, 2, 2}), 1);
  CHECK(build({cube, light(disc, 6)}).geometry.sheets[0].cell == 1);
  CHECK(build({cube, light(DiscShape{{0, 0, 0}, {0, 1, 0}, 2, 0}, 6)}).geometry.sheets[0].cell ==
        1);
  CHECK(build({cube, light(DiscShape{{0, 0, 0}, {0, 1, 0}, std::nextafter(2.0, 3.0), 0}, 6)})
            .says("passes through"));
  CHECK(build({cube, light(DiscShape{{3, 3, 0}, {1, 1, 0}, 9, 0}, 6)}).geometry.sheets[0].cell ==
        0);
  CHECK(build({cube, light(DiscShape{{2.5, 0, 0}, {0, 1, 0}, 1, 0}, 6)}).failed);
  CHECK(build({cube, light(DiscShape{{2.9, 0, 2.9}, {0, 1, 0}, 1, 0}, 6)}).messages.empty());
}

TEST_CASE("two sheets in the same place are an error, side by side they are not") {
  CHECK(build({light(floor_square(0, 2, 0), 1), polarizer(floor_square(1, 3, 0), 2)})
            .says("same place"));
  CHECK(build({light(floor_square(0, 1, 0), 1), polarizer(floor_square(1, 2, 0), 2)})
            .messages.empty());
  const Object ring = light(DiscShape{{0, 0, 0}, {0, 1, 0}, 2, 1}, 1);
  CHECK(build({ring, light(DiscShape{{0, 0, 0}, {0, 1, 0}, 1, 0}, 2)}).messages.empty());
  CHECK(build({ring, light(DiscShape{{0.5, 0, 0}, {0, 1, 0}, 1, 0}, 2)}).says("same place"));
}
