// How a crystal lies in the world: the rotation in a list of transforms.
// The polar decomposition M = U P of a linear map into a rotation and a stretch: U is the limit of
// U -> (U + U^-T)/2 (Higham, SIAM J. Sci. Stat. Comput. 7, 1160 (1986), eq. 3.1). Row vectors: v' = v M.
#include <algorithm>

#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

constexpr int most_iterations = 3000;  // halves a condition of 1e308 down to 1

double largest(const OpticFrame& rows) {
  double most = 0;
  for (const Vec3& r : rows) most = std::max({most, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
  return most;
}

// Transposed inverse: the cofactors over the determinant.
OpticFrame dual(const OpticFrame& m) {
  const OpticFrame c{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const double det = dot(m[0], c[0]);
  return {c[0] * (1 / det), c[1] * (1 / det), c[2] * (1 / det)};
}

// The proper rotation nearest to m, or to -m if m mirrors.
OpticFrame rotation_in(OpticFrame m) {
  if (dot(m[0], cross(m[1], m[2])) < 0) m = {-m[0], -m[1], -m[2]};
  for (int i = 0; i < most_iterations; ++i) {
    const OpticFrame other = dual(m);
    double change = 0;
    for (int row = 0; row < 3; ++row) {
      const Vec3 mean = (m[row] + other[row]) * 0.5;
      change = std::max(change, length(mean - m[row]));
      m[row] = mean;
    }
    if (!(change > 1e-15)) break;
  }
  return m;
}

OpticFrame linear_part(const Affines& transforms) {
  OpticFrame rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const Affine& step : transforms) {
    for (Vec3& row : rows) row = transform_direction(step, row);
    const double size = largest(rows);
    for (Vec3& row : rows) row = row * (1 / size);
  }
  return rows;
}

}  // namespace

Vec3 turned(const OpticFrame& axes, Vec3 v) { return axes[0] * v.x + axes[1] * v.y + axes[2] * v.z; }

OpticFrame turned(const OpticFrame& axes, const OpticFrame& frame) {
  return {turned(axes, frame[0]), turned(axes, frame[1]), turned(axes, frame[2])};
}

// Duff et al., JCGT 6(1), 1 (2017).
OpticFrame frame_of_axis(Vec3 n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {Vec3{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, Vec3{b, sign + n.y * n.y * a, -n.y}, n};
}

Orientation orientation_of(const Affines& transforms, const CrystalFrame& frame) {
  Orientation o;
  o.opposite_hand = frame.opposite_hand;
  o.object = rotation_in(linear_part(transforms));
  for (Vec3& axis : o.object) axis = transform_direction(to_world(1), axis);
  const OpticFrame twin = rotation_in(linear_part({frame.extra}));
  for (int i = 0; i < 3; ++i)
    o.crystal[i] = turned(o.object, transform_direction(from_crystal(), twin[i]));
  return o;
}

}  // namespace nicol
