// CSG: see csg.hpp.
#include "csg.hpp"

#include <algorithm>
#include <optional>

#include "cells.hpp"
#include "leaves.hpp"

namespace nicol::solids {
namespace {

using Node = CsgShape::Node;
using Operation = CsgShape::Operation;

constexpr int inner_tag = -3;  // of planes between the pieces of one leaf

std::string name_of(const Node& node) {
  return "'" + node.kind + "' at line " + std::to_string(node.where.line);
}

// A set of space: the cells, or everything but them.
struct Region {
  Cells cells;
  bool inverse = false;
};

Region complement(Region region) {
  region.inverse = !region.inverse;
  return region;
}

Region intersected(Region a, Region b) {
  if (!a.inverse && !b.inverse) return {common(a.cells, b.cells), false};
  if (!a.inverse) return {minus(std::move(a.cells), b.cells), false};
  if (!b.inverse) return {minus(std::move(b.cells), a.cells), false};
  return {joined(a.cells, b.cells), true};
}

bool is_empty(const Region& region) { return !region.inverse && region.cells.empty(); }

struct Fault {
  std::string what;
  Location where;
};

class Evaluator {
 public:
  explicit Evaluator(const std::vector<Affine>& outer) : outer_(outer) {}

  std::vector<Polyhedron> run(const Node& root) {
    place(root, outer_);
    far_ = far_cube(planes_);
    const Region region = evaluate(root);
    if (is_empty(region)) throw Fault{emptied_, emptied_where_};
    std::vector<Polyhedron> cells;
    if (region.inverse) tell_open(root, "everywhere");
    for (const ConvexCell& cell : region.cells) {
      if (is_open(cell.body)) tell_open(root, text_of(open_towards(cell.body)));
      cells.push_back(cell.body);
    }
    mark_seams(cells);
    name_bare_faces(cells);
    return cells;
  }

 private:
  const std::vector<Affine>& outer_;
  std::vector<std::vector<Leaf::Piece>> leaves_;  // in the world, in the order of the tree
  std::vector<ExactPlane> planes_;
  std::vector<int> tags_;  // of planes_
  int face_count_ = 0;
  std::size_t next_leaf_ = 0;
  Polyhedron far_;
  std::string emptied_;
  Location emptied_where_;

  static std::string text_of(const Vec3& v) {
    return "<" + solids::text_of(v.x) + ", " + solids::text_of(v.y) + ", " +
           solids::text_of(v.z) + ">";
  }

  // ---- leaves to world planes ----
  void place(const Node& node, const std::vector<Affine>& around) {
    std::vector<Affine> steps = node.transforms;
    steps.insert(steps.end(), around.begin(), around.end());
    for (const Node& operand : node.operands) place(operand, steps);
    if (node.operation != Operation::leaf) return;
    const std::string wrong = wrong_with(steps);
    if (!wrong.empty()) throw Fault{name_of(node) + " " + wrong, node.where};
    const ExactAffine affine(steps);
    Leaf leaf = std::visit([](const auto& shape) { return leaf_of(shape); }, node.leaf);
    if (!leaf.wrong.empty()) throw Fault{name_of(node) + " " + leaf.wrong, node.where};
    for (Leaf::Piece& piece : leaf.pieces) {
      for (std::size_t i = 0; i < piece.planes.size(); ++i) {
        piece.planes[i] = affine(piece.planes[i]);
        piece.tags[i] = piece.tags[i] < 0 ? inner_tag : piece.tags[i] + face_count_;
        planes_.push_back(piece.planes[i]);
        tags_.push_back(piece.tags[i]);
      }
    }
    face_count_ += leaf.face_count;
    leaves_.push_back(std::move(leaf.pieces));
  }

  // ---- the tree, from the leaves up ----
  Region evaluate(const Node& node) {
    Region region = node.operation == Operation::leaf ? leaf(node) : fold(node);
    return node.inverse ? complement(std::move(region)) : region;
  }

  Region leaf(const Node& node) {
    Region region;
    for (const Leaf::Piece& piece : leaves_[next_leaf_++]) {
      Polyhedron body = far_;
      for (std::size_t i = 0; i < piece.planes.size(); ++i) {
        if (body.cut(piece.planes[i], piece.tags[i]) == Cut::empties)
          throw Fault{name_of(node) + " encloses nothing: face " + std::to_string(i) +
                          " leaves no volume of what the faces before it enclose",
                      node.where};
      }
      region.cells.emplace_back(std::move(body));
    }
    return region;
  }

  Region fold(const Node& node) {
    if (node.operands.empty()) throw Fault{name_of(node) + " holds no solid", node.where};
    std::optional<Region> sum;
    for (const Node& operand : node.operands) {
      Region next = evaluate(operand);
      if (!sum) {
        sum = std::move(next);
        continue;
      }
      const bool was_empty = is_empty(*sum) || is_empty(next);
      *sum = combined(node.operation, std::move(*sum), std::move(next));
      if (!is_empty(*sum) || was_empty) continue;
      emptied_ = name_of(node) + " encloses nothing: " + name_of(operand) +
                 " leaves nothing of what comes before it";
      emptied_where_ = operand.where;
    }
    return std::move(*sum);
  }

  static Region combined(Operation operation, Region a, Region b) {
    if (operation != Operation::intersection) b = complement(std::move(b));
    if (operation == Operation::merge) a = complement(std::move(a));
    Region both = intersected(std::move(a), std::move(b));
    both.inverse ^= operation == Operation::merge;
    return both;
  }

  [[noreturn]] void tell_open(const Node& root, const std::string& towards) {
    const Node* open = open_leaf(root, false);
    throw Fault{name_of(root) + " is not closed: it reaches infinitely far towards " + towards +
                    (open ? ", because nothing bounds " + name_of(*open) : ""),
                open ? open->where : root.where};
  }

  // The first leaf that brings in space without bounds.
  const Node* open_leaf(const Node& node, bool outside) {
    outside ^= node.inverse;
    if (node.operation == Operation::leaf) return outside || unbounded(node) ? &node : nullptr;
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
      const bool taken = node.operation == Operation::difference && i > 0;
      if (const Node* found = open_leaf(node.operands[i], outside != taken)) return found;
    }
    return nullptr;
  }

  static bool unbounded(const Node& node) {
    const auto* convex = std::get_if<ConvexShape>(&node.leaf);
    return convex && enclose(leaf_of(*convex).pieces[0].planes).state ==
                         Enclosure::State::unbounded;
  }

  // Cells may have cut each other along a plane between the pieces of one leaf; where such a cut has
  // come to lie in a face of another leaf it takes that face's tag.
  void name_bare_faces(std::vector<Polyhedron>& cells) const {
    for (Polyhedron& cell : cells) {
      for (Polyhedron::Face& face : cell.faces) {
        if (face.tag != inner_tag) continue;
        for (std::size_t i = 0; i < planes_.size(); ++i) {
          const bool coplanar = same(planes_[i], face.plane) || opposite(planes_[i], face.plane);
          if (coplanar && tags_[i] >= 0) face.tag = tags_[i];
        }
      }
    }
  }
};

}  // namespace

CsgResult make_csg(const CsgShape& shape, const std::vector<Affine>& outer) {
  CsgResult result;
  try {
    result.cells = Evaluator(outer).run(shape.root);
  } catch (const TooManyCells&) {
    result.wrong = name_of(shape.root) + " comes apart into more than " +
                   std::to_string(most_cells) + " convex cells";
    result.where = shape.root.where;
  } catch (const Fault& fault) {
    result.wrong = fault.what;
    result.where = fault.where;
  }
  return result;
}

}  // namespace nicol::solids
