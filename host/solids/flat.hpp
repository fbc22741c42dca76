// Planes and outlines of sheets.
#pragma once
#include <optional>
#include <vector>

#include "planar.hpp"
#include "polyhedron.hpp"

namespace nicol::solids {

// The exact plane of a contour, through three points far from each other; none if they lie on one line.
std::optional<ExactPlane> plane_of(const std::vector<Vec3>& contour);

// Its sign says which way round the contour runs.
Integer signed_area(const std::vector<std::array<double, 2>>& contour);

// A piece laid out in the axes up + 1 and up + 2, put back on its plane (whose component `up` is > 0).
Polygon lifted(const PlanarPiece& piece, const ExactPlane& plane, int up);

// The factor on lengths in a plane, if the transform has the same in every direction to 1e-12.
std::optional<double> scale_in(const ExactPlane& plane, const ExactAffine& affine);

}  // namespace nicol::solids
