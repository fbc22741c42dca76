// CSG of half-space solids, exactly: intersection, merge, difference.
//
// The result is a list of convex cells that meet in seams, not a surface mesh. A ray then needs no
// search tree and cannot hit where it stands: a convex cell has one exit, the nearest plane ahead.
// Touching, nesting and optical contact work as for single convex solids, and a shared edge or
// corner, which no mesh of one surface can hold, is no special case. Cells come from cutting along
// the faces of the operands alone (Thibault & Naylor 1987, set operations on trees of planes), which
// is far less than a general convex decomposition of the finished surface would give.
#pragma once
#include <string>
#include <vector>

#include "polyhedron.hpp"

namespace nicol::solids {

struct CsgResult {
  // Disjoint, linked, in world mm. Face tags: index of the face, counted through all leaves in
  // the order of the tree; seam_tag where the other cells cover all of the face.
  std::vector<Polyhedron> cells;
  std::string wrong;  // what is wrong, if anything, and
  Location where;     // at which operand
};

// `outer` are the transforms of the object around the tree.
CsgResult make_csg(const CsgShape& shape, const std::vector<Affine>& outer);

}  // namespace nicol::solids
