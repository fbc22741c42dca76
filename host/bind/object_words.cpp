// The words of objects: shapes, their modifiers, and POV-Ray's words that nicol does not render.
#include <algorithm>
#include <cstring>

#include "host/bind/crystal.hpp"

namespace nicol {

namespace {

const std::vector<const char*> rendered = {"box",          "crystal",   "gem",    "plane", "prism",
                                           "polygon",      "disc",      "solid",  "object", "union",
                                           "intersection", "difference", "merge"};
const std::vector<const char*> not_rendered = {"sphere",       "cylinder",      "cone",
                                               "torus",        "triangle",      "smooth_triangle",
                                               "mesh",         "mesh2",
                                               "quadric",      "cubic",         "quartic",
                                               "poly",         "polynomial",    "superellipsoid",
                                               "lathe",        "sor",           "blob",
                                               "height_field", "text",          "isosurface",
                                               "parametric",   "julia_fractal", "bicubic_patch",
                                               "sphere_sweep", "ovus",          "light_group"};

bool holds(const std::vector<const char*>& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(), [&](const char* word) { return name == word; });
}

void add_shape_rules(Context* c, const std::string& kind, RawObject* r, Schema& schema) {
  const auto store = [r](const Args& a) {
    r->vectors = a.vectors;
    r->numbers = a.numbers;
    r->points = a.points;
  };
  auto& rules = schema.rules;
  if (kind == "box") rules.push_back({"", "vv", store, "two opposite corners"});
  if (kind == "plane")
    rules.push_back({"", "vn", store, "normal, distance along it; only inside an `intersection`"});
  if (kind == "disc")
    rules.push_back({"", "vvN", store, "centre, normal, radius[, radius of the hole]"});
  if (kind == "polygon")
    rules.push_back(
        {"", "nV", store, "number of points, points; each contour ends where it began"});
  if (kind == "crystal") add_crystal_rules(*c, *r, schema);
  if (kind == "gem") add_gem_rules(*c, *r, schema);
  if (kind == "solid") add_solid_rules(*c, *r, schema);
  if (kind == "prism") {
    rules.push_back(
        {"", "nnnP", store, "y of the foot, y of the top, number of points, points <x,z>"});
    const auto nothing = [](const Args&) {};
    rules.push_back({"linear_spline", "", nothing, "straight sides (default)"});
    rules.push_back({"linear_sweep", "", nothing, "the same outline all along y (default)"});
    rules.push_back({"open", "", nothing, "accepted: a crystal is closed"});
    rules.push_back({"sturm", "b", nothing, "accepted"});
    for (const char* word : {"quadratic_spline", "cubic_spline", "bezier_spline", "conic_sweep"})
      rules.push_back({word, "",
                       [=](const Args& a) {
                         c->error(a.where,
                                  std::string("a prism with '") + word +
                                      "' is not rendered; 'linear_spline' with 'linear_sweep' is");
                       },
                       "an error: not rendered"});
  }
}

Schema material_schema(RawObject* r) {
  return {"material",
          {{"interior", "{}", [=](const Args& a) { r->interior = a.block; }, "the medium"}},
          {{"%s is not rendered: nicol renders transparent crystals, polarizers and lights",
            true,
            {"texture"}}}};
}

void add_modifier_rules(Context* c, RawObject* r, Schema& schema) {
  auto& rules = schema.rules;
  rules.push_back(
      {"interior", "{}", [=](const Args& a) { r->interior = a.block; }, "the medium inside"});
  rules.push_back({"material", "{}",
                   [=](const Args& a) { read_block(*c, *a.block, material_schema(r)); },
                   "its `interior` is taken"});
  rules.push_back({"luminous", "{}", [=](const Args& a) { r->lights.push_back(a.block); },
                   "a sheet or a face that shines"});
  rules.push_back({"polarizer", "{}", [=](const Args& a) { r->polarizer = a.block; },
                   "a sheet that polarizes"});
  rules.push_back({"surface", "{}", [=](const Args& a) { r->surfaces.push_back(a.block); },
                   "what a plugin makes of the faces of a solid"});
  rules.push_back({"optical_contact", "b",
                   [=](const Args& a) { r->optical_contact = a.numbers[0] != 0; },
                   "touches its neighbours without a gap"});
  rules.push_back({"inverse", "", [=](const Args&) { r->inverse = !r->inverse; },
                   "everything but this: of use inside an intersection"});
  rules.push_back({"clipped_by", "{}",
                   [=](const Args& a) {
                     c->error(a.where, "'clipped_by' is not rendered; 'intersection' cuts solids");
                   },
                   "an error: not rendered"});
  schema.ignored = {
      {"%s is not rendered: nicol renders transparent crystals, polarizers and lights",
       true,
       {"texture", "pigment", "finish", "normal", "photons", "uv_mapping", "light_source",
        "interior_texture", "media"}},
      {"",
       false,
       {"bounded_by", "no_shadow", "no_image", "no_reflection", "no_radiosity", "hollow",
        "double_illuminate", "split_union", "cutaway_textures", "uv_vectors", "sturm"}}};
}

void read_words(Context& context, const sdl::Block& block, RawObject& raw) {
  if (holds(not_rendered, block.name)) {
    context.error(block.where,
                  "nicol does not render '" + block.name +
                      "' yet; it renders box, prism, crystal, polygon, disc, unions of these, and "
                      "merge, intersection and difference of solids with flat faces");
    return;
  }
  const std::size_t errors_before = context.error_count();
  const Schema schema = object_schema(context, block.name.c_str(), raw);
  read_block(context, block, schema);
  if (raw.crystal && raw.children.empty()) finish_crystal(context, raw);
  if (raw.gem && raw.children.empty()) finish_gem(context, raw);
  const bool has_values = !raw.vectors.empty() || !raw.points.empty() || !raw.facets.empty() || raw.mesh;
  const bool shaped = schema.find("", false) || block.name == "crystal" || block.name == "solid";
  if (shaped && !has_values && raw.children.empty() && context.error_count() == errors_before)
    context.error(block.end_where,
                  block.name == "solid" ? "Expected 'plugin', } of 'solid' found instead"
                  : block.name == "crystal"
                      ? "Expected 'facet' or 'form', } of 'crystal' found instead"
                      : "Expected 'numeric expression', } of '" + block.name + "' found instead");
}

}  // namespace

bool is_object(std::string_view name) { return holds(rendered, name) || holds(not_rendered, name); }

std::vector<std::string> object_names() { return {rendered.begin(), rendered.end()}; }

Schema object_schema(Context& context, const char* kind, RawObject& raw) {
  Schema schema;
  schema.block = kind;
  schema.inherits = false;
  RawObject* r = &raw;
  schema.take_block = [r](const sdl::Block& inner) {
    if (!is_object(inner.name)) return false;
    r->children.push_back(&inner);
    return true;
  };
  schema.known_blocks = object_names();
  add_shape_rules(&context, kind, r, schema);
  add_modifier_rules(&context, r, schema);
  add_transform_rules(schema, raw.transforms, context);
  return schema;
}

const RawObject& read_object(Context& context, const sdl::Block& block) {
  context.step(block.where, context.limits.visit_steps);
  auto& known = context.object_of_block[&block];
  if (known) return *known;
  auto raw = std::make_shared<RawObject>();
  raw->block = &block;
  const std::size_t errors_before = context.error_count();
  read_words(context, block, *raw);
  raw->sound = context.error_count() == errors_before;
  known = std::move(raw);
  return *known;
}

}  // namespace nicol
