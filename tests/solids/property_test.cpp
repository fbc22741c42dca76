// Random solids: half-spaces tangent to a sphere close to a polyhedron whose every corner obeys
// every plane.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

double unit_number() { return *rc::gen::inRange(-1000000, 1000001) / 1e6; }

Vec3 direction() {
  const double z = unit_number(), a = pi * unit_number(), r = std::sqrt(1 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}

}  // namespace

TEST_CASE("random half-spaces tangent to a sphere") {
  const bool ok = rc::check([] {
    // A tetrahedron around the sphere closes it; the rest is random.
    ConvexShape shape{{{{1, 1, 1}, 3}, {{1, -1, -1}, 3}, {{-1, 1, -1}, 3}, {{-1, -1, 1}, 3}}};
    const int count = *rc::gen::inRange(0, 60);
    const double radius = 1 + 0.5 * unit_number();
    for (int i = 0; i < count; ++i) shape.faces.push_back({direction(), radius});
    Object object = solid(shape, 1);
    object.transforms = {rotate_x(180 * unit_number()), translate(unit_number(), 7, unit_number()),
                         rotate_y(180 * unit_number()), left_to_right()};
    const Built built = build({object});
    RC_ASSERT(built.messages.empty());
    const Cell& cell = built.geometry.cells[1];
    const Counts c = counts(built.geometry, cell);
    RC_ASSERT(c.closed);
    RC_ASSERT(c.corners - c.edges + c.faces == 2);
    for (const Face& outer : built.geometry.faces) {
      for (const Vec3& corner : outer.corners) {
        for (const Face& face : built.geometry.faces) {
          const double height =
              dot(face.plane.normal, corner - cell.centre_mm) - face.plane.offset_mm;
          RC_ASSERT(height < 1e-12 * 100);  // coordinates reach 100 mm
          if (&face == &outer) RC_ASSERT(std::abs(height) < 1e-12 * 100);
        }
      }
      RC_ASSERT(dot(area_vector(outer.corners), outer.plane.normal) > 0);
    }
  });
  CHECK(ok);
}

TEST_CASE("random stacks that share their transforms touch exactly") {
  const bool ok = rc::check([] {
    const double height = unit_number(), half = 2 + unit_number(), shift = 0.9 * unit_number();
    std::vector<Object> objects{
        solid(box({-1, height, -1}, {1, height + 1, 1}), 1),
        solid(box({shift - half, height - 1, -half}, {shift + half, height, half}), 2),
        light(floor_square(-9, 9, height - 1), 3)};
    const std::vector<Affine> moves{scale(1 + 0.3 * unit_number(), 1, 1),
                                    rotate_x(180 * unit_number()),
                                    translate(unit_number(), 1e3 * unit_number(), 5),
                                    rotate_y(180 * unit_number()), left_to_right()};
    for (Object& object : objects) object.transforms = moves;
    const Built built = build(objects);
    RC_ASSERT(built.messages.empty());
    RC_ASSERT(built.geometry.patches.size() == 3u);
  });
  CHECK(ok);
}

TEST_CASE("random star outlines: the cells of a prism add up to area times height") {
  const bool ok = rc::check([] {
    const int count = *rc::gen::inRange(3, 30);
    std::vector<std::array<double, 2>> star;
    for (int i = 0; i < count; ++i) {
      const double a = 2 * pi * i / count, r = 1.5 + unit_number();
      star.push_back({r * std::cos(a), r * std::sin(a)});
    }
    double twice_area = 0;
    for (int i = 0; i < count; ++i) {
      const auto &p = star[i], &q = star[(i + 1) % count];
      twice_area += p[0] * q[1] - p[1] * q[0];
    }
    const Built built = build({solid(PrismShape{{star}, 0, 2}, 1)});
    RC_ASSERT(built.messages.empty());
    double sum = 0;
    for (std::size_t i = 1; i < built.geometry.cells.size(); ++i)
      sum += volume(built.geometry, built.geometry.cells[i]);
    RC_ASSERT(std::abs(sum - std::abs(twice_area)) < 1e-12 * std::abs(twice_area));
    RC_ASSERT(static_cast<int>(built.geometry.cells.size()) <= count);
  });
  CHECK(ok);
}
