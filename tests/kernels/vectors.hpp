// Small vector arithmetic of the tests.
#pragma once
#include <cmath>

#include "host/scene.hpp"

namespace nicol::test {

constexpr double pi = 3.14159265358979323846;
inline double radians(double degrees) { return degrees * pi / 180; }

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3 scaled(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 unit(const Vec3& a) { return scaled(1 / std::sqrt(dot(a, a)), a); }

// Numbers 0..1 in a fixed order for a seed.
struct Dice {
  unsigned long long state;
  double operator()() {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) * 0x1p-53;
  }
};

inline Vec3 any_direction(unsigned seed) {
  Dice dice{seed * 2654435761ull + 12345};
  dice();
  const double z = 2 * dice() - 1, azimuth = 2 * pi * dice(), r = std::sqrt(1 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

}  // namespace nicol::test
