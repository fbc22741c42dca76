// What lies inside what: cells in cells, sheets in cells; overlaps that are neither nesting nor
// touching are errors.
#pragma once
#include <utility>
#include <vector>

#include "parts.hpp"

namespace nicol::solids {

struct Nesting {
  std::vector<int> parent;                      // of each solid part, -1: the surroundings
  std::vector<std::pair<int, int>> neighbours;  // solid parts whose boxes come close, in order
};

// Splits solids that lie inside another across several of its cells, so that each of their cells lies
// inside one.
void split_nested(std::vector<SolidPart>& solids);

// `near_mm` is how close boxes must come to be listed as neighbours.
Nesting nest(const Scene& scene, const std::vector<SolidPart>& solids, double near_mm,
             sdl::Diagnostics& diagnostics);

// Cuts sheets at the surfaces of solids that they pass through and notes what each piece lies in. A
// sheet in a face of a solid lies outside of that solid.
void place_sheets(const Scene& scene, Parts& parts, const Nesting& nesting,
                  sdl::Diagnostics& diagnostics);

// The innermost part with the point inside (for a point on a seam one of its two parts);
// `on_surface` if it is on the boundary of some part otherwise.
int part_around(const ExactPoint& point, const Parts& parts, const Nesting& nesting,
                bool& on_surface);

}  // namespace nicol::solids
