// Half-space solids: see leaves.hpp.
#include "leaves.hpp"

#include <algorithm>
#include <cmath>

#include "planar.hpp"
#include "polyhedron.hpp"

namespace nicol::solids {
namespace {

bool finite(double v) { return std::isfinite(v); }
bool finite(const Vec3& p) { return finite(p.x) && finite(p.y) && finite(p.z); }

bool finite(const PrismShape& shape) {
  for (const auto& contour : shape.contours) {
    for (const auto& p : contour) {
      if (!finite(p[0]) || !finite(p[1])) return false;
    }
  }
  return finite(shape.y_min) && finite(shape.y_max);
}

Leaf unsound(std::string what) {
  Leaf leaf;
  leaf.wrong = std::move(what);
  return leaf;
}

}  // namespace

std::string wrong_with(const std::vector<Affine>& transforms) {
  for (const Affine& affine : transforms) {
    for (const auto& row : affine.m) {
      if (!std::all_of(row.begin(), row.end(), [](double v) { return finite(v); }))
        return "has a transform that is not finite";
    }
  }
  if (ExactAffine(transforms).singular())
    return "is flattened by its transforms (a scale of 0?)";
  return "";
}

Leaf leaf_of(const ConvexShape& shape) {
  Leaf leaf;
  Leaf::Piece piece;
  for (const HalfSpace& face : shape.faces) {
    const bool no_direction = face.normal.x == 0 && face.normal.y == 0 && face.normal.z == 0;
    if (!finite(face.normal) || !finite(face.offset) || no_direction) {
      return unsound("has a face " + std::to_string(leaf.face_count) +
                     " without direction or place");
    }
    piece.planes.emplace_back(face);
    piece.tags.push_back(leaf.face_count++);
  }
  leaf.pieces.push_back(std::move(piece));
  return leaf;
}

Leaf leaf_of(const PrismShape& shape) {
  if (!finite(shape)) return unsound("has a number that is not finite");
  const double y_min = std::min(shape.y_min, shape.y_max),
               y_max = std::max(shape.y_min, shape.y_max);
  if (y_min == y_max) return unsound("has no height");
  Leaf leaf;
  leaf.face_count = 2;
  for (const auto& contour : shape.contours) leaf.face_count += size_of(contour);
  for (const PlanarPiece& planar : convex_pieces(shape.contours)) {
    Leaf::Piece piece;
    piece.planes = {ExactPlane(HalfSpace{{0, -1, 0}, -y_min}),
                    ExactPlane(HalfSpace{{0, 1, 0}, y_max})};
    piece.tags = {0, 1};
    for (int i = 0; i < size_of(planar.corners); ++i) {
      // The line through two points of the plane is their cross product, negative on the right.
      const Integer3 line =
          cross(planar.corners[i], planar.corners[(i + 1) % size_of(planar.corners)]);
      piece.planes.emplace_back(Integer4{-line[0], 0, -line[1], -line[2]});
      piece.tags.push_back(planar.edges[i] < 0 ? seam_tag : planar.edges[i] + 2);
    }
    leaf.pieces.push_back(std::move(piece));
  }
  if (leaf.pieces.empty()) return unsound("has an outline that encloses no area");
  return leaf;
}

}  // namespace nicol::solids
