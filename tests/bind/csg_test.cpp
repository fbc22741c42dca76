// Solids cut from one another: what stays a list of half-spaces, and what becomes a tree.
#include "bound.hpp"
#include "host/bind/affine.hpp"

namespace nicol {

namespace {

using Node = CsgShape::Node;
using Operation = CsgShape::Operation;

const Node& root(const Bound& b) {
  return std::get<CsgShape>(b.scene.objects.at(0).shape).root;
}

}  // namespace

TEST_CASE("a difference of boxes is a tree, with places and transforms of its own") {
  const Bound b = bind_clean(lit + "difference { box { 0, 2 }\n box { 1, 3 rotate 90*y translate x }"
                             " rotate 10*x" + glass + "}");
  const Node& node = root(b);
  CHECK(node.operation == Operation::difference);
  CHECK(node.kind == "difference");
  CHECK(node.transforms.empty());  // the rotation is the object's
  CHECK(b.scene.objects[0].transforms.size() == 2);
  REQUIRE(node.operands.size() == 2);
  CHECK(node.operands[0].operation == Operation::leaf);
  CHECK(std::get<ConvexShape>(node.operands[0].leaf).faces.size() == 6);
  CHECK(node.operands[1].transforms.size() == 2);
  CHECK(node.operands[1].where.line == node.where.line + 1);
  CHECK(b.scene.objects[0].kind == "difference");
}

TEST_CASE("instances lend their transforms and may be inverse") {
  const Bound b = bind_clean(
      lit + "#declare P = prism { 0, 1, 4, <0,0>, <1,0>, <0,1>, <0,0> scale 3 }"
            "#declare D = difference { box { 0, 2 } object { P translate y } }"
            "intersection { object { D translate 5*x } box { object { P inverse } scale 2 inverse } " +
            glass + "}");
  const Node& node = root(b);
  REQUIRE(node.operands.size() == 2);
  CHECK(node.operands[0].operation == Operation::difference);
  CHECK(node.operands[0].transforms.size() == 1);
  const Node& prism = node.operands[0].operands.at(1);
  CHECK(prism.kind == "prism");
  REQUIRE(prism.transforms.size() == 2);
  check_near(transform_point(prism.transforms, {1, 0, 0}), {3, 1, 0});
  CHECK_FALSE(prism.inverse);
  CHECK(std::get<PrismShape>(node.operands[1].leaf).contours.size() == 1);
  CHECK_FALSE(node.operands[1].inverse);  // twice
  CHECK(node.operands[1].transforms.size() == 2);
}

TEST_CASE("merge of one solid, and what only planes cut, stay convex") {
  const Bound b = bind_clean(lit + "merge { box { 0, 1 translate x }" + glass + "}" +
                             "difference { intersection { box { 0, 1 } crystal { facet x, 3 } }"
                             " plane { x, 0 } object { plane { y, 0 } } translate 9*x" +
                             glass + "}");
  REQUIRE(b.scene.objects.size() == 2);
  for (const Object& object : b.scene.objects)
    CHECK(std::holds_alternative<ConvexShape>(object.shape));
}

TEST_CASE("a crystal in a tree keeps its handedness") {
  const Bound b = bind_clean(lit + "merge { box { 0, 1 } crystal { facet <0,0,1>, 2 translate x }" +
                             glass + "}");
  const Node& crystal = root(b).operands.at(1);
  REQUIRE(crystal.transforms.size() == 2);
  CHECK(determinant_sign({crystal.transforms[0]}) == -1);
  check_near(transform_point(crystal.transforms, {0, 0, 0}), {1, 0, 0});
}

TEST_CASE("a union that is cut counts as a merge, which is told where it shows") {
  const std::string bar = "union { box { 0, 1 } box { <1, 0, 0>, <2, 1, 1> } }";
  const Bound shown = bind_text(lit + "difference { " + bar + " box { 0.5, 3 }" + glass + "}");
  CHECK(root(shown).operands.at(0).operation == Operation::merge);
  CHECK(shown.text().find("counts as a 'merge'") != std::string::npos);
  const Bound hidden = bind_clean(lit + "difference { box { -1, 4 } " + bar + glass + "}");
  CHECK(root(hidden).operands.at(1).operation == Operation::merge);
}

TEST_CASE("what cannot be cut is told with both places") {
  const Bound b =
      bind_text(lit + "difference { box { 0, 2 }\n\n sphere { 0, 1 }" + glass + "}");
  CHECK(b.count(sdl::Severity::error) == 1);
  CHECK(b.count(sdl::Severity::note) == 1);
  CHECK(b.text().find("the 'sphere' is part of this 'difference'") != std::string::npos);
}

}  // namespace nicol
