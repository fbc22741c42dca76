// Convex solids as lists of half-spaces: box, crystal, intersection (and difference) of planes and
// convex solids. Children of an intersection keep transforms of their own, applied to their planes
// here.
#include <algorithm>

#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/bind/vec.hpp"

namespace nicol {

namespace {

using Faces = std::vector<HalfSpace>;
constexpr std::size_t most_faces = 10'000;

std::string kind_of(const RawObject& raw) { return raw.block->name; }

bool is_instance(const RawObject& raw) {
  const std::string kind = kind_of(raw);
  return raw.children.size() == 1 && kind != "intersection" && kind != "difference";
}

// Corners may be swapped, as in POV-Ray.
Faces box_faces(const RawObject& raw) {
  const Vec3 a = raw.vectors[0], b = raw.vectors[1];
  const Vec3 low{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  const Vec3 high{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  return {{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
          {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
}

bool append_faces(Context& context, const sdl::Block& block, bool outside, Faces& faces);

bool cut_faces(Context& context, const RawObject& raw, Faces& faces) {
  const bool subtracts = kind_of(raw) == "difference";
  if (raw.children.empty()) {
    context.error(raw.block->where, "'" + kind_of(raw) + "' holds no solid");
    return false;
  }
  bool all = true;
  for (std::size_t i = 0; i < raw.children.size(); ++i) {
    context.step(raw.block->where);
    all = append_faces(context, *raw.children[i], subtracts && i > 0, faces) && all;
  }
  return all;
}

// Faces in the coordinates of the object's own text.
bool own_faces(Context& context, const RawObject& raw, Faces& faces) {
  const std::string kind = kind_of(raw);
  if (is_instance(raw)) return append_faces(context, *raw.children[0], false, faces);
  if (kind == "intersection" || kind == "difference") return cut_faces(context, raw, faces);
  if (kind == "crystal") faces = raw.facets;
  if (kind == "box" && raw.vectors.size() == 2) faces = box_faces(raw);
  if (kind == "plane" && raw.vectors.size() == 1)
    if (const auto h = half_space(context, raw.block->where, raw.vectors[0], raw.numbers[0]))
      faces = {*h};
  if (!faces.empty()) return true;
  if (kind == "prism" || kind == "polygon" || kind == "disc" || kind == "union")
    context.error(raw.block->where,
                  "'" + kind + "' cannot be cut yet; planes, boxes and crystals can");
  return false;
}

// Turned inside out: what `inverse` and `difference` ask for. Only one plane stays convex.
bool complement(Context& context, const RawObject& raw, Faces& faces) {
  if (faces.size() != 1) {
    context.error(raw.block->where,
                  "only a plane can be subtracted or inverted: a crystal minus '" + kind_of(raw) +
                      "' would not be convex");
    return false;
  }
  faces[0].normal = -faces[0].normal;
  faces[0].offset = -faces[0].offset;
  return true;
}

bool append_faces(Context& context, const sdl::Block& block, bool outside, Faces& faces) {
  const Context::Depth depth(context, block.where);
  const RawObject& raw = read_object(context, block);
  Faces own;
  if (!own_faces(context, raw, own)) return false;
  if (outside != raw.inverse && !complement(context, raw, own)) return false;
  Affines steps = raw.transforms;
  if (block.name == "crystal" && !is_instance(raw)) steps.insert(steps.begin(), from_crystal());
  for (const HalfSpace& face : own) faces.push_back(transform(steps, face));
  if (faces.size() <= most_faces) return true;
  context.error(block.where, "a solid with more than " + std::to_string(most_faces) + " faces");
  throw GiveUp{};
}

}  // namespace

std::optional<HalfSpace> half_space(Context& context, Location where, Vec3 normal,
                                    double distance) {
  const int axes = (normal.x != 0) + (normal.y != 0) + (normal.z != 0);
  if (axes == 0) {
    context.error(where, "Degenerate plane normal.");
    return std::nullopt;
  }
  if (axes == 1) return HalfSpace{normalize(normal), distance};
  return HalfSpace{normal, distance * length(normal)};
}

std::optional<ConvexShape> convex_shape(Context& context, const RawObject& raw) {
  ConvexShape shape;
  if (!own_faces(context, raw, shape.faces)) return std::nullopt;
  if (raw.inverse) {
    context.error(raw.block->where,
                  "an inverse solid fills all of space; only planes can be inverted");
    return std::nullopt;
  }
  return shape;
}

}  // namespace nicol
