// Even-odd regions of the plane as convex pieces (CGAL's constrained Delaunay triangulation,
// exact).
#pragma once
#include <array>
#include <vector>

#include "exact.hpp"

namespace nicol::solids {

// Corners (x, y, w) counter-clockwise, w > 0. edges[i], from corner i to corner i + 1, is the index
// of the contour edge that it lies on (counted through all contours, edge k runs from point k to
// the next), or -1 where another piece goes on; then that piece has exactly the same edge.
struct PlanarPiece {
  std::vector<Integer3> corners;
  std::vector<int> edges;
};

using Contours = std::vector<std::vector<std::array<double, 2>>>;

// Contours are closed implicitly and may cross. A convex region gives one piece.
std::vector<PlanarPiece> convex_pieces(const Contours& contours);

}  // namespace nicol::solids
