// Trees of solids that are merged, intersected or subtracted: merge, intersection, difference of
// boxes, crystals, prisms and planes. A union inside such a tree counts as a merge.
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

using Node = CsgShape::Node;
using Operation = CsgShape::Operation;
constexpr std::size_t most_leaves = 10'000;

class TreeReader {
 public:
  explicit TreeReader(Context& context) : context_(context) {}

  // The tree in the coordinates of the object's own text. `added`: what is inside it is inside the
  // solid, too, not cut away.
  std::optional<Node> read(const RawObject& raw, bool added) {
    const Context::Depth depth(context_, raw.block->where);
    context_.step(raw.block->where);
    if (!raw.sound) return std::nullopt;
    std::optional<Node> node = is_instance(raw) ? operand(raw, 0, added) : own(raw, added);
    if (!node) return node;
    node->inverse ^= raw.inverse;
    node->where = raw.block->where;
    return node;
  }

 private:
  Context& context_;
  std::size_t leaves_ = 0;

  std::optional<Node> own(const RawObject& raw, bool added) {
    Node node;
    node.kind = raw.block->name;
    if (node.kind == "merge" || node.kind == "union") {
      node.operation = Operation::merge;
    } else if (node.kind == "intersection") {
      node.operation = Operation::intersection;
    } else if (node.kind == "difference") {
      node.operation = Operation::difference;
    } else {
      return leaf(raw, std::move(node));
    }
    if (node.kind == "union" && added != raw.inverse)
      context_.warn_once("union in csg", raw.block->where,
                         "a 'union' that is cut counts as a 'merge': no faces stay between its parts");
    return inner(raw, std::move(node), added);
  }

  std::optional<Node> inner(const RawObject& raw, Node node, bool added) {
    if (raw.children.empty()) {
      context_.error(raw.block->where, "'" + node.kind + "' holds no solid");
      return std::nullopt;
    }
    bool all = true;
    for (std::size_t i = 0; i < raw.children.size(); ++i) {
      const bool taken = node.operation == Operation::difference && i > 0;
      std::optional<Node> child = operand(raw, i, (added != raw.inverse) != taken);
      if (child) node.operands.push_back(std::move(*child));
      all = all && child;
    }
    if (!all) return std::nullopt;
    return node;
  }

  std::optional<Node> operand(const RawObject& raw, std::size_t i, bool added) {
    const RawObject& child = read_object(context_, *raw.children[i]);
    std::optional<Node> node = read(child, added);
    if (node)
      node->transforms.insert(node->transforms.end(), child.transforms.begin(),
                              child.transforms.end());
    if (!child.sound)
      context_.note(raw.block->where, "the '" + child.block->name + "' is part of this '" +
                                          raw.block->name + "'");
    return node;
  }

  std::optional<Node> leaf(const RawObject& raw, Node node) {
    if (++leaves_ > most_leaves) {
      context_.error(raw.block->where, "more than " + std::to_string(most_leaves) +
                                           " solids cut from one another");
      throw GiveUp{};
    }
    if (node.kind == "polygon" || node.kind == "disc") {
      context_.error(raw.block->where,
                     "a '" + node.kind + "' has no inside, so it neither cuts nor is cut");
      return std::nullopt;
    }
    if (node.kind == "prism") {
      const auto prism = prism_shape(context_, raw);
      if (!prism) return std::nullopt;
      node.leaf = *prism;
      return node;
    }
    if (!raw.told.empty()) node.kind = raw.told;
    if (raw.mesh) {
      node.leaf = *raw.mesh;
      return node;
    }
    ConvexShape convex;
    if (!convex_faces(context_, raw, convex.faces)) return std::nullopt;
    node.leaf = std::move(convex);
    node.transforms = shape_frame(raw);
    return node;
  }
};

}  // namespace

std::optional<CsgShape> csg_shape(Context& context, const RawObject& raw) {
  std::optional<Node> root = TreeReader(context).read(raw, true);
  if (!root) return std::nullopt;
  return CsgShape{std::move(*root)};
}

}  // namespace nicol
