// Each object of the scene as exact convex parts in world mm: cells of solids, pieces of sheets.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "polyhedron.hpp"
#include "sdl/diagnostics.hpp"

namespace nicol::solids {

struct Bounds {  // rounded outwards
  std::array<double, 3> low{}, high{};
};
Bounds bounds_of(const std::vector<ExactPoint>& points);

struct SolidPart {
  int object = -1;
  Polyhedron body;  // face tags: index of the shape's face, -1 for a seam
  Bounds bounds;
};

struct SheetPart {
  int object = -1;
  int around = -1;  // the solid part that it lies in, -1: the surroundings
  Polygon polygon;  // of a disc: only the plane
  bool is_disc = false;
  ExactPoint centre;  // disc
  double radius_mm = 0, hole_radius_mm = 0;
  Bounds bounds;
};

struct Parts {
  std::vector<SolidPart> solids;
  std::vector<SheetPart> sheets;
};

// What cannot be built is told in `diagnostics` and left out.
Parts make_parts(const Scene& scene, sdl::Diagnostics& diagnostics);

std::string name_of(const Object& object);  // "box at line 12"
std::string text_of(double value);          // short, for messages

}  // namespace nicol::solids
