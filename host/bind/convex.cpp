// Convex solids as lists of half-spaces: box, crystal, intersections of these and of planes, and
// differences that only planes are taken from. Children keep transforms of their own, applied to
// their planes here. All other CSG is in csg.cpp.
#include <algorithm>

#include "host/bind/crystal.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

using Faces = std::vector<HalfSpace>;

std::string kind_of(const RawObject& raw) { return raw.block->name; }

// Corners may be swapped, as in POV-Ray.
Faces box_faces(const RawObject& raw) {
  const Vec3 a = raw.vectors[0], b = raw.vectors[1];
  const Vec3 low{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  const Vec3 high{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  return {{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
          {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
}

bool append_faces(Context& context, const sdl::Block& block, bool outside, Faces& faces) {
  const Context::Depth depth(context, block.where);
  const RawObject& raw = read_object(context, block);
  Faces own;
  if (!convex_faces(context, raw, own)) return false;
  if (outside != raw.inverse) {  // one plane, as half_space_count() has it
    own[0].normal = -own[0].normal;
    own[0].offset = -own[0].offset;
  }
  Affines steps = raw.transforms;
  if (!is_instance(raw)) {
    const Affines frame = shape_frame(raw);
    steps.insert(steps.begin(), frame.begin(), frame.end());
  }
  for (const HalfSpace& face : own) faces.push_back(transform(steps, face));
  if (faces.size() <= most_faces) return true;
  context.error(block.where, "a solid with more than " + std::to_string(most_faces) + " faces");
  throw GiveUp{};
}

// Half-spaces of a child, if it is convex still after being turned inside out or not.
std::optional<std::size_t> count_of_child(Context& context, const sdl::Block& block, bool outside) {
  const Context::Depth depth(context, block.where);
  context.step(block.where);
  const RawObject& raw = read_object(context, block);
  const auto count = half_space_count(context, raw);
  if (count && outside != raw.inverse && *count != 1) return std::nullopt;
  return count;
}

}  // namespace

bool is_instance(const RawObject& raw) {
  const std::string kind = kind_of(raw);
  return raw.children.size() == 1 && kind != "intersection" && kind != "difference";
}

std::optional<std::size_t> half_space_count(Context& context, const RawObject& raw) {
  const std::string kind = kind_of(raw);
  if (!raw.sound) return std::nullopt;
  if (is_instance(raw)) return count_of_child(context, *raw.children[0], false);
  if (kind == "box") return 6;
  if (kind == "plane") return 1;
  if (raw.mesh) return std::nullopt;
  if (kind == "crystal" || kind == "gem" || kind == "solid") return raw.facets.size();
  if ((kind != "intersection" && kind != "difference") || raw.children.empty())
    return std::nullopt;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < raw.children.size(); ++i) {
    const auto count = count_of_child(context, *raw.children[i], kind == "difference" && i > 0);
    if (!count) return std::nullopt;
    sum += *count;
    if (sum > most_faces) break;  // will be refused
  }
  return sum;
}

bool convex_faces(Context& context, const RawObject& raw, std::vector<HalfSpace>& faces) {
  const std::string kind = kind_of(raw);
  if (!raw.individuals.empty()) {
    context.error(raw.block->where, "a twin cannot be cut; 'facet' inside it cuts its individuals");
    return false;
  }
  if ((kind == "crystal" || kind == "gem" || kind == "solid") && !is_instance(raw)) faces = raw.facets;
  if (kind == "box" && raw.vectors.size() == 2) faces = box_faces(raw);
  if (kind == "plane" && raw.vectors.size() == 1)
    if (const auto h = half_space(context, raw.block->where, raw.vectors[0], raw.numbers[0]))
      faces = {*h};
  if (!faces.empty()) return true;
  bool all = !raw.children.empty();
  for (std::size_t i = 0; i < raw.children.size(); ++i) {
    context.step(raw.block->where);
    all = append_faces(context, *raw.children[i], kind == "difference" && i > 0, faces) && all;
  }
  return all;
}

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
  if (!convex_faces(context, raw, shape.faces) || !check_closed(context, raw)) return std::nullopt;
  if (raw.inverse) {
    context.error(raw.block->where,
                  "an inverse solid fills all of space; inside an intersection it cuts");
    return std::nullopt;
  }
  return shape;
}

}  // namespace nicol
