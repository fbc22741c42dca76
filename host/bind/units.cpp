// Conversion of units and handedness: see units.hpp.
#include "host/bind/units.hpp"

#include <cmath>

namespace nicol {

namespace {
constexpr double pi = 3.14159265358979323846;
constexpr double mm_per_nm = 1e-6;
}  // namespace

Affine to_world(double mm_per_unit) {
  Affine a;
  a.m[0][0] = a.m[1][1] = mm_per_unit;
  a.m[2][2] = -mm_per_unit;
  return a;
}

Affine from_crystal() {
  Affine a;
  a.m = {{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  return a;
}

double radians(double angle_deg) { return angle_deg * (pi / 180); }

double sin_deg(double angle_deg) {
  double a = std::fmod(angle_deg, 360);  // exact
  if (a < 0) a += 360;
  if (a == 0 || a == 180) return 0;
  if (a == 90) return 1;
  if (a == 270) return -1;
  if (a == 30 || a == 150) return 0.5;
  if (a == 210 || a == 330) return -0.5;
  return std::sin(radians(a));
}

double cos_deg(double angle_deg) { return sin_deg(std::fmod(angle_deg, 360) + 90); }

double extinction(double absorb_per_mm, double lambda_nm) {
  return absorb_per_mm * lambda_nm * mm_per_nm / (4 * pi);
}

}  // namespace nicol
