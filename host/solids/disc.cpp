// Discs: see disc.hpp.
#include "disc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nicol::solids {
namespace {

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 along(const Vec3& p, const Vec3& direction, double t) {
  return {p.x + t * direction.x, p.y + t * direction.y, p.z + t * direction.z};
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

// Over the disc, n . p runs through n . c +- r sqrt(|n|^2 - (n . m)^2 / |m|^2), m its normal.
DiscSide disc_side(const ExactPlane& plane, const SheetPart& disc) {
  Integer height = 0;
  for (int i = 0; i < 4; ++i) height += plane.v[i] * disc.centre.v[i];
  const Integer3 n = plane.normal(), m = disc.polygon.plane.normal();
  const Integer m_m = solids::dot(m, m), n_m = solids::dot(n, m);
  const Integer lean = solids::dot(n, n) * m_m - n_m * n_m;
  const mpq_class radius(disc.radius_mm);
  mpq_class offset(height, disc.centre.v[3]);
  offset.canonicalize();
  if (lean == 0 && height == 0) return DiscSide::on;
  if (offset * offset * m_m < radius * radius * lean) return DiscSide::both;
  return height < 0 ? DiscSide::inside : DiscSide::outside;
}

bool disc_covers_some(const SheetPart& disc, const ExactPlane& plane,
                      const std::vector<ExactPoint>& corners) {
  const Vec3 normal = unit_normal(plane);
  std::vector<Vec3> p;
  for (const ExactPoint& corner : corners) p.push_back(rounded_difference(corner, disc.centre));
  bool centre_inside = true;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3& q = p[(i + 1) % p.size()];
    const Vec3 edge = along(q, p[i], -1);
    const double t = std::clamp(-dot(p[i], edge) / dot(edge, edge), 0.0, 1.0);
    const Vec3 foot = along(p[i], edge, t);
    nearest = std::min(nearest, std::sqrt(dot(foot, foot)));
    farthest = std::max(farthest, std::sqrt(dot(p[i], p[i])));
    centre_inside &= dot(cross(edge, normal), p[i]) >= 0;
  }
  if (farthest <= disc.hole_radius_mm) return false;
  return centre_inside || nearest < disc.radius_mm;
}

bool discs_overlap(const SheetPart& a, const SheetPart& b) {
  const Vec3 d = rounded_difference(a.centre, b.centre);
  const double apart = std::sqrt(dot(d, d));
  if (apart >= a.radius_mm + b.radius_mm) return false;
  return apart + a.radius_mm > b.hole_radius_mm && apart + b.radius_mm > a.hole_radius_mm;
}

}  // namespace nicol::solids
