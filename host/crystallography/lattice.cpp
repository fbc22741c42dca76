// Cell to Cartesian axes: see lattice.hpp.
#include "host/crystallography/lattice.hpp"

#include "host/crystallography/degrees.hpp"
#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

Vec3 combine(const std::array<Vec3, 3>& v, double x, double y, double z) {
  return v[0] * x + v[1] * y + v[2] * z;
}

// Rhombohedral axes with Z along a + b + c and X along a - b. With t = cos alpha, an axis makes
// cos^2 = (1 + 2 t) / 3 with Z.
std::array<Vec3, 3> rhombohedral_axes(double alpha_deg) {
  const double cosine = cos_deg(alpha_deg);
  const double up = std::sqrt((1 + 2 * cosine) / 3), out = std::sqrt((1 - cosine) * 2 / 3);
  const double half_root3 = std::sqrt(3.0) / 2;
  return {Vec3{out * half_root3, out * 0.5, up}, Vec3{-out * half_root3, out * 0.5, up},
          Vec3{0, -out, up}};
}

std::array<Vec3, 3> triclinic_axes(const Cell& cell, double volume) {
  const double ca = cos_deg(cell.alpha_deg), cb = cos_deg(cell.beta_deg),
               cg = cos_deg(cell.gamma_deg), sb = sin_deg(cell.beta_deg);
  return {Vec3{cell.a * sb, 0, cell.a * cb},
          Vec3{cell.b * (cg - ca * cb) / sb, cell.b * volume / sb, cell.b * ca},
          Vec3{0, 0, cell.c}};
}

}  // namespace

Vec3 Lattice::normal(Miller face) const { return combine(reciprocal, face.h, face.k, face.l); }

Vec3 Lattice::direction(Vec3 uvw) const { return combine(axes, uvw.x, uvw.y, uvw.z); }

std::optional<Lattice> make_lattice(const Cell& cell, bool rhombohedral, std::string& why) {
  const double angles[] = {cell.alpha_deg, cell.beta_deg, cell.gamma_deg};
  for (double length_unit : {cell.a, cell.b, cell.c}) {
    if (length_unit > 0 && length_unit < 1e100) continue;
    why = "the edges of a cell are positive lengths";
    return std::nullopt;
  }
  for (double angle_deg : angles) {
    if (angle_deg > 0 && angle_deg < 180) continue;
    why = "the angles of a cell lie between 0 and 180 degrees";
    return std::nullopt;
  }
  const double ca = cos_deg(angles[0]), cb = cos_deg(angles[1]), cg = cos_deg(angles[2]);
  const double square = 1 - ca * ca - cb * cb - cg * cg + 2 * ca * cb * cg;
  if (!(square > 1e-9)) {
    why = "no cell has these angles: its edges would lie in one plane";
    return std::nullopt;
  }
  if (rhombohedral && (cell.a != cell.b || cell.b != cell.c || angles[0] != angles[1] ||
                       angles[1] != angles[2])) {
    why = "a rhombohedral cell has a = b = c and alpha = beta = gamma";
    return std::nullopt;
  }
  Lattice lattice;
  lattice.axes =
      rhombohedral ? rhombohedral_axes(cell.alpha_deg) : triclinic_axes(cell, std::sqrt(square));
  const auto& [a, b, c] = lattice.axes;
  const double per_volume = 1 / dot(a, cross(b, c));
  lattice.reciprocal = {cross(b, c) * per_volume, cross(c, a) * per_volume,
                        cross(a, b) * per_volume};
  return lattice;
}

bool fits(const Lattice& lattice, const PointGroup& group) {
  for (const Operation& r : group.operations) {
    std::array<Vec3, 3> image;  // of each axis: a column of r
    for (int i = 0; i < 3; ++i) image[i] = combine(lattice.axes, r[0][i], r[1][i], r[2][i]);
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) {
        const double before = dot(lattice.axes[i], lattice.axes[j]);
        const double scale = length(lattice.axes[i]) * length(lattice.axes[j]);
        if (std::abs(dot(image[i], image[j]) - before) > 1e-6 * scale) return false;
      }
    }
  }
  return true;
}

const char* cell_rule(System system, bool rhombohedral) {
  if (rhombohedral) return "a = b = c, alpha = beta = gamma";
  switch (system) {
    case System::triclinic:
      return "any cell";
    case System::monoclinic:
      return "two angles of 90 (unique axis b: alpha = gamma = 90)";
    case System::orthorhombic:
      return "alpha = beta = gamma = 90";
    case System::tetragonal:
      return "a = b, alpha = beta = gamma = 90";
    case System::cubic:
      return "a = b = c, alpha = beta = gamma = 90";
    default:
      return "a = b, alpha = beta = 90, gamma = 120";
  }
}

}  // namespace nicol::crystallography
