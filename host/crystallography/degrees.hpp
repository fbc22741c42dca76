// Sine and cosine of degrees, exact where the true value is 0, +-1/2 or +-1.
#pragma once
#include <cmath>

namespace nicol::crystallography {

constexpr double degree = 3.14159265358979323846 / 180;

inline double sin_deg(double angle_deg) {
  double a = std::fmod(angle_deg, 360);
  if (a < 0) a += 360;
  if (a > 180) return -sin_deg(a - 180);
  if (a > 90) a = 180 - a;
  return a == 0 ? 0 : a == 30 ? 0.5 : a == 90 ? 1 : std::sin(a * degree);
}

inline double cos_deg(double angle_deg) { return sin_deg(angle_deg + 90); }

}  // namespace nicol::crystallography
