// Planes and outlines of sheets: see flat.hpp.
#include "flat.hpp"

#include <cmath>

namespace nicol::solids {

// Through a point, the point farthest from it, and the one farthest from their line.
std::optional<ExactPlane> plane_of(const std::vector<Vec3>& contour) {
  const auto minus = [](const Vec3& a, const Vec3& b) {
    return Vec3{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const auto across = [](const Vec3& a, const Vec3& b) {
    return std::hypot(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  };
  if (contour.size() < 3) return std::nullopt;
  std::size_t far = 0, off = 0;
  double length = 0, width = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec3 d = minus(contour[i], contour[0]);
    const double size = std::hypot(d.x, d.y, d.z);
    if (size > length) length = size, far = i;
  }
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const double size = across(minus(contour[far], contour[0]), minus(contour[i], contour[0]));
    if (size > width) width = size, off = i;
  }
  if (width == 0) return std::nullopt;
  const ExactPlane plane =
      through(ExactPoint(contour[0]), ExactPoint(contour[far]), ExactPoint(contour[off]));
  if (dot(plane.normal(), plane.normal()) == 0) return std::nullopt;
  return plane;
}

Integer signed_area(const std::vector<std::array<double, 2>>& contour) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const auto &p = contour[i], &q = contour[(i + 1) % contour.size()];
    sum += mpq_class(p[0]) * mpq_class(q[1]) - mpq_class(p[1]) * mpq_class(q[0]);
  }
  return sum.get_num();
}

Polygon lifted(const PlanarPiece& piece, const ExactPlane& plane, int up) {
  const int u = (up + 1) % 3, v = (up + 2) % 3;
  Polygon out;
  out.plane = plane;
  for (const Integer3& p : piece.corners) {
    Integer4 lifted;
    lifted[u] = p[0] * plane.v[up];
    lifted[v] = p[1] * plane.v[up];
    lifted[3] = p[2] * plane.v[up];
    lifted[up] = -(p[0] * plane.v[u] + p[1] * plane.v[v] + p[2] * plane.v[3]);
    out.corners.emplace_back(std::move(lifted));
  }
  return out;
}

std::optional<double> scale_in(const ExactPlane& plane, const ExactAffine& affine) {
  // Two directions at right angles in the plane (Duff et al. 2017: a basis without branches).
  const Vec3 n = unit_normal(plane);
  const double s = n.z < 0 ? -1 : 1, a = -1 / (s + n.z), b = n.x * n.y * a;
  const Vec3 e{1 + s * n.x * n.x * a, s * b, -s * n.x};
  const Vec3 f{b, s + n.y * n.y * a, -n.y};
  const auto m = affine.linear();
  std::array<double, 3> e_out{}, f_out{};
  for (int j = 0; j < 3; ++j) {
    e_out[j] = e.x * m[0][j] + e.y * m[1][j] + e.z * m[2][j];
    f_out[j] = f.x * m[0][j] + f.y * m[1][j] + f.z * m[2][j];
  }
  double ee = 0, ff = 0, ef = 0;
  for (int j = 0; j < 3; ++j) {
    ee += e_out[j] * e_out[j];
    ff += f_out[j] * f_out[j];
    ef += e_out[j] * f_out[j];
  }
  if (std::abs(ee - ff) > 2e-12 * ee || std::abs(ef) > 1e-12 * ee) return std::nullopt;
  return std::sqrt((ee + ff) / 2);
}

}  // namespace nicol::solids
