// Shapes, unions, instances, media of solids.
#include "bound.hpp"
#include "host/bind/affine.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

const ConvexShape& convex(const Bound& b, int i = 0) {
  return std::get<ConvexShape>(b.scene.objects.at(i).shape);
}

// Whether a point of the shape's own coordinates is inside.
bool holds(const ConvexShape& shape, Vec3 p) {
  for (const HalfSpace& h : shape.faces)
    if (dot(h.normal, p) > h.offset) return false;
  return true;
}

}  // namespace

TEST_CASE("box: swapped corners, the conversion last") {
  const Bound b = bind_clean(lit + "box { <1, 2, 3>, <-1, 0, 0> translate x" + glass + "}");
  CHECK(convex(b).faces.size() == 6);
  CHECK(holds(convex(b), {0.9, 1.9, 2.9}));
  CHECK_FALSE(holds(convex(b), {0, -0.1, 1}));
  const Affines& list = b.scene.objects[0].transforms;
  REQUIRE(list.size() == 2);
  CHECK(list.back().m[2][2] == -10);
  CHECK(b.scene.objects[0].kind == "box");
}

TEST_CASE("intersection: planes with transforms of their own, boxes and instances") {
  const Bound b = bind_clean(
      lit +
      "#declare P = plane { x, 0 }"
      "intersection { plane { <0, 2, 0>, 3 } object { P translate 2*x } plane { x, 1 rotate 180*y }"
      " plane { -y, 0 } box { -5, 5 scale <1, 1, 0.1> } bounded_by { sphere { 0, 9 } }" +
      glass + "}");
  const ConvexShape& s = convex(b);
  CHECK(s.faces.size() == 10);
  CHECK(holds(s, {1.9, 2.9, 0.4}));  // plane { <0,2,0>, 3 } is y = 3
  CHECK_FALSE(holds(s, {1.9, 3.1, 0}));
  CHECK_FALSE(holds(s, {2.1, 1, 0}));
  CHECK_FALSE(holds(s, {-1.1, 1, 0}));
  CHECK_FALSE(holds(s, {0, 1, 0.6}));
}

TEST_CASE("difference cuts by planes, inverse turns a plane round") {
  const Bound b = bind_clean(lit + "difference { box { -1, 1 } plane { x, 0 }" + glass +
                             "}"
                             "intersection { box { -1, 1 } plane { x, 0 inverse }" +
                             glass + "}");
  for (int i : {0, 1}) {
    CHECK(holds(convex(b, i), {0.5, 0, 0}));
    CHECK_FALSE(holds(convex(b, i), {-0.5, 0, 0}));
  }
}

TEST_CASE("crystal is right-handed: its axes reach the world unmirrored") {
  const Bound b = bind_clean(lit +
                             "crystal { facet <1,0,0>, 1 face <-1,0,0>, 1 facet y, 1 facet -y, 1"
                             " facet <0,0,1>, 2 facet <0,0,-1>, 1 facet <1,1,1>, 1.5" +
                             glass + "}");
  CHECK(convex(b).faces.size() == 7);
  const Affines& list = b.scene.objects[0].transforms;
  check_near(transform_point(list, {1, 0, 0}), {0, 0, 10});  // towards the viewer
  check_near(transform_point(list, {0, 1, 0}), {10, 0, 0});  // to the right
  check_near(transform_point(list, {0, 0, 2}), {0, 20, 0});  // up
  CHECK(determinant_sign(list) == 1);
  CHECK(convex(b).faces[5].offset ==
        doctest::Approx(1.5 * std::sqrt(3)));  // distance, not d of the text
}

TEST_CASE("a crystal inside an intersection keeps its handedness") {
  const Bound b = bind_clean(lit +
                             "intersection { crystal { facet <0,0,1>, 2 facet <0,0,-1>, 1 }"
                             " box { <-1,-9,-1>, <1,9,1> }" +
                             glass + "}");
  CHECK(holds(convex(b), {0, 1.9, 0}));  // crystal's +Z is the scene's +y
  CHECK_FALSE(holds(convex(b), {0, -1.1, 0}));
}

TEST_CASE("prism: points are (x, z), contours closed by repetition, heights sorted") {
  const Bound b =
      bind_clean(lit +
                 "prism { linear_sweep linear_spline 2, 1, 9, <0,0>, <4,0>, <4,4>, <0,4>, <0,0>,"
                 " <1,1>, <2,1>, <1,2>, <1,1>" +
                 glass + "}");
  const PrismShape& p = std::get<PrismShape>(b.scene.objects.at(0).shape);
  REQUIRE(p.contours.size() == 2);
  CHECK(p.contours[0].size() == 4);
  CHECK(p.contours[1].size() == 3);
  CHECK(p.y_min == 1);
  CHECK(p.y_max == 2);
}

TEST_CASE("polygon and disc shine or polarize") {
  const Bound b = bind_clean(lit +
                             "polygon { 4, 0, x, y, 0 luminous { } }"
                             "disc { 0, y, 2, 0.5 polarizer { ideal angle 0 } }");
  CHECK(b.scene.objects.at(0).emission == 0);
  CHECK(std::get<PolygonShape>(b.scene.objects[0].shape).contours.at(0).size() == 3);
  CHECK(b.scene.objects.at(1).polarizer == 0);
  CHECK(std::get<DiscShape>(b.scene.objects[1].shape).hole_radius == 0.5);
}

TEST_CASE("an unclosed polygon is closed with POV-Ray's warning") {
  const Bound b = bind_text(lit + "polygon { 3, 0, x, y luminous { } }");
  CHECK(b.text().find("Polygon not closed. Closing it.") != std::string::npos);
  CHECK(b.scene.objects.size() == 1);
}

TEST_CASE("union lends its transforms and its interior") {
  const Bound b = bind_clean(lit +
                             "union { box { 0, 1 } box { 0, 1 translate 5*x interior { ior 2 } }"
                             " translate y" +
                             glass + "}");
  REQUIRE(b.scene.objects.size() == 2);
  CHECK(b.scene.media.at(*b.scene.objects[0].medium).n[0][0] == 1.5);
  CHECK(b.scene.media.at(*b.scene.objects[1].medium).n[0][0] == 2);
  check_near(transform_point(b.scene.objects[1].transforms, {0, 0, 0}), {50, 10, 0});
}

TEST_CASE("instances: object { X }, box { X } and bare X") {
  const Bound b = bind_clean(lit + "#declare X = box { 0, 1 translate x" + glass +
                             "}"
                             "object { X translate x } box { X rotate 90*z } X");
  REQUIRE(b.scene.objects.size() == 3);
  check_near(transform_point(b.scene.objects[0].transforms, {0, 0, 0}), {20, 0, 0});
  check_near(transform_point(b.scene.objects[1].transforms, {0, 0, 0}), {0, 10, 0});
  CHECK(b.scene.objects[2].transforms.size() == 2);
}

TEST_CASE("material { interior } is understood, texture named once") {
  const Bound b =
      bind_text(lit +
                "box { 0, 1 material { texture { pigment { rgb 1 } } interior { ior 1.7 } } }"
                "box { 2, 3 texture { pigment { rgb 1 } }" +
                glass + "}");
  CHECK(b.count(sdl::Severity::warning) == 1);
  CHECK(b.scene.media.at(*b.scene.objects.at(0).medium).n[0][0] == 1.7);
}

TEST_CASE("equal media are one") {
  const Bound b = bind_clean(lit +
                             "#declare I = interior { ior 1.5 } box { 0, 1 interior { I } }"
                             "box { 2, 3 interior { I } } box { 4, 5 interior { ior 1.6 } }");
  CHECK(b.scene.media.size() == 3);
  CHECK(b.scene.objects[0].medium == b.scene.objects[1].medium);
}

TEST_CASE("optical contact") {
  const Bound b = bind_clean(lit + "box { 0, 1 optical_contact" + glass +
                             "} box { <1,0,0>, <2,1,1>" + glass + "}");
  CHECK(b.scene.objects[0].optical_contact);
  CHECK_FALSE(b.scene.objects[1].optical_contact);
}

TEST_CASE("a mirrored shape of a rotating medium is told of once") {
  const std::string active = " interior { ior 1.5 rotation { constant 20 } } ";
  const Bound b = bind_text(lit + "box { 0, 1 scale <-1, 1, 1>" + active +
                            "} box { 0, 1 scale <1, -1, 1>" + active + "}");
  CHECK(b.count(sdl::Severity::warning) == 1);
  CHECK(b.text().find("mirror") != std::string::npos);
  bind_clean(lit + "box { 0, 1 scale <-1, -1, 1>" + active + "} box { 0, 1 scale <-1, 1, 1>" +
             glass + "}");
}

TEST_CASE("luminous names a face of a box, or all of them") {
  const Bound b =
      bind_clean(lit + "box { 0, 1 luminous { face -y polarizer { ideal angle 30 } }" + glass +
                 "}"
                 "box { 0, 1 luminous { spectrum { a } } }");
  const Object& one = b.scene.objects.at(0);
  REQUIRE(one.face_emissions.size() == 1);
  check_near(convex(b).faces[one.face_emissions[0].face].normal, {0, -1, 0});
  // Seen from below, x to the right: counter-clockwise is towards the world's +z... of a
  // right-handed world.
  const Polarizer& p = b.scene.polarizers.at(*b.scene.emissions[0].polarizer);
  check_near(p.normal, {0, -1, 0});
  check_near(p.transmission_axis, {std::sqrt(0.75), 0, 0.5});
  CHECK(b.scene.objects.at(1).face_emissions.size() == 6);
  CHECK(b.scene.objects[1].medium == 0);
}

}  // namespace nicol
