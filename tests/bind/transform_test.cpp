// Transforms: POV-Ray's senses, exact right angles, inverses.
#include <rapidcheck.h>

#include "bound.hpp"
#include "host/bind/affine.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

Affines rotation(Vec3 angle_deg) {
  Affines list;
  append_rotation(list, angle_deg);
  return list;
}

Vec3 some_vector() {
  const auto number = [] { return *rc::gen::inRange(-1000, 1001) / 100.0; };
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

Affines some_transform() {
  Affines list;
  append_rotation(list, some_vector());
  const Vec3 s = some_vector();
  list.push_back(scaling({std::abs(s.x) + 0.1, -std::abs(s.y) - 0.1, std::abs(s.z) + 0.1}));
  list.push_back(translation(some_vector()));
  append_rotation(list, some_vector());
  return list;
}

}  // namespace

TEST_CASE("rotations turn x to y about z, y to z about x, z to x about y, exactly") {
  const auto is = [](Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  CHECK(is(transform_point(rotation({0, 0, 90}), {1, 0, 0}), {0, 1, 0}));
  CHECK(is(transform_point(rotation({90, 0, 0}), {0, 1, 0}), {0, 0, 1}));
  CHECK(is(transform_point(rotation({0, 90, 0}), {0, 0, 1}), {1, 0, 0}));
  CHECK(is(transform_point(rotation({0, 0, -270}), {3, 0, 7}), {0, 3, 7}));
}

TEST_CASE("sines are exact at multiples of 30 degrees") {
  CHECK(sin_deg(30) == 0.5);
  CHECK(sin_deg(-30) == -0.5);
  CHECK(cos_deg(60) == 0.5);
  CHECK(cos_deg(90) == 0);
  CHECK(cos_deg(-720) == 1);
  CHECK(cos_deg(120) == -0.5);
  CHECK(sin_deg(45) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-15));
}

TEST_CASE("rotate <a,b,c> is one step per axis, x first") {
  const Affines list = rotation({90, 90, 0});
  REQUIRE(list.size() == 2);
  check_near(transform_point(list, {0, 1, 0}), {1, 0, 0});  // y to z, then z to x
}

TEST_CASE("a list and its inverse undo each other") {
  CHECK(rc::check([] {
    const Affines list = some_transform();
    const Vec3 p = some_vector();
    const Vec3 back = transform_point(inverse(list), transform_point(list, p));
    RC_ASSERT(length(back - p) < 1e-6 * (1 + length(p)));
  }));
}

TEST_CASE("a point keeps its side of a plane") {
  CHECK(rc::check([] {
    const Affines list = some_transform();
    const HalfSpace plane{some_vector(), 3};
    const Vec3 p = some_vector();
    const double before = dot(plane.normal, p) - plane.offset;
    const HalfSpace moved = transform(list, plane);
    const double after = dot(moved.normal, transform_point(list, p)) - moved.offset;
    RC_PRE(std::abs(before) > 1e-3);
    RC_ASSERT((before > 0) == (after > 0));
    RC_ASSERT(dot(transform_normal(list, plane.normal), moved.normal) > 0);
  }));
}

TEST_CASE("the world is right-handed and in millimetres") {
  const Affine world = to_world(10);
  check_near(transform_point(world, {1, 2, 3}), {10, 20, -30});
  CHECK(determinant(world) == -1000);
  CHECK(determinant_sign({from_crystal(), to_world(1)}) == 1);
}

TEST_CASE("transform { inverse } and declared transforms") {
  const Bound b = bind_clean(lit +
                             "#declare T = transform { rotate 90*z translate x }"
                             "box { 0, 1 transform { T inverse } interior { ior 1.5 } }");
  const Affines& list = b.scene.objects.at(0).transforms;
  check_near(transform_point(list, {1, 1, 0}), Vec3{1, 0, 0} * 10, 1e-12);
}

TEST_CASE("matrix is row vectors with the translation last") {
  const Bound b =
      bind_clean(lit + "box { 0, 1 matrix <0,1,0, -1,0,0, 0,0,1, 5,6,7> interior { ior 1.5 } }");
  check_near(transform_point(b.scene.objects.at(0).transforms, {1, 0, 0}), Vec3{5, 7, -7} * 10);
}

TEST_CASE("a scale of 0 becomes 1 with POV-Ray's warning") {
  const Bound b = bind_text(lit + "box { 0, 1 scale <1, 0, 2> interior { ior 1.5 } }");
  CHECK(b.text().find("Illegal Value: Scale Y by 0.0. Changed to 1.0.") != std::string::npos);
  CHECK(determinant(b.scene.objects.at(0).transforms.at(0)) == 2);
}

}  // namespace nicol
