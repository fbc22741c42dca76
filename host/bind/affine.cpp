// Lists of affine steps: see affine.hpp.
#include "host/bind/affine.hpp"

#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// det(A) A^-1 transposed: what a normal turns by, without a division.
std::array<Vec3, 3> cofactors(const Affine& a) {
  const Vec3 r0{a.m[0][0], a.m[0][1], a.m[0][2]};
  const Vec3 r1{a.m[1][0], a.m[1][1], a.m[1][2]};
  const Vec3 r2{a.m[2][0], a.m[2][1], a.m[2][2]};
  return {cross(r1, r2), cross(r2, r0), cross(r0, r1)};
}

Vec3 translation_of(const Affine& a) { return {a.m[3][0], a.m[3][1], a.m[3][2]}; }

// n' with n'.(d A) = |det| n.d for every d.
Vec3 scaled_normal(const Affine& a, Vec3 n, double& det) {
  const auto c = cofactors(a);
  det = determinant(a);
  const Vec3 turned = c[0] * n.x + c[1] * n.y + c[2] * n.z;
  if (det >= 0) return turned;
  det = -det;
  return -turned;
}

Affine elementary_rotation(int axis, double angle_deg) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double c = cos_deg(angle_deg), s = sin_deg(angle_deg);
  Affine a;
  a.m[i][i] = a.m[j][j] = c;
  a.m[i][j] = s;
  a.m[j][i] = -s;
  return a;
}

}  // namespace

Affine translation(Vec3 by) {
  Affine a;
  a.m[3] = {by.x, by.y, by.z};
  return a;
}

Affine scaling(Vec3 by) {
  Affine a;
  a.m[0][0] = by.x;
  a.m[1][1] = by.y;
  a.m[2][2] = by.z;
  return a;
}

void append_rotation(Affines& list, Vec3 angle_deg) {
  if (angle_deg.x != 0) list.push_back(elementary_rotation(0, angle_deg.x));
  if (angle_deg.y != 0) list.push_back(elementary_rotation(1, angle_deg.y));
  if (angle_deg.z != 0) list.push_back(elementary_rotation(2, angle_deg.z));
}

double determinant(const Affine& a) {
  const auto c = cofactors(a);
  return dot({a.m[0][0], a.m[0][1], a.m[0][2]}, c[0]);
}

double determinant_sign(const Affines& list) {
  double sign = 1;
  for (const Affine& a : list) {
    const double det = determinant(a);
    sign *= det > 0 ? 1 : det < 0 ? -1 : 0;
  }
  return sign;
}

Affine inverse(const Affine& a) {
  const auto c = cofactors(a);
  const double det = determinant(a);
  const std::array<std::array<double, 3>, 3> rows{
      {{c[0].x, c[1].x, c[2].x}, {c[0].y, c[1].y, c[2].y}, {c[0].z, c[1].z, c[2].z}}};
  Affine inv;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inv.m[i][j] = rows[i][j] / det;
  const Vec3 back = transform_direction(inv, translation_of(a));
  inv.m[3] = {-back.x, -back.y, -back.z};
  return inv;
}

Affines inverse(const Affines& list) {
  Affines inv;
  for (auto step = list.rbegin(); step != list.rend(); ++step) inv.push_back(inverse(*step));
  return inv;
}

Vec3 transform_direction(const Affine& a, Vec3 d) {
  return {d.x * a.m[0][0] + d.y * a.m[1][0] + d.z * a.m[2][0],
          d.x * a.m[0][1] + d.y * a.m[1][1] + d.z * a.m[2][1],
          d.x * a.m[0][2] + d.y * a.m[1][2] + d.z * a.m[2][2]};
}

Vec3 transform_point(const Affine& a, Vec3 p) {
  return transform_direction(a, p) + translation_of(a);
}

Vec3 transform_point(const Affines& list, Vec3 p) {
  for (const Affine& a : list) p = transform_point(a, p);
  return p;
}

Vec3 transform_direction(const Affines& list, Vec3 d) {
  for (const Affine& a : list) d = transform_direction(a, d);
  return d;
}

Vec3 transform_normal(const Affines& list, Vec3 n) {
  double det = 1;
  for (const Affine& a : list) n = scaled_normal(a, n, det);
  return n;
}

HalfSpace transform(const Affines& list, const HalfSpace& half_space) {
  HalfSpace h = half_space;
  for (const Affine& a : list) {
    double det = 1;
    h.normal = scaled_normal(a, h.normal, det);
    h.offset = h.offset * det + dot(h.normal, translation_of(a));
  }
  return h;
}

}  // namespace nicol
