// Sets of space as disjoint convex cells, and what CSG does to them, exactly. Every plane is one of a
// leaf and every corner is computed from three of them, so numbers do not grow with the number of
// operations.
#pragma once
#include <vector>

#include "parts.hpp"

namespace nicol::solids {

// Face tags: the face of a leaf that the plane comes from, seam_tag, or far_tag.
struct ConvexCell {
  Polyhedron body;
  Bounds bounds;  // in double, a little too large
  explicit ConvexCell(Polyhedron of);
};
using Cells = std::vector<ConvexCell>;

constexpr std::size_t most_cells = 2000;
struct TooManyCells {};  // thrown beyond most_cells

bool disjoint(const Bounds& a, const Bounds& b);

// What lies in both; in a but not in b; in either.
Cells common(const Cells& a, const Cells& b);
Cells minus(Cells a, const Cells& b);
Cells joined(const Cells& a, const Cells& b);

// Says of each face of the cells of one solid how much of it the other cells touch. Faces wholly
// touched become seams (seam_tag). They come last in their cell, after those touched in part, so
// that of two faces met at once the outer one counts. Links the cells.
void mark_seams(std::vector<Polyhedron>& cells);

}  // namespace nicol::solids
