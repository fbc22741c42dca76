// Nesting: see nesting.hpp.
#include "nesting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "cells.hpp"
#include "disc.hpp"
#include "sweep.hpp"

namespace nicol::solids {
namespace {

// How far one part would have to move along a face normal of either to come free of the other.
double overlap_depth_mm(const Polyhedron& a, const Polyhedron& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [body, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const Polyhedron::Face& face : body->faces) {
      double depth = 0;
      for (const ExactPoint& corner : other->corners)
        depth = std::max(depth, -distance(face.plane, corner));
      least = std::min(least, depth);
    }
  }
  return least;
}

std::string overlap_message(const Scene& scene, const std::vector<SolidPart>& solids, int a, int b,
                            double near_mm) {
  const SolidPart &first = solids[a], &second = solids[b];
  const std::string names =
      name_of(scene.objects[first.object]) + " and " + name_of(scene.objects[second.object]);
  const std::string message = names + " overlap; solids may touch or lie wholly inside one another";
  const double depth_mm = overlap_depth_mm(first.body, second.body);
  if (depth_mm > near_mm) return message;
  return message + ". They overlap by " + text_of(depth_mm) +
         " mm only: where they should touch, write the same numbers and transforms in both";
}

int deepest(const std::vector<int>& containers,
            const std::vector<std::vector<int>>& containers_of) {
  int best = -1;
  for (int c : containers) {
    if (best < 0 || containers_of[c].size() > containers_of[best].size()) best = c;
  }
  return best;
}

// How many solids a part lies in.
int depth(const Nesting& nesting, int part) {
  int levels = 0;
  for (; part >= 0; part = nesting.parent[part]) ++levels;
  return levels;
}

}  // namespace

Nesting nest(const Scene& scene, const std::vector<SolidPart>& solids, double near_mm,
             sdl::Diagnostics& diagnostics) {
  std::vector<Bounds> boxes;
  for (const SolidPart& part : solids) boxes.push_back(part.bounds);
  Nesting out;
  out.neighbours = close_pairs(boxes, near_mm);
  std::vector<std::vector<int>> containers(solids.size());
  std::set<std::pair<int, int>> told;
  for (const auto& [a, b] : out.neighbours) {
    const SolidPart &first = solids[a], &second = solids[b];
    if (first.object == second.object || disjoint(first.bounds, second.bounds)) continue;
    const Relation relation = relate(first.body, second.body);
    if (relation == Relation::a_holds_b) containers[b].push_back(a);
    if (relation == Relation::b_holds_a) containers[a].push_back(b);
    if (relation != Relation::overlap && relation != Relation::equal) continue;
    if (!told.insert(std::minmax(first.object, second.object)).second) continue;
    diagnostics.error(scene.objects[second.object].where,
                      relation == Relation::equal
                          ? name_of(scene.objects[first.object]) + " and " +
                                name_of(scene.objects[second.object]) + " fill the same space"
                          : overlap_message(scene, solids, a, b, near_mm));
  }
  for (const auto& list : containers) out.parent.push_back(deepest(list, containers));
  return out;
}

namespace {

enum class Lie { outside, inside, across };

Lie lie_of_polygon(const Polygon& polygon, const Polyhedron& body) {
  if (separates(body, polygon.corners)) return Lie::outside;
  bool above = false, below = false;
  for (const ExactPoint& corner : body.corners) {
    const int s = side(polygon.plane, corner);
    above |= s > 0;
    below |= s < 0;
  }
  if (!above || !below) return Lie::outside;
  return holds(body, polygon.corners) ? Lie::inside : Lie::across;
}

Lie lie_of_disc(const SheetPart& sheet, const Polyhedron& body) {
  bool inside = true;
  for (const Polyhedron::Face& face : body.faces) {
    const DiscSide where = disc_side(face.plane, sheet);
    if (where == DiscSide::outside || where == DiscSide::on) return Lie::outside;
    inside &= where == DiscSide::inside;
  }
  if (inside) return Lie::inside;
  Polyhedron below = body;
  if (below.cut(sheet.polygon.plane, 0) != Cut::cuts) return Lie::outside;
  below.link();
  const Polygon section = below.polygon(size_of(below.faces) - 1);
  return disc_covers_some(sheet, section.plane, section.corners) ? Lie::across : Lie::outside;
}

// The piece inside the body replaces `sheet`; what is outside goes to `rest`. False: they do not
// meet.
bool split(SheetPart& sheet, const Polyhedron& body, std::vector<SheetPart>& rest) {
  SheetPart inner = sheet;
  std::vector<SheetPart> outer;
  for (const Polyhedron::Face& face : body.faces) {
    SheetPart beyond = inner;
    if (!clip(inner.polygon, face.plane)) return false;
    if (!clip(beyond.polygon, face.plane.opposite())) continue;
    beyond.bounds = bounds_of(beyond.polygon.corners);
    outer.push_back(std::move(beyond));
  }
  inner.bounds = bounds_of(inner.polygon.corners);
  sheet = std::move(inner);
  rest.insert(rest.end(), outer.begin(), outer.end());
  return true;
}

// Places one sheet against the solids near it; its pieces, each with what it lies in.
std::vector<SheetPart> placed(const Scene& scene, const SheetPart& sheet,
                              const std::vector<int>& near, const Parts& parts,
                              const Nesting& nesting, sdl::Diagnostics& diagnostics) {
  std::vector<SheetPart> pieces{sheet};
  for (int s : near) {
    const SolidPart& solid = parts.solids[s];
    const std::size_t count = pieces.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (disjoint(pieces[i].bounds, solid.bounds)) continue;
      Lie lie = sheet.is_disc ? lie_of_disc(sheet, solid.body)
                              : lie_of_polygon(pieces[i].polygon, solid.body);
      if (lie == Lie::across && sheet.is_disc) {
        diagnostics.error(scene.objects[sheet.object].where,
                          name_of(scene.objects[sheet.object]) + " passes through the surface of " +
                              name_of(scene.objects[solid.object]) +
                              "; make it a polygon to have it cut there");
        continue;
      }
      if (lie == Lie::across && split(pieces[i], solid.body, pieces)) lie = Lie::inside;
      SheetPart& piece = pieces[i];
      if (lie == Lie::inside && depth(nesting, s) > depth(nesting, piece.around)) piece.around = s;
    }
  }
  return pieces;
}

// Whether the sheet lies in a seam: where two parts of one solid meet, on part of either.
bool lies_in_seam(const SheetPart& sheet, const std::vector<int>& near, const Parts& parts,
                  int& object) {
  struct Touched {
    int object;
    Polygon face;
  };
  std::vector<Touched> touched;
  for (int s : near) {
    const SolidPart& part = parts.solids[s];
    for (int f = 0; f < size_of(part.body.faces); ++f) {
      const ExactPlane& plane = part.body.faces[f].plane;
      if (!same(plane, sheet.polygon.plane) && !opposite(plane, sheet.polygon.plane)) continue;
      const Polygon face = part.body.polygon(f);
      for (const Touched& other : touched) {
        if (other.object != part.object || !opposite(other.face.plane, plane)) continue;
        Polygon shared = face;
        const bool apart = std::any_of(
            other.face.edges.begin(), other.face.edges.end(),
            [&](const ExactPlane& edge) { return !clip(shared, edge); });
        object = part.object;
        if (apart) continue;
        if (sheet.is_disc ? disc_covers_some(sheet, plane, shared.corners)
                          : share_area(shared, sheet.polygon))
          return true;
      }
      touched.push_back({part.object, face});
    }
  }
  return false;
}

}  // namespace

void place_sheets(const Scene& scene, Parts& parts, const Nesting& nesting,
                  sdl::Diagnostics& diagnostics) {
  const int solid_count = size_of(parts.solids);
  std::vector<Bounds> boxes;
  for (const SolidPart& part : parts.solids) boxes.push_back(part.bounds);
  for (const SheetPart& sheet : parts.sheets) boxes.push_back(sheet.bounds);
  std::vector<std::vector<int>> near(parts.sheets.size());
  if (!parts.sheets.empty()) {
    for (const auto& [a, b] : close_pairs(boxes, 0)) {
      if (a < solid_count && b >= solid_count) near[b - solid_count].push_back(a);
    }
  }
  std::vector<SheetPart> out;
  for (int i = 0; i < size_of(parts.sheets); ++i) {
    const Object& object = scene.objects[parts.sheets[i].object];
    int solid = -1;
    if (lies_in_seam(parts.sheets[i], near[i], parts, solid))
      diagnostics.error(object.where, name_of(object) + " lies inside " +
                                          name_of(scene.objects[solid]) +
                                          " just where two of its convex parts meet; move it a "
                                          "little, or make two solids there");
    for (SheetPart& piece : placed(scene, parts.sheets[i], near[i], parts, nesting, diagnostics)) {
      out.push_back(std::move(piece));
    }
  }
  parts.sheets = std::move(out);
}

namespace {

// The faces that the point lies on, of a body that does not have it outside; nothing otherwise.
std::optional<std::vector<const Polyhedron::Face*>> faces_under(const ExactPoint& point,
                                                                const Polyhedron& body) {
  std::vector<const Polyhedron::Face*> found;
  for (const Polyhedron::Face& face : body.faces) {
    const int where = side(face.plane, point);
    if (where > 0) return std::nullopt;
    if (where == 0) found.push_back(&face);
  }
  return found;
}

}  // namespace

int part_around(const ExactPoint& point, const Parts& parts, const Nesting& nesting,
                bool& on_surface) {
  int around = -1;
  std::vector<std::pair<int, const Polyhedron::Face*>> single;  // parts with the point on one face
  std::set<int> bare;  // solids with the point on their boundary, or on an edge of seams
  for (int i = 0; i < size_of(parts.solids); ++i) {
    const auto under = faces_under(point, parts.solids[i].body);
    if (!under) continue;
    bool within = under->empty();
    if (under->size() == 1) {
      const auto twin = std::find_if(single.begin(), single.end(), [&](const auto& other) {
        return parts.solids[other.first].object == parts.solids[i].object &&
               opposite(other.second->plane, under->front()->plane);
      });
      within = twin != single.end();
      single.push_back({i, under->front()});
    }
    if (within) bare.erase(parts.solids[i].object);
    if (!within) bare.insert(parts.solids[i].object);
    if (within && depth(nesting, i) > depth(nesting, around)) around = i;
  }
  on_surface = !bare.empty();
  return around;
}

}  // namespace nicol::solids
