// Solids inside a solid of several cells.
//
// Rays step from a cell to its children or to its one parent. So a solid that lies across several
// cells of another is split where the seams between these run through it, and its pieces are joined
// by seams of their own: nothing that a ray meets changes. Cutting the hole into the outer cells
// instead would give more cells (a box inside an L: 2 pieces, against 12 cells around it).
#include <set>

#include "cells.hpp"
#include "nesting.hpp"
#include "sweep.hpp"

namespace nicol::solids {
namespace {

class Splitter {
 public:
  explicit Splitter(std::vector<SolidPart>& solids) : solids_(solids) {
    for (const SolidPart& part : solids) cells_of(part.object).emplace_back(part.body);
  }

  void run() {
    const std::set<std::pair<int, int>> pairs = overlapping();
    if (pairs.empty()) return;
    // The order does not matter: a solid is split by the seams of all that it lies in.
    for (const auto& [outer, inner] : pairs) {
      if (inside(inner, outer) && !inside(outer, inner)) split(inner, outer);
    }
    write_back();
  }

 private:
  std::vector<SolidPart>& solids_;
  std::vector<Cells> cells_;  // by object
  std::set<int> changed_;

  Cells& cells_of(int object) {
    if (object >= size_of(cells_)) cells_.resize(object + 1);
    return cells_[object];
  }

  bool has_seams(int object) const { return cells_[object].size() > 1; }

  // Solids (outer, inner) of which cells overlap, where the outer one has several.
  std::set<std::pair<int, int>> overlapping() const {
    std::vector<Bounds> boxes;
    for (const SolidPart& part : solids_) boxes.push_back(part.bounds);
    std::set<std::pair<int, int>> found;
    for (const auto& [i, j] : close_pairs(boxes, 0)) {
      const int a = solids_[i].object, b = solids_[j].object;
      if (a == b || (!has_seams(a) && !has_seams(b))) continue;
      if (relate(solids_[i].body, solids_[j].body) != Relation::overlap) continue;
      if (has_seams(a)) found.insert({a, b});
      if (has_seams(b)) found.insert({b, a});
    }
    return found;
  }

  bool inside(int inner, int outer) const {
    try {
      return minus(cells_[inner], cells_[outer]).empty();
    } catch (const TooManyCells&) {
      return false;
    }
  }

  void split(int inner, int outer) {
    Cells pieces;
    for (const ConvexCell& cell : cells_[inner]) {
      for (const ConvexCell& around : cells_[outer]) {
        if (disjoint(cell.bounds, around.bounds)) continue;
        Polyhedron piece = cell.body;
        bool shared = true;
        for (const Polyhedron::Face& face : around.body.faces)
          shared = shared && piece.cut(face.plane, seam_tag) != Cut::empties;
        if (shared) pieces.emplace_back(std::move(piece));
      }
    }
    cells_[inner] = std::move(pieces);
    changed_.insert(inner);
  }

  void write_back() {
    std::vector<SolidPart> out;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      const int object = solids_[i].object;
      if (changed_.count(object) == 0) {
        out.push_back(std::move(solids_[i]));
      } else if (i == 0 || solids_[i - 1].object != object) {
        for (ConvexCell& cell : cells_[object]) {
          cell.body.link();
          const Bounds bounds = bounds_of(cell.body.corners);
          out.push_back({object, std::move(cell.body), bounds});
        }
      }
    }
    solids_ = std::move(out);
  }
};

}  // namespace

void split_nested(std::vector<SolidPart>& solids) { Splitter(solids).run(); }

}  // namespace nicol::solids
