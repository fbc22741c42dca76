// Closed meshes as convex pieces. A convex one is the half-spaces of its faces. Any other is split by the planes of its own faces
// until no face is left inside a piece: the piece behind a face with nothing behind it is inside (the solid BSP tree of
// W. Thibault and B. Naylor, Set operations on polyhedra using binary space partitioning trees, SIGGRAPH 1987). All of it is
// exact: corners are where three planes meet. Proved by tests/solids/mesh_test.cpp against box, prism and CSG.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "cells.hpp"
#include "flat.hpp"
#include "leaves.hpp"

namespace nicol::solids {
namespace {

constexpr double flat_within = 1e-9;         // of the mesh's size
constexpr double same_volume_within = 1e-6;  // of the volume

struct Fault {
  std::string what;  // "has ...", "is ..."
};

std::string face_text(int face) { return "face " + std::to_string(face); }

std::string point_text(const Vec3& p) {
  return "<" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + ">";
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// Six times the volume of the pyramid over a triangle, from `apex`.
double six_volumes(const Vec3& apex, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = minus(a, apex), q = minus(b, apex), r = minus(c, apex);
  return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
}

double volume_of(const Polyhedron& body) {
  double sum = 0;
  const Vec3 apex = rounded(body.corners[0]);
  for (const Polyhedron::Face& face : body.faces)
    for (int i = 1; i + 1 < size_of(face.corners); ++i)
      sum += six_volumes(apex, rounded(body.corners[face.corners[0]]), rounded(body.corners[face.corners[i]]),
                         rounded(body.corners[face.corners[i + 1]]));
  return sum / 6;
}

// A face's plane, and what of the face is still to be placed.
struct Fragment {
  Polygon polygon;
  int face = 0;
};

class MeshSolid {
 public:
  explicit MeshSolid(const MeshShape& shape) : shape_(shape) {}

  Leaf leaf() {
    check_numbers();
    check_edges();
    find_planes();
    check_volume_sign();
    leaf_.face_count = size_of(shape_.faces);
    if (is_convex()) one_piece();
    else many_pieces();
    check_volume();
    return std::move(leaf_);
  }

 private:
  const MeshShape& shape_;
  std::vector<ExactPoint> points_;
  std::vector<ExactPlane> planes_;  // of the faces, outward
  double size_ = 0, volume_ = 0, built_volume_ = 0;
  Leaf leaf_;
  std::vector<ExactPlane> path_;  // of the piece at hand, from the root of the tree

  const Vec3& at(int face, int corner) const {
    const auto& corners = shape_.faces[face];
    return shape_.points[corners[corner % size_of(corners)]];
  }

  void check_numbers() {
    if (shape_.faces.size() < 4) throw Fault{"has fewer than four faces"};
    for (const Vec3& p : shape_.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Fault{"has a point that is not finite"};
      points_.emplace_back(p);
    }
    for (int f = 0; f < size_of(shape_.faces); ++f) {
      if (shape_.faces[f].size() < 3) throw Fault{"has a " + face_text(f) + " of fewer than three points"};
      for (int corner : shape_.faces[f])
        if (corner < 0 || corner >= size_of(shape_.points))
          throw Fault{"has a " + face_text(f) + " with a point " + std::to_string(corner) + " that is not there"};
    }
    for (const Vec3& p : shape_.points) {
      const Vec3 d = minus(p, shape_.points[0]);
      size_ = std::max(size_, std::hypot(d.x, d.y, d.z));
    }
  }

  // Every edge is walked once in each direction. Points at the same place are one.
  void check_edges() const {
    std::map<std::tuple<double, double, double>, int> place;
    std::vector<int> one;
    for (const Vec3& p : shape_.points)
      one.push_back(place.emplace(std::make_tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0), size_of(place)).first->second);
    std::map<std::pair<int, int>, std::vector<int>> walks;
    for (int f = 0; f < size_of(shape_.faces); ++f) {
      const auto& corners = shape_.faces[f];
      for (int i = 0; i < size_of(corners); ++i) {
        const int from = one[corners[i]], to = one[corners[(i + 1) % size_of(corners)]];
        if (from == to) throw Fault{"has a " + face_text(f) + " with the same point twice in a row, at " + point_text(at(f, i))};
        walks[{from, to}].push_back(f);
      }
    }
    for (int f = 0; f < size_of(shape_.faces); ++f) {
      const auto& corners = shape_.faces[f];
      for (int i = 0; i < size_of(corners); ++i) {
        const int from = one[corners[i]], to = one[corners[(i + 1) % size_of(corners)]];
        const auto back = walks.find({to, from});
        check_edge(walks[{from, to}], back == walks.end() ? std::vector<int>{} : back->second, f, i);
      }
    }
  }

  void check_edge(const std::vector<int>& there, const std::vector<int>& back, int f, int i) const {
    const std::string edge = "the edge from " + point_text(at(f, i)) + " to " + point_text(at(f, i + 1));
    if (there.size() == 1 && back.size() == 1) return;
    if (there.size() == 2 && back.empty())
      throw Fault{"has a face turned inside out: " + face_text(there[0]) + " and " + face_text(there[1]) +
                  " run along " + edge + " in the same direction"};
    if (there.size() + back.size() == 1) throw Fault{"is open: " + edge + " of " + face_text(f) + " has no other face"};
    throw Fault{"is not a surface: " + std::to_string(there.size() + back.size()) + " faces share " + edge};
  }

  // The contour in the two axes that the normal leans away from.
  static std::vector<std::array<double, 2>> laid_out(const std::vector<Vec3>& contour, int up) {
    std::vector<std::array<double, 2>> flat;
    for (const Vec3& p : contour) {
      const std::array<double, 3> c{p.x, p.y, p.z};
      flat.push_back({c[(up + 1) % 3], c[(up + 2) % 3]});
    }
    return flat;
  }

  std::vector<Vec3> contour(int face) const {
    std::vector<Vec3> points;
    for (int corner : shape_.faces[face]) points.push_back(shape_.points[corner]);
    return points;
  }

  static int upright_axis(const ExactPlane& plane) {
    int up = 0;
    for (int k = 1; k < 3; ++k)
      if (abs(plane.v[k]) > abs(plane.v[up])) up = k;
    return up;
  }

  void find_planes() {
    for (int f = 0; f < size_of(shape_.faces); ++f) {
      std::optional<ExactPlane> plane = plane_of(contour(f));
      if (!plane) throw Fault{"has a " + face_text(f) + " without area"};
      const int up = upright_axis(*plane);
      const Integer area = signed_area(laid_out(contour(f), up));
      if (area == 0) throw Fault{"has a " + face_text(f) + " without area"};
      if ((plane->v[up] > 0) != (area > 0)) plane = plane->opposite();
      for (int corner : shape_.faces[f]) {
        const double off = side(*plane, points_[corner]) == 0 ? 0 : std::abs(distance(*plane, points_[corner]));
        if (off > flat_within * size_)
          throw Fault{"has a " + face_text(f) + " that is not flat: its point " + point_text(shape_.points[corner]) +
                      " lies " + text_of(off) + " off its plane"};
      }
      planes_.push_back(std::move(*plane));
    }
  }

  void check_volume_sign() {
    for (int f = 0; f < size_of(shape_.faces); ++f)
      for (int i = 1; i + 1 < size_of(shape_.faces[f]); ++i)
        volume_ += six_volumes(shape_.points[0], at(f, 0), at(f, i), at(f, i + 1)) / 6;
    if (!(volume_ > 0))
      throw Fault{"is turned inside out: the points of its faces run clockwise, seen from outside"};
  }

  bool is_convex() const {
    for (const ExactPlane& plane : planes_)
      for (const ExactPoint& point : points_)
        if (side(plane, point) > 0 && distance(plane, point) > flat_within * size_) return false;
    return true;
  }

  void one_piece() {
    Leaf::Piece piece{planes_, {}};
    for (int f = 0; f < size_of(planes_); ++f) piece.tags.push_back(f);
    const Enclosure found = enclose(piece.planes);
    if (found.state != Enclosure::State::solid) throw Fault{"encloses nothing"};
    built_volume_ = volume_of(found.body);
    leaf_.pieces.push_back(std::move(piece));
  }

  // ---- not convex ----
  // The convex parts of one face, counter-clockwise from outside.
  std::vector<Fragment> fragments_of(int face) const {
    for (int corner : shape_.faces[face])
      if (side(planes_[face], points_[corner]) != 0)
        throw Fault{"is not convex, and its " + face_text(face) +
                    " is flat only up to rounding; give it as triangles, or turn the solid by transforms, which are exact"};
    const int up = upright_axis(planes_[face]);
    const bool clockwise = planes_[face].v[up] < 0;
    const ExactPlane upward = clockwise ? planes_[face].opposite() : planes_[face];
    std::vector<Fragment> fragments;
    for (const PlanarPiece& piece : convex_pieces({laid_out(contour(face), up)})) {
      Polygon polygon = lifted(piece, upward, up);
      polygon.plane = planes_[face];
      if (clockwise) std::reverse(polygon.corners.begin(), polygon.corners.end());
      for (int i = 0; i < size_of(polygon.corners); ++i)
        polygon.edges.push_back(edge_plane(polygon.plane, polygon.corners[i],
                                           polygon.corners[(i + 1) % size_of(polygon.corners)]));
      fragments.push_back({std::move(polygon), face});
    }
    return fragments;
  }

  void many_pieces() {
    std::vector<Fragment> all;
    for (int f = 0; f < size_of(shape_.faces); ++f)
      for (Fragment& fragment : fragments_of(f)) all.push_back(std::move(fragment));
    const Polyhedron far = far_cube(planes_);
    split(all, all, far);
  }

  // -1: behind the plane, +1: before it, 0: in it, 2: on both sides.
  static int place_of(const Polygon& polygon, const ExactPlane& plane) {
    bool behind = false, before = false;
    for (const ExactPoint& corner : polygon.corners) {
      const int s = side(plane, corner);
      behind |= s < 0;
      before |= s > 0;
    }
    return behind && before ? 2 : before - behind;
  }

  // The plane that cuts the fewest of the other fragments; of those the one that halves them best.
  static const ExactPlane& best_plane(const std::vector<Fragment>& fragments) {
    const std::size_t step = 1 + fragments.size() / 24;
    std::size_t best = 0;
    long least = -1;
    for (std::size_t i = 0; i < fragments.size(); i += step) {
      long cut = 0, balance = 0;
      for (const Fragment& other : fragments) {
        const int place = place_of(other.polygon, fragments[i].polygon.plane);
        if (place == 2) ++cut;
        else balance += place;
      }
      const long score = 8 * cut + std::abs(balance);
      if (least >= 0 && score >= least) continue;
      least = score;
      best = i;
    }
    return fragments[best].polygon.plane;
  }

  void split(const std::vector<Fragment>& fragments, const std::vector<Fragment>& all, const Polyhedron& far) {
    const ExactPlane plane = best_plane(fragments);
    std::vector<Fragment> behind, before;
    for (const Fragment& fragment : fragments) {
      const int place = place_of(fragment.polygon, plane);
      if (place == -1) behind.push_back(fragment);
      if (place == 1) before.push_back(fragment);
      if (place != 2) continue;
      for (auto* half : {&behind, &before}) {
        Fragment part = fragment;
        if (clip(part.polygon, half == &behind ? plane : plane.opposite())) half->push_back(std::move(part));
      }
    }
    path_.push_back(plane);
    if (behind.empty()) add_piece(all, far);
    else split(behind, all, far);
    path_.back() = plane.opposite();
    if (!before.empty()) split(before, all, far);
    path_.pop_back();
  }

  // The planes on the way to a piece that bound it; those that a face lies in carry that face.
  void add_piece(const std::vector<Fragment>& all, const Polyhedron& far) {
    if (leaf_.pieces.size() >= most_cells)
      throw Fault{"comes apart into more than " + std::to_string(most_cells) + " convex cells"};
    Polyhedron body = far;
    for (int i = 0; i < size_of(path_); ++i)
      if (body.cut(path_[i], i) == Cut::empties) return;
    if (is_open(body)) throw Fault{"intersects itself: what lies behind its faces has no end"};
    body.link();
    built_volume_ += volume_of(body);
    Leaf::Piece piece;
    for (int i = 0; i < size_of(body.faces); ++i) {
      const Polygon polygon = body.polygon(i);
      int tag = seam_tag;
      for (const Fragment& fragment : all)
        if (same(fragment.polygon.plane, polygon.plane) && share_area(fragment.polygon, polygon)) tag = fragment.face;
      piece.planes.push_back(polygon.plane);
      piece.tags.push_back(tag);
    }
    leaf_.pieces.push_back(std::move(piece));
  }

  void check_volume() const {
    if (std::abs(built_volume_ - volume_) <= same_volume_within * volume_) return;
    throw Fault{"intersects itself: its faces go around a volume of " + text_of(volume_) + ", its solid has " +
                text_of(built_volume_)};
  }
};

}  // namespace

Leaf leaf_of(const MeshShape& shape) {
  try {
    return MeshSolid(shape).leaf();
  } catch (const Fault& fault) {
    Leaf leaf;
    leaf.wrong = fault.what;
    return leaf;
  }
}

}  // namespace nicol::solids
