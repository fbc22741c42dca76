// The one file that compiles CGAL. Triangulates the contours exactly (crossings included), keeps
// the triangles inside by the even-odd rule, and merges them greedily to convex pieces (Hertel &
// Mehlhorn 1983, at most four times as many pieces as needed; the better of two orders is taken).
// Pieces meet along whole edges.
#include "planar.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace nicol::solids {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// With "plus", crossings are computed from whole contour edges, so that numbers do not grow from
// cut to cut.
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_intersections_tag>>;
using Point = Kernel::Point_2;

constexpr int outer =
    -1;  // Triangulation::Face::info of what lies outside, else the triangle's index

struct ContourEdge {
  Point from, to;
};

std::vector<ContourEdge> contour_edges(const Contours& contours) {
  std::vector<ContourEdge> edges;
  for (const auto& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const auto& p = contour[i];
      const auto& q = contour[(i + 1) % contour.size()];
      edges.push_back({Point(p[0], p[1]), Point(q[0], q[1])});
    }
  }
  return edges;
}

bool inside_even_odd(const std::vector<ContourEdge>& edges, const Point& p) {
  bool inside = false;
  for (const ContourEdge& e : edges) {
    const bool up = CGAL::compare_y(e.to, p) == CGAL::LARGER;
    if ((CGAL::compare_y(e.from, p) == CGAL::LARGER) == up) continue;
    const auto turn = CGAL::orientation(e.from, e.to, p);
    if (turn == (up ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN)) inside = !inside;
  }
  return inside;
}

int contour_edge_under(const std::vector<ContourEdge>& edges, const Point& p, const Point& q) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const ContourEdge& e = edges[k];
    if (e.from == e.to || !CGAL::collinear(e.from, e.to, p) || !CGAL::collinear(e.from, e.to, q))
      continue;
    const Point middle = CGAL::midpoint(p, q);
    if (CGAL::collinear_are_ordered_along_line(e.from, middle, e.to)) return static_cast<int>(k);
  }
  return -1;
}

template <class Exact>
mpq_class to_rational(const Exact& value) {
  std::ostringstream text;
  text << value;
  mpq_class out(text.str());
  out.canonicalize();
  return out;
}

mpq_class rational(const Kernel::FT& value) {
  const double rounded = CGAL::to_double(value);
  return value == Kernel::FT(rounded) ? mpq_class(rounded) : to_rational(CGAL::exact(value));
}

Integer3 homogeneous(const Point& p) {
  const mpq_class x = rational(p.x()), y = rational(p.y());
  return {x.get_num() * y.get_den(), y.get_num() * x.get_den(), x.get_den() * y.get_den()};
}

// A piece being merged: vertex indices counter-clockwise; `inner[i]`: another piece lies across the
// edge from corner i to corner i + 1.
struct Loop {
  std::vector<int> corners;
  std::vector<bool> inner;
};

class Merger {
 public:
  Merger(std::vector<Point> points, std::vector<Loop> triangles)
      : points_(std::move(points)), loops_(std::move(triangles)) {
    for (std::size_t i = 0; i < loops_.size(); ++i) owner_.push_back(static_cast<int>(i));
  }

  // Joins the owners of triangles a and b across the edge u -> v of a, if what results is convex.
  void join(int a, int b, int u, int v) {
    const int p = root(a), q = root(b);
    if (p == q) return;
    Loop &left = loops_[p], &right = loops_[q];
    const auto at_u = find(left, u), at_v = find(right, v);
    Loop merged;
    append(merged, left, (at_u + 1) % left.corners.size());    // v ... before u
    append(merged, right, (at_v + 1) % right.corners.size());  // u ... before v
    if (!convex_at(merged, 0) || !convex_at(merged, left.corners.size() - 1)) return;
    left = std::move(merged);
    right = {};
    owner_[q] = p;
  }

  // The pieces, without corners on straight stretches of the boundary.
  std::vector<Loop> pieces() const {
    std::vector<Loop> out;
    for (const Loop& loop : loops_) {
      if (loop.corners.empty()) continue;
      Loop tidy;
      for (std::size_t i = 0; i < loop.corners.size(); ++i) {
        if (turn(loop, i) == CGAL::COLLINEAR) continue;
        tidy.corners.push_back(loop.corners[i]);
        tidy.inner.push_back(loop.inner[i]);
      }
      out.push_back(std::move(tidy));
    }
    return out;
  }

 private:
  std::vector<Point> points_;
  std::vector<Loop> loops_;
  std::vector<int> owner_;

  int root(int i) const {
    while (owner_[i] != i) i = owner_[i];
    return i;
  }
  static std::size_t find(const Loop& loop, int corner) {
    return std::find(loop.corners.begin(), loop.corners.end(), corner) - loop.corners.begin();
  }
  static void append(Loop& to, const Loop& from, std::size_t start) {
    const std::size_t n = from.corners.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
      to.corners.push_back(from.corners[(start + i) % n]);
      to.inner.push_back(from.inner[(start + i) % n]);
    }
  }
  CGAL::Orientation turn(const Loop& loop, std::size_t i) const {
    const std::size_t n = loop.corners.size();
    return CGAL::orientation(points_[loop.corners[(i + n - 1) % n]], points_[loop.corners[i]],
                             points_[loop.corners[(i + 1) % n]]);
  }
  // A straight angle is good only on the boundary: elsewhere another piece would end in mid-edge.
  bool convex_at(const Loop& loop, std::size_t i) const {
    const CGAL::Orientation t = turn(loop, i);
    const bool boundary =
        !loop.inner[i] && !loop.inner[(i + loop.inner.size() - 1) % loop.inner.size()];
    return t == CGAL::LEFT_TURN || (t == CGAL::COLLINEAR && boundary);
  }
};

void insert(Triangulation& triangulation, const Contours& contours) {
  for (const auto& contour : contours) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const auto& p : contour) handles.push_back(triangulation.insert(Point(p[0], p[1])));
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const auto &from = handles[i], &to = handles[(i + 1) % handles.size()];
      if (from != to) triangulation.insert_constraint(from, to);
    }
  }
}

// Numbers the vertices and the triangles inside, in the order of their coordinates.
std::vector<Triangulation::Face_handle> number(Triangulation& triangulation,
                                               const std::vector<ContourEdge>& edges) {
  std::vector<Triangulation::Vertex_handle> vertices;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v) {
    vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end(),
            [](const auto& a, const auto& b) { return a->point() < b->point(); });
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i]->info() = static_cast<int>(i);
  for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f)
    f->info() = outer;

  using Handle = Triangulation::Face_handle;
  std::vector<Handle> inside;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    const Point middle = CGAL::centroid(triangulation.triangle(f));
    if (inside_even_odd(edges, middle)) inside.push_back(f);
  }
  const auto key = [](const Handle& f) {
    std::array<int, 3> k{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    std::sort(k.begin(), k.end());
    return k;
  };
  std::sort(inside.begin(), inside.end(),
            [&](const Handle& a, const Handle& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i]->info() = static_cast<int>(i);
  return inside;
}

// An edge u -> v of triangle a, with triangle b on its other side.
struct Diagonal {
  int a, b, u, v;
  double length;
};

// Shortest first.
std::vector<Diagonal> diagonals_of(const std::vector<Triangulation::Face_handle>& inside,
                                   const std::vector<Point>& points) {
  std::vector<Diagonal> out;
  for (const auto& f : inside) {
    for (int i = 0; i < 3; ++i) {
      const int a = f->info(), b = f->neighbor(Triangulation::cw(i))->info();
      const int u = f->vertex(i)->info(), v = f->vertex(Triangulation::ccw(i))->info();
      if (a < b)
        out.push_back({a, b, u, v, CGAL::to_double(CGAL::squared_distance(points[u], points[v]))});
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Diagonal& d, const Diagonal& e) { return d.length < e.length; });
  return out;
}

std::vector<Loop> merged(const std::vector<Point>& points, const std::vector<Loop>& triangles,
                         std::vector<Diagonal> diagonals) {
  std::vector<Loop> best;
  for (int order = 0; order < 2; ++order) {
    Merger merger(points, triangles);
    for (const Diagonal& d : diagonals) merger.join(d.a, d.b, d.u, d.v);
    std::vector<Loop> pieces = merger.pieces();
    if (order == 0 || pieces.size() < best.size()) best = std::move(pieces);
    std::reverse(diagonals.begin(), diagonals.end());
  }
  return best;
}

}  // namespace

std::vector<PlanarPiece> convex_pieces(const Contours& contours) {
  Triangulation triangulation;
  insert(triangulation, contours);
  const std::vector<ContourEdge> edges = contour_edges(contours);
  const auto inside = number(triangulation, edges);

  std::vector<Point> points(triangulation.number_of_vertices());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v) {
    points[v->info()] = v->point();
  }
  std::vector<Loop> triangles;
  for (const auto& f : inside) {
    Loop loop;
    for (int i = 0; i < 3; ++i) {
      loop.corners.push_back(f->vertex(i)->info());
      loop.inner.push_back(f->neighbor(Triangulation::cw(i))->info() != outer);
    }
    triangles.push_back(std::move(loop));
  }
  const std::vector<Loop> pieces = merged(points, triangles, diagonals_of(inside, points));

  std::vector<PlanarPiece> out;
  for (const Loop& loop : pieces) {
    PlanarPiece piece;
    const std::size_t n = loop.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &p = points[loop.corners[i]], &q = points[loop.corners[(i + 1) % n]];
      piece.corners.push_back(homogeneous(p));
      piece.edges.push_back(loop.inner[i] ? -1 : contour_edge_under(edges, p, q));
    }
    out.push_back(std::move(piece));
  }
  return out;
}

}  // namespace nicol::solids
