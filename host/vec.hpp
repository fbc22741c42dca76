// Small algebra of Vec3, in double.
#pragma once
#include <cmath>

#include "host/scene.hpp"

namespace nicol {

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }

// Zero stays zero.
inline Vec3 normalize(Vec3 a) {
  const double len = length(a);
  return len > 0 ? a * (1 / len) : a;
}

// The part of `a` that lies in the plane across the unit vector `n`.
inline Vec3 project(Vec3 a, Vec3 n) { return a - n * dot(a, n); }

}  // namespace nicol
