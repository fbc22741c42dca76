// Where a camera shows a point.
#pragma once
#include <array>

#include "host/vec.hpp"

namespace nicol::preview {

// In widths and heights of the picture from its middle, to the right and up; then the depth in lengths of `direction`.
inline std::array<double, 3> place_in_picture(const Camera& camera, Vec3 point_mm) {
  const Vec3 p = point_mm - camera.location;
  const Vec3 &r = camera.right, &u = camera.up, &d = camera.direction;
  const double volume = dot(cross(r, u), d);
  const double right = dot(cross(p, u), d) / volume, up = dot(cross(r, p), d) / volume;
  const double depth = dot(cross(r, u), p) / volume;
  if (camera.orthographic) return {right, up, depth};
  return {right / depth, up / depth, depth};
}

}  // namespace nicol::preview
