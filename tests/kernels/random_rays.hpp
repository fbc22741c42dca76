// Rays at random for scenes whose camera stands at the origin.
#pragma once
#include <cmath>
#include <vector>

#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

namespace nicol::test {

// Rays from a sphere around the origin to somewhere in a ball, with any axis.
inline std::vector<RayCase> random_rays(int count, double ball_mm, unsigned seed) {
  Dice dice{seed};
  std::vector<RayCase> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 from = scaled(10 * ball_mm, any_direction(seed + 2 * i + 1));
    const Vec3 at = scaled(ball_mm * dice(), any_direction(seed + 2 * i + 2000003));
    const Vec3 d = unit(plus(at, scaled(-1, from)));
    Vec3 axis = any_direction(seed + i + 5000011);
    if (std::fabs(dot(axis, d)) > 0.99) axis = {d.y, d.z, d.x};
    rays.push_back({from, d, axis});
  }
  return rays;
}

}  // namespace nicol::test
