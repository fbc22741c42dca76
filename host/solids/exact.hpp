// Exact points, planes and transforms: homogeneous integers, so nothing is ever rounded before
// output. A double is an integer times a power of two; planes, corners and transforms made of
// doubles by products and determinants therefore stay ratios of integers. Signs are first asked of
// a rounded copy with an error bound, and of the integers only when that cannot tell.
#pragma once
#include <gmpxx.h>

#include <array>
#include <vector>

#include "host/scene.hpp"

namespace nicol::solids {

using Integer = mpz_class;
using Integer3 = std::array<Integer, 3>;
using Integer4 = std::array<Integer, 4>;

template <class Container>
int size_of(const Container& container) {
  return static_cast<int>(container.size());
}

// Four integers without a common divisor, and their copy in double, scaled by one power of two.
struct Exact4 {
  Integer4 v{0, 0, 0, 1};
  std::array<double, 4> approx{0, 0, 0, 1};
  Exact4() = default;
  explicit Exact4(Integer4 values);
};

// The point (x, y, z) / w with w > 0.
struct ExactPoint : Exact4 {
  ExactPoint() = default;
  explicit ExactPoint(Integer4 values);
  explicit ExactPoint(const Vec3& p);
};

// a x + b y + c z + d <= 0 is the inside; equal planes have equal integers, opposite ones negated.
struct ExactPlane : Exact4 {
  ExactPlane() = default;
  explicit ExactPlane(Integer4 values) : Exact4(std::move(values)) {}
  explicit ExactPlane(const HalfSpace& half_space);
  Integer3 normal() const { return {v[0], v[1], v[2]}; }
  ExactPlane opposite() const;
};

bool same(const ExactPlane& a, const ExactPlane& b);
bool opposite(const ExactPlane& a, const ExactPlane& b);

// -1: inside, 0: on the plane, +1: outside.
int side(const ExactPlane& plane, const ExactPoint& point);

// The point that three planes share, which must be independent; the plane through three points.
ExactPoint meet(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r);
ExactPlane through(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r);

Integer dot(const Integer3& a, const Integer3& b);
Integer3 cross(const Integer3& a, const Integer3& b);

// The plane across `plane` through u and v (both on it), outward to the right of u -> v seen from
// its outer side: the boundary of a polygon that runs counter-clockwise.
ExactPlane edge_plane(const ExactPlane& plane, const ExactPoint& u, const ExactPoint& v);

// The plane that stands upright on `plane` and cuts it in the same line as `cut`, which holds
// `on_both`.
ExactPlane upright(const ExactPlane& plane, const ExactPlane& cut, const ExactPoint& on_both);

// A list of transforms composed exactly: p' = (p L + t) / w.
class ExactAffine {
 public:
  explicit ExactAffine(const std::vector<Affine>& list);
  bool singular() const { return det_ == 0; }
  bool mirrors() const { return det_ < 0; }
  ExactPoint operator()(const ExactPoint& p) const;
  ExactPlane operator()(const ExactPlane& p) const;  // must not be singular
  std::array<std::array<double, 3>, 3> linear() const;

 private:
  std::array<Integer3, 3> linear_, adjugate_;
  Integer3 shift_;
  Integer w_, det_;
};

// ---- out to double, each correctly rounded ----
double quotient(const Integer& numerator, const Integer& denominator);  // denominator > 0
Vec3 rounded(const ExactPoint& p);
Vec3 rounded_difference(const ExactPoint& p, const ExactPoint& origin);
Vec3 unit_normal(const ExactPlane& plane);
double distance(const ExactPlane& plane, const ExactPoint& point);  // signed, > 0 outside

}  // namespace nicol::solids
