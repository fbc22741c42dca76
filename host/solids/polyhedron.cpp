// Clipping: see polyhedron.hpp.
#include "polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nicol::solids {
namespace {

// An edge that the plane crosses, as seen from one of its two faces.
struct Crossing {
  int low, high, face;
  bool operator<(const Crossing& o) const {
    return std::tie(low, high, face) < std::tie(o.low, o.high, o.face);
  }
};

std::vector<Crossing> crossings(const Polyhedron& body, const std::vector<int>& sign) {
  std::vector<Crossing> found;
  for (int f = 0; f < size_of(body.faces); ++f) {
    const std::vector<int>& loop = body.faces[f].corners;
    for (int i = 0; i < size_of(loop); ++i) {
      const int u = loop[i], v = loop[(i + 1) % size_of(loop)];
      if (sign[u] * sign[v] < 0) found.push_back({std::min(u, v), std::max(u, v), f});
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The part of a loop that is not outside, with the new corners on crossed edges (pairs of
// `crossed`).
std::vector<int> clipped_loop(const std::vector<int>& loop, const std::vector<int>& sign,
                              const std::vector<Crossing>& crossed, int first_new) {
  std::vector<int> out;
  for (int i = 0; i < size_of(loop); ++i) {
    const int u = loop[i], v = loop[(i + 1) % size_of(loop)];
    if (sign[u] <= 0) out.push_back(u);
    if (sign[u] * sign[v] < 0) {
      const Crossing key{std::min(u, v), std::max(u, v), -1};
      const auto at = std::lower_bound(crossed.begin(), crossed.end(), key) - crossed.begin();
      out.push_back(first_new + static_cast<int>(at / 2));
    }
  }
  return out;
}

void drop_unused_corners(Polyhedron& body) {
  std::vector<int> index(body.corners.size(), -1);
  for (const auto& face : body.faces) {
    for (int corner : face.corners) index[corner] = 0;
  }
  int kept = 0;
  for (int i = 0; i < size_of(body.corners); ++i) {
    if (index[i] < 0) continue;
    index[i] = kept;
    if (kept != i) body.corners[kept] = std::move(body.corners[i]);
    ++kept;
  }
  body.corners.resize(kept);
  for (auto& face : body.faces) {
    for (int& corner : face.corners) corner = index[corner];
  }
}

}  // namespace

Cut Polyhedron::cut(const ExactPlane& plane, int tag) {
  std::vector<int> sign(corners.size());
  bool some_inside = false, some_outside = false;
  for (int i = 0; i < size_of(corners); ++i) {
    sign[i] = side(plane, corners[i]);
    some_inside |= sign[i] < 0;
    some_outside |= sign[i] > 0;
  }
  if (!some_inside) return Cut::empties;
  if (!some_outside) return Cut::misses;

  const std::vector<Crossing> crossed = crossings(*this, sign);
  const int first_new = size_of(corners);
  for (std::size_t i = 0; i < crossed.size(); i += 2) {
    corners.push_back(meet(faces[crossed[i].face].plane, faces[crossed[i + 1].face].plane, plane));
  }
  sign.resize(corners.size(), 0);

  // Each face that keeps some inside has at most one edge on the plane; the new face runs along it
  // backwards.
  std::vector<Face> kept;
  std::vector<std::pair<int, int>> rim;
  for (Face& face : faces) {
    const bool inside =
        std::any_of(face.corners.begin(), face.corners.end(), [&](int c) { return sign[c] < 0; });
    if (!inside) continue;
    face.corners = clipped_loop(face.corners, sign, crossed, first_new);
    for (int i = 0; i < size_of(face.corners); ++i) {
      const int u = face.corners[i], v = face.corners[(i + 1) % size_of(face.corners)];
      if (sign[u] == 0 && sign[v] == 0) rim.push_back({v, u});
    }
    kept.push_back(std::move(face));
  }
  std::sort(rim.begin(), rim.end());
  Face cap{plane, tag, {}, {}};
  int corner = rim.front().first;
  do {
    cap.corners.push_back(corner);
    corner = std::lower_bound(rim.begin(), rim.end(), std::make_pair(corner, -1))->second;
  } while (corner != rim.front().first);
  kept.push_back(std::move(cap));
  faces = std::move(kept);
  drop_unused_corners(*this);
  return Cut::cuts;
}

void Polyhedron::link() {
  struct Edge {
    int from, to, face;
    bool operator<(const Edge& o) const { return std::tie(from, to) < std::tie(o.from, o.to); }
  };
  std::vector<Edge> edges;
  for (int f = 0; f < size_of(faces); ++f) {
    const std::vector<int>& loop = faces[f].corners;
    for (int i = 0; i < size_of(loop); ++i) {
      edges.push_back({loop[i], loop[(i + 1) % size_of(loop)], f});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (Face& face : faces) {
    face.neighbours.clear();
    for (int i = 0; i < size_of(face.corners); ++i) {
      const Edge back{face.corners[(i + 1) % size_of(face.corners)], face.corners[i], -1};
      face.neighbours.push_back(std::lower_bound(edges.begin(), edges.end(), back)->face);
    }
  }
}

void Polyhedron::transform(const ExactAffine& affine) {
  for (ExactPoint& corner : corners) corner = affine(corner);
  for (Face& face : faces) {
    face.plane = affine(face.plane);
    if (affine.mirrors()) std::reverse(face.corners.begin(), face.corners.end());
  }
  link();
}

Polygon Polyhedron::polygon(int face) const {
  Polygon out;
  out.plane = faces[face].plane;
  for (int corner : faces[face].corners) out.corners.push_back(corners[corner]);
  for (int neighbour : faces[face].neighbours) out.edges.push_back(faces[neighbour].plane);
  return out;
}

// A cube around every point where three of the planes can meet: by Cramer's rule such a point is a
// ratio of 3x3 determinants of the integers, below 6 x 2^(3 bits), over an integer of at least 1.
// It is larger still, so that its corners show the directions in which the planes are open.
Polyhedron far_cube(const std::vector<ExactPlane>& planes) {
  std::size_t bits = 1;
  for (const ExactPlane& plane : planes) {
    for (const Integer& value : plane.v)
      bits = std::max(bits, mpz_sizeinbase(value.get_mpz_t(), 2));
  }
  const Integer far = Integer(1) << (3 * bits + 64);
  Polyhedron cube;
  for (int i = 0; i < 8; ++i) {
    cube.corners.emplace_back(Integer4{i & 1 ? far : Integer(-far), i & 2 ? far : Integer(-far),
                                       i & 4 ? far : Integer(-far), 1});
  }
  const std::vector<std::vector<int>> loops{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (int f = 0; f < 6; ++f) {
    Integer4 plane{0, 0, 0, Integer(-far)};
    plane[f / 2] = f % 2 ? 1 : -1;
    cube.faces.push_back({ExactPlane(std::move(plane)), far_tag, loops[f], {}});
  }
  return cube;
}

bool is_open(const Polyhedron& body) {
  return std::any_of(body.faces.begin(), body.faces.end(),
                     [](const Polyhedron::Face& face) { return face.tag == far_tag; });
}

Vec3 open_towards(const Polyhedron& body) {
  Vec3 sum;
  for (const Polyhedron::Face& face : body.faces) {
    if (face.tag != far_tag) continue;
    for (int corner : face.corners) {
      const auto& p = body.corners[corner].approx;
      const double size = std::hypot(p[0], p[1], p[2]);
      sum = {sum.x + p[0] / size, sum.y + p[1] / size, sum.z + p[2] / size};
    }
  }
  const double size = std::max(std::hypot(sum.x, sum.y, sum.z), 1e-9);
  const auto tidy = [&](double c) { return std::round(c / size * 1000) / 1000 + 0.0; };
  return {tidy(sum.x), tidy(sum.y), tidy(sum.z)};
}

Enclosure enclose(const std::vector<ExactPlane>& planes) {
  Enclosure out;
  out.body = far_cube(planes);
  for (int i = 0; i < size_of(planes); ++i) {
    if (out.body.cut(planes[i], i) != Cut::empties) continue;
    out.state = Enclosure::State::empty;
    out.emptied_by = i;
    return out;
  }
  if (is_open(out.body)) {
    out.state = Enclosure::State::unbounded;
    out.open_towards = open_towards(out.body);
    return out;
  }
  std::sort(out.body.faces.begin(), out.body.faces.end(),
            [](const auto& a, const auto& b) { return a.tag < b.tag; });
  out.body.link();
  return out;
}

bool holds(const Polyhedron& body, const std::vector<ExactPoint>& points) {
  for (const Polyhedron::Face& face : body.faces) {
    for (const ExactPoint& point : points) {
      if (side(face.plane, point) > 0) return false;
    }
  }
  return true;
}

bool separates(const Polyhedron& body, const std::vector<ExactPoint>& points) {
  for (const Polyhedron::Face& face : body.faces) {
    const auto outside = [&](const ExactPoint& point) { return side(face.plane, point) >= 0; };
    if (std::all_of(points.begin(), points.end(), outside)) return true;
  }
  return false;
}

Relation relate(const Polyhedron& a, const Polyhedron& b) {
  if (separates(a, b.corners) || separates(b, a.corners)) return Relation::apart;
  const bool b_in_a = holds(a, b.corners), a_in_b = holds(b, a.corners);
  if (b_in_a && a_in_b) return Relation::equal;
  if (b_in_a) return Relation::a_holds_b;
  if (a_in_b) return Relation::b_holds_a;
  Polyhedron common = a;
  for (const Polyhedron::Face& face : b.faces) {
    if (common.cut(face.plane, -1) == Cut::empties) return Relation::apart;
  }
  return Relation::overlap;
}

// Two convex polygons of one plane share an area unless a line through an edge of either parts
// them.
bool share_area(const Polygon& a, const Polygon& b) {
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const ExactPlane& edge : one->edges) {
      const auto outside = [&](const ExactPoint& corner) { return side(edge, corner) >= 0; };
      if (std::all_of(other->corners.begin(), other->corners.end(), outside)) return false;
    }
  }
  return true;
}

bool clip(Polygon& polygon, const ExactPlane& plane) {
  const int n = size_of(polygon.corners);
  std::vector<int> sign(n);
  bool some_inside = false, some_outside = false;
  for (int i = 0; i < n; ++i) {
    sign[i] = side(plane, polygon.corners[i]);
    some_inside |= sign[i] < 0;
    some_outside |= sign[i] > 0;
  }
  if (!some_inside) return false;
  if (!some_outside) return true;
  Polygon out;
  out.plane = polygon.plane;
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    if (sign[i] <= 0) {
      // An edge that leaves from a corner on the plane to the outside is replaced by the cut.
      out.corners.push_back(polygon.corners[i]);
      out.edges.push_back(sign[i] == 0 && sign[next] > 0 ? plane : polygon.edges[i]);
    }
    if (sign[i] * sign[next] < 0) {
      out.corners.push_back(meet(polygon.plane, polygon.edges[i], plane));
      out.edges.push_back(sign[i] < 0 ? plane : polygon.edges[i]);
    }
  }
  polygon = std::move(out);
  return true;
}

}  // namespace nicol::solids
