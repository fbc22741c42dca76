// Convex cells: see cells.hpp.
#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>

#include "sweep.hpp"

namespace nicol::solids {
namespace {

// Rounded copies are off by 2^-52 each, so a quotient is off by less than 1e-15 of itself.
Bounds loose_bounds(const std::vector<ExactPoint>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds out;
  out.low.fill(infinity);
  out.high.fill(-infinity);
  for (const ExactPoint& p : points) {
    for (int k = 0; k < 3; ++k) {
      const double c = p.approx[k] / p.approx[3], margin = 1e-15 * std::abs(c) + 1e-300;
      const bool known = std::isfinite(c);
      out.low[k] = std::min(out.low[k], known ? c - margin : -infinity);
      out.high[k] = std::max(out.high[k], known ? c + margin : infinity);
    }
  }
  return out;
}

bool apart(const ConvexCell& a, const ConvexCell& b) {
  return disjoint(a.bounds, b.bounds) || separates(a.body, b.body.corners) ||
         separates(b.body, a.body.corners);
}

void add(Cells& cells, Polyhedron body) {
  if (cells.size() >= most_cells) throw TooManyCells{};
  cells.emplace_back(std::move(body));
}

// The faces of b that bound what a and b share, apart from those in faces of a; nothing if the two
// share no volume.
std::optional<std::vector<int>> dividing_faces(const Polyhedron& a, const Polyhedron& b) {
  constexpr int first = -10;  // below all other tags
  Polyhedron shared = a;
  for (int f = 0; f < size_of(b.faces); ++f) {
    if (shared.cut(b.faces[f].plane, first - f) == Cut::empties) return std::nullopt;
  }
  std::vector<int> found;
  for (const Polyhedron::Face& face : shared.faces) {
    if (face.tag <= first) found.push_back(first - face.tag);
  }
  return found;
}

// How far the body reaches beyond a plane, roughly.
double reach(const ExactPlane& plane, const Polyhedron& body) {
  const auto& n = plane.approx;
  double farthest = 0;
  for (const ExactPoint& corner : body.corners) {
    const auto& p = corner.approx;
    const double height = (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / p[3] + n[3];
    farthest = std::max(farthest, height / std::hypot(n[0], n[1], n[2]));
  }
  return farthest;
}

// a without b: one cell outside each dividing face and inside those before it. Each of these faces
// is needed whatever their order, so their number is the least that cutting along faces can give.
// What reaches farthest out is cut off first: large cells stay large.
// False: they share no volume, and `rest` is as it was.
bool subtract(const ConvexCell& a, const ConvexCell& b, Cells& rest) {
  if (apart(a, b)) return false;
  const auto dividing = dividing_faces(a.body, b.body);
  if (!dividing) return false;
  std::vector<std::pair<double, int>> order;
  for (int f : *dividing) order.push_back({-reach(b.body.faces[f].plane, a.body), f});
  std::sort(order.begin(), order.end());
  Polyhedron core = a.body;
  for (const auto& [depth, f] : order) {
    const Polyhedron::Face& face = b.body.faces[f];
    Polyhedron beyond = core;
    beyond.cut(face.plane.opposite(), face.tag);
    core.cut(face.plane, face.tag);
    add(rest, std::move(beyond));
  }
  return true;
}

// Every plane of `body` but that of `shared` has `other` inside.
bool holds_behind(const Polyhedron& body, const Polyhedron::Face& shared, const Polyhedron& other) {
  for (const Polyhedron::Face& face : body.faces) {
    if (&face == &shared) continue;
    for (const ExactPoint& corner : other.corners) {
      if (side(face.plane, corner) > 0) return false;
    }
  }
  return true;
}

// The two cells as one, if they share a face and every other plane of either has the other cell
// inside: the solid inside all of those planes, cut along the shared one, is just the two cells.
std::optional<Polyhedron> convex_union(const Polyhedron& a, const Polyhedron& b) {
  for (const Polyhedron::Face& f : a.faces) {
    for (const Polyhedron::Face& g : b.faces) {
      if (!opposite(f.plane, g.plane)) continue;
      if (!holds_behind(a, f, b) || !holds_behind(b, g, a)) return std::nullopt;
      std::vector<ExactPlane> planes;
      std::vector<int> tags;
      for (const auto& [body, shared] : {std::tie(a, f), std::tie(b, g)}) {
        for (const Polyhedron::Face& face : body.faces) {
          if (&face == &shared) continue;
          planes.push_back(face.plane);
          tags.push_back(face.tag);
        }
      }
      Polyhedron whole = enclose(planes).body;
      for (Polyhedron::Face& face : whole.faces) face.tag = tags[face.tag];
      return whole;
    }
  }
  return std::nullopt;
}

// Puts cells together again where two make a convex one, those from `first_new` on with all others.
void merge_convex(Cells& cells, std::size_t first_new) {
  for (std::size_t i = cells.size(); i-- > first_new;) {
    for (std::size_t j = 0; j < i; ++j) {
      if (disjoint(cells[i].bounds, cells[j].bounds)) continue;
      std::optional<Polyhedron> whole = convex_union(cells[i].body, cells[j].body);
      if (!whole) continue;
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(j));
      cells.emplace_back(std::move(*whole));
      first_new -= j < first_new;
      i = cells.size();
      break;
    }
  }
}

// What of the polygons lies outside `other`, all in one plane.
void take_away(std::vector<Polygon>& polygons, const Polygon& other) {
  std::vector<Polygon> rest;
  for (const Polygon& polygon : polygons) {
    if (!share_area(polygon, other)) {
      rest.push_back(polygon);
      continue;
    }
    Polygon inner = polygon;
    for (const ExactPlane& edge : other.edges) {
      Polygon beyond = inner;
      clip(inner, edge);
      if (clip(beyond, edge.opposite())) rest.push_back(std::move(beyond));
    }
  }
  polygons = std::move(rest);
}

}  // namespace

ConvexCell::ConvexCell(Polyhedron of)
    : body(std::move(of)), bounds(loose_bounds(body.corners)) {}

bool disjoint(const Bounds& a, const Bounds& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return true;
  }
  return false;
}

Cells common(const Cells& a, const Cells& b) {
  Cells out;
  for (const ConvexCell& one : a) {
    for (const ConvexCell& other : b) {
      if (apart(one, other)) continue;
      Polyhedron shared = one.body;
      const bool empty = std::any_of(
          other.body.faces.begin(), other.body.faces.end(), [&](const Polyhedron::Face& face) {
            return shared.cut(face.plane, face.tag) == Cut::empties;
          });
      if (!empty) add(out, std::move(shared));
    }
  }
  merge_convex(out, 0);
  return out;
}

Cells minus(Cells a, const Cells& b) {
  for (const ConvexCell& cutter : b) {
    Cells kept, cut;
    for (ConvexCell& cell : a) {
      if (!subtract(cell, cutter, cut)) kept.push_back(std::move(cell));
    }
    const std::size_t first_new = kept.size();
    std::move(cut.begin(), cut.end(), std::back_inserter(kept));
    if (kept.size() > most_cells) throw TooManyCells{};
    merge_convex(kept, first_new);
    a = std::move(kept);
  }
  return a;
}

// Either way round gives the union; where it is cheap to try both, the fewer cells win.
Cells joined(const Cells& a, const Cells& b) {
  const auto one_and_rest = [](const Cells& whole, const Cells& other) {
    Cells out = whole, rest = minus(other, whole);
    std::move(rest.begin(), rest.end(), std::back_inserter(out));
    if (out.size() > most_cells) throw TooManyCells{};
    merge_convex(out, whole.size());
    return out;
  };
  Cells out = one_and_rest(a, b);
  constexpr std::size_t few = 64;
  if (out.size() <= 2 || a.size() + b.size() > few) return out;
  Cells other_way = one_and_rest(b, a);
  return other_way.size() < out.size() ? other_way : out;
}

void mark_seams(std::vector<Polyhedron>& cells) {
  std::vector<Bounds> boxes;
  for (Polyhedron& cell : cells) {
    cell.link();
    boxes.push_back(loose_bounds(cell.corners));
  }
  std::vector<std::vector<std::vector<Polygon>>> outer(cells.size());
  std::vector<std::vector<bool>> touched(cells.size());
  for (int i = 0; i < size_of(cells); ++i) {
    for (int f = 0; f < size_of(cells[i].faces); ++f) outer[i].push_back({cells[i].polygon(f)});
    touched[i].resize(cells[i].faces.size());
  }
  for (const auto& [a, b] : close_pairs(boxes, 0)) {
    for (int f = 0; f < size_of(cells[a].faces); ++f) {
      for (int g = 0; g < size_of(cells[b].faces); ++g) {
        if (!opposite(cells[a].faces[f].plane, cells[b].faces[g].plane)) continue;
        const Polygon p = cells[a].polygon(f), q = cells[b].polygon(g);
        if (!share_area(p, q)) continue;
        take_away(outer[a][f], q);
        take_away(outer[b][g], p);
        touched[a][f] = touched[b][g] = true;
      }
    }
  }
  for (int i = 0; i < size_of(cells); ++i) {
    std::vector<std::tuple<bool, bool, int, int>> order;
    for (int f = 0; f < size_of(cells[i].faces); ++f) {
      const bool seam = outer[i][f].empty();
      if (seam) cells[i].faces[f].tag = seam_tag;
      order.push_back({seam, touched[i][f], cells[i].faces[f].tag, f});
    }
    std::sort(order.begin(), order.end());
    std::vector<Polyhedron::Face> sorted;
    for (const auto& place : order)
      sorted.push_back(std::move(cells[i].faces[std::get<3>(place)]));
    cells[i].faces = std::move(sorted);
    cells[i].link();
  }
}

}  // namespace nicol::solids
