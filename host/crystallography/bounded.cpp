// An open cone { d : n . d <= 0 for all normals n } has, if it is more than 0, an edge along a cross
// product of two normals, or holds a whole line across all of them.
#include "host/crystallography/bounded.hpp"

#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

constexpr double tolerance = 1e-12;  // of a sine: rounding of unit normals

bool is_open(const std::vector<Vec3>& normals, Vec3 d) {
  for (const Vec3& n : normals)
    if (dot(n, d) > tolerance) return false;
  return true;
}

Vec3 across(Vec3 n) {
  const Vec3 other = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalize(cross(n, other));
}

}  // namespace

std::optional<Vec3> open_direction(const std::vector<HalfSpace>& faces) {
  std::vector<Vec3> normals;
  for (const HalfSpace& face : faces) normals.push_back(normalize(face.normal));
  bool independent = false;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 edge = cross(normals[i], normals[j]);
      if (length(edge) < tolerance) continue;
      independent = true;
      const Vec3 d = normalize(edge);
      if (is_open(normals, d)) return d;
      if (is_open(normals, -d)) return -d;
    }
  }
  if (independent) return std::nullopt;
  return normals.empty() ? Vec3{0, 0, 1} : across(normals[0]);
}

}  // namespace nicol::crystallography
