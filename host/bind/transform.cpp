// translate, rotate, scale, matrix and transform { }, as POV-Ray has them: one Affine per
// elementary step.
#include "host/bind/parts.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// POV-Ray takes a factor of 0 as 1, and says so.
double without_zero(Context& context, Location where, double factor, const char* axis) {
  if (factor != 0) return factor;
  context.warning(where, std::string("Illegal Value: Scale ") + axis + " by 0.0. Changed to 1.0.");
  return 1;
}

void append_matrix(Context& context, const Args& args, Affines& list) {
  Affine a;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) a.m[row][column] = args.numbers[3 * row + column];
  if (determinant(a) == 0) context.error(args.where, "this matrix has no inverse");
  else list.push_back(a);
}

void append_transform_block(Context& context, const sdl::Block& block, Affines& list) {
  Affines inner;
  bool inverted = false;
  Schema schema{
      "transform",
      {{"inverse", "", [&](const Args&) { inverted = true; }, "the inverse of the whole block"}},
      {}};
  add_transform_rules(schema, inner, context);
  read_block(context, block, schema);
  if (inverted) inner = inverse(inner);
  list.insert(list.end(), inner.begin(), inner.end());
}

}  // namespace

void add_transform_rules(Schema& schema, Affines& list, Context& context) {
  Affines* to = &list;
  Context* c = &context;
  schema.rules.push_back({"translate", "v",
                          [=](const Args& a) { to->push_back(translation(a.vectors[0])); },
                          "moves"});
  schema.rules.push_back({"rotate", "v", [=](const Args& a) { append_rotation(*to, a.vectors[0]); },
                          "degrees about x, then y, then z"});
  schema.rules.push_back({"scale", "v",
                          [=](const Args& a) {
                            const Vec3 by = a.vectors[0];
                            to->push_back(scaling({without_zero(*c, a.where, by.x, "X"),
                                                   without_zero(*c, a.where, by.y, "Y"),
                                                   without_zero(*c, a.where, by.z, "Z")}));
                          },
                          "stretches along the axes"});
  schema.rules.push_back({"matrix", "m", [=](const Args& a) { append_matrix(*c, a, *to); },
                          "3x4 matrix of row vectors"});
  if (schema.find("transform", true)) return;
  schema.rules.push_back({"transform", "{}",
                          [=](const Args& a) { append_transform_block(*c, *a.block, *to); },
                          "a list of transforms, `inverse` for its inverse"});
  schema.rules.push_back({"transform", "", [](const Args&) {}, "before a declared transform"});
}

}  // namespace nicol
