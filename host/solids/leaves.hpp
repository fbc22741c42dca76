// Half-space solids as convex pieces: lists of planes, each with the face of the shape that it is.
#pragma once
#include <string>
#include <vector>

#include "exact.hpp"

namespace nicol::solids {

struct Leaf {
  struct Piece {
    std::vector<ExactPlane> planes;  // outward, in the shape's own coordinates
    std::vector<int> tags;           // index of the shape's face, seam_tag between pieces
  };
  std::vector<Piece> pieces;  // disjoint, meeting in whole faces (of a mesh: perhaps in parts)
  int face_count = 0;
  std::string wrong;  // what the shape "has" or "needs" if it cannot be built
};

// What is wrong with transforms ("is ...", "has ..."), or "".
std::string wrong_with(const std::vector<Affine>& transforms);

Leaf leaf_of(const ConvexShape& shape);  // one piece; whether it is closed is left open
Leaf leaf_of(const PrismShape& shape);
Leaf leaf_of(const MeshShape& shape);  // mesh.cpp; pieces may meet in parts of faces

}  // namespace nicol::solids
