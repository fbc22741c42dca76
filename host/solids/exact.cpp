// Homogeneous integers: see exact.hpp.
#include "exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nicol::solids {
namespace {

long bits(const Integer& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

template <std::size_t n>
void divide_by_content(std::array<Integer, n>& values) {
  Integer content = 0;
  for (const Integer& value : values) {
    content = gcd(content, value);
    if (content == 1) return;
  }
  if (content == 0) return;
  for (Integer& value : values)
    mpz_divexact(value.get_mpz_t(), value.get_mpz_t(), content.get_mpz_t());
}

// The doubles as integers times one shared power of two, which is left out.
template <std::size_t n>
std::array<Integer, n> integers(const std::array<double, n>& values) {
  std::array<Integer, n> mantissas;
  std::array<int, n> exponents{};
  int lowest = 0;
  bool any = false;
  for (std::size_t i = 0; i < n; ++i) {
    if (values[i] == 0) continue;
    mantissas[i] = std::ldexp(std::frexp(values[i], &exponents[i]), 53);
    lowest = any ? std::min(lowest, exponents[i]) : exponents[i];
    any = true;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (mantissas[i] != 0) mantissas[i] <<= static_cast<unsigned>(exponents[i] - lowest);
  }
  return mantissas;
}

Integer minor3(const Integer4& a, const Integer4& b, const Integer4& c, int i, int j, int k) {
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
         a[k] * (b[i] * c[j] - b[j] * c[i]);
}

// The 4-vector orthogonal to three others (their generalized cross product).
Integer4 orthogonal(const Integer4& a, const Integer4& b, const Integer4& c) {
  return {minor3(a, b, c, 1, 2, 3), -minor3(a, b, c, 0, 2, 3), minor3(a, b, c, 0, 1, 3),
          -minor3(a, b, c, 0, 1, 2)};
}

// |normal| as root / 2^shift with more than 128 correct bits, exact for perfect squares.
struct Length {
  Integer root;
  unsigned shift;
};
Length length(const Integer3& normal) {
  const Integer square = dot(normal, normal);
  const long missing = 280 - bits(square);
  const unsigned shift = missing > 0 ? static_cast<unsigned>((missing + 1) / 2) : 0;
  return {sqrt(Integer(square << (2 * shift))), shift};
}

}  // namespace

Exact4::Exact4(Integer4 values) : v(std::move(values)) {
  divide_by_content(v);
  std::array<long, 4> exponents{};
  long highest = 0;
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    approx[i] = mpz_get_d_2exp(&exponents[i], v[i].get_mpz_t());
    if (v[i] == 0) continue;
    highest = any ? std::max(highest, exponents[i]) : exponents[i];
    any = true;
  }
  for (int i = 0; i < 4; ++i) {
    const long below = std::max(exponents[i] - highest, -2000L);
    approx[i] = std::ldexp(approx[i], static_cast<int>(below));
  }
}

ExactPoint::ExactPoint(Integer4 values) : Exact4(std::move(values)) {
  if (v[3] > 0) return;
  for (int i = 0; i < 4; ++i) {
    v[i] = -v[i];
    approx[i] = -approx[i];
  }
}

ExactPoint::ExactPoint(const Vec3& p) : ExactPoint(integers<4>({p.x, p.y, p.z, 1.0})) {}

ExactPlane::ExactPlane(const HalfSpace& h)
    : Exact4(integers<4>({h.normal.x, h.normal.y, h.normal.z, -h.offset})) {}

ExactPlane ExactPlane::opposite() const {
  ExactPlane result = *this;
  for (int i = 0; i < 4; ++i) {
    result.v[i] = -v[i];
    result.approx[i] = -approx[i];
  }
  return result;
}

bool same(const ExactPlane& a, const ExactPlane& b) { return a.approx == b.approx && a.v == b.v; }

bool opposite(const ExactPlane& a, const ExactPlane& b) {
  for (int i = 0; i < 4; ++i) {
    if (a.approx[i] != -b.approx[i]) return false;
  }
  for (int i = 0; i < 4; ++i) {
    if (a.v[i] != -b.v[i]) return false;
  }
  return true;
}

int side(const ExactPlane& plane, const ExactPoint& point) {
  // Rounded copies are off by 2^-52 each; four products and three sums add less than 5 x 2^-53
  // each. 1e-300 covers components that underflow.
  double sum = 0, magnitude = 0;
  for (int i = 0; i < 4; ++i) {
    const double term = plane.approx[i] * point.approx[i];
    sum += term;
    magnitude += std::abs(term);
  }
  const double bound = 2e-15 * magnitude + 1e-300;
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  const Integer exact = plane.v[0] * point.v[0] + plane.v[1] * point.v[1] +
                        plane.v[2] * point.v[2] + plane.v[3] * point.v[3];
  return sgn(exact);
}

ExactPoint meet(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r) {
  return ExactPoint(orthogonal(p.v, q.v, r.v));
}

ExactPlane through(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
  return ExactPlane(orthogonal(p.v, q.v, r.v));
}

Integer dot(const Integer3& a, const Integer3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Integer3 cross(const Integer3& a, const Integer3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

namespace {
ExactPlane plane_at(const Integer3& normal, const ExactPoint& p) {
  const Integer& w = p.v[3];
  return ExactPlane(Integer4{normal[0] * w, normal[1] * w, normal[2] * w,
                             -dot(normal, {p.v[0], p.v[1], p.v[2]})});
}
}  // namespace

ExactPlane edge_plane(const ExactPlane& plane, const ExactPoint& u, const ExactPoint& v) {
  Integer3 along;
  for (int i = 0; i < 3; ++i) along[i] = v.v[i] * u.v[3] - u.v[i] * v.v[3];
  divide_by_content(along);
  return plane_at(cross(along, plane.normal()), u);
}

ExactPlane upright(const ExactPlane& plane, const ExactPlane& cut, const ExactPoint& on_both) {
  const Integer3 n = plane.normal(), q = cut.normal();
  const Integer n_n = dot(n, n), q_n = dot(q, n);
  Integer3 normal;
  for (int i = 0; i < 3; ++i) normal[i] = n_n * q[i] - q_n * n[i];
  divide_by_content(normal);
  return plane_at(normal, on_both);
}

// ---- transforms ----
ExactAffine::ExactAffine(const std::vector<Affine>& list) : w_(1) {
  for (int i = 0; i < 3; ++i) linear_[i][i] = 1;
  for (const Affine& affine : list) {
    std::array<double, 13> flat{};
    for (int i = 0; i < 12; ++i) flat[i] = affine.m[i / 3][i % 3];
    flat[12] = 1;
    const std::array<Integer, 13> next = integers(flat);
    std::array<Integer, 13> product;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        product[3 * i + j] =
            linear_[i][0] * next[j] + linear_[i][1] * next[3 + j] + linear_[i][2] * next[6 + j];
      }
      product[9 + j] = shift_[0] * next[j] + shift_[1] * next[3 + j] + shift_[2] * next[6 + j] +
                       w_ * next[9 + j];
    }
    product[12] = w_ * next[12];
    divide_by_content(product);
    for (int i = 0; i < 9; ++i) linear_[i / 3][i % 3] = product[i];
    for (int j = 0; j < 3; ++j) shift_[j] = product[9 + j];
    w_ = product[12];
  }
  // Columns of the adjugate are cross products of rows: L adj(L) = det(L).
  for (int j = 0; j < 3; ++j) {
    const Integer3 column = cross(linear_[(j + 1) % 3], linear_[(j + 2) % 3]);
    for (int i = 0; i < 3; ++i) adjugate_[i][j] = column[i];
  }
  det_ = dot(linear_[0], cross(linear_[1], linear_[2]));
}

ExactPoint ExactAffine::operator()(const ExactPoint& p) const {
  Integer4 out;
  for (int j = 0; j < 3; ++j) {
    out[j] = p.v[0] * linear_[0][j] + p.v[1] * linear_[1][j] + p.v[2] * linear_[2][j] +
             p.v[3] * shift_[j];
  }
  out[3] = p.v[3] * w_;
  return ExactPoint(std::move(out));
}

// p' . n' = w det (p . n) with n' = (w adj(L) n, det n_4 - t adj(L) n).
ExactPlane ExactAffine::operator()(const ExactPlane& p) const {
  Integer3 normal;
  const Integer3 n = p.normal();
  for (int i = 0; i < 3; ++i) normal[i] = dot(adjugate_[i], n);
  Integer4 out{normal[0] * w_, normal[1] * w_, normal[2] * w_, det_ * p.v[3] - dot(shift_, normal)};
  if (det_ < 0) {
    for (Integer& value : out) value = -value;
  }
  return ExactPlane(std::move(out));
}

std::array<std::array<double, 3>, 3> ExactAffine::linear() const {
  std::array<std::array<double, 3>, 3> out{};
  for (int i = 0; i < 9; ++i) out[i / 3][i % 3] = quotient(linear_[i / 3][i % 3], w_);
  return out;
}

// ---- out to double ----
double quotient(const Integer& numerator, const Integer& denominator) {
  if (numerator == 0) return 0;
  // A quotient of 61 or 62 bits with its last bit sticky, which the conversion rounds once.
  const long shift = 61 - (bits(numerator) - bits(denominator));
  Integer n = abs(numerator), d = denominator, rest;
  if (shift >= 0) {
    n <<= static_cast<unsigned long>(shift);
  } else {
    d <<= static_cast<unsigned long>(-shift);
  }
  mpz_tdiv_qr(n.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  const unsigned long q = n.get_ui() | (rest != 0 ? 1UL : 0UL);
  const double magnitude = std::ldexp(static_cast<double>(q), static_cast<int>(-shift));
  return numerator < 0 ? -magnitude : magnitude;
}

Vec3 rounded(const ExactPoint& p) {
  return {quotient(p.v[0], p.v[3]), quotient(p.v[1], p.v[3]), quotient(p.v[2], p.v[3])};
}

Vec3 rounded_difference(const ExactPoint& p, const ExactPoint& origin) {
  std::array<double, 3> out{};
  for (int i = 0; i < 3; ++i) {
    out[i] = quotient(p.v[i] * origin.v[3] - origin.v[i] * p.v[3], p.v[3] * origin.v[3]);
  }
  return {out[0], out[1], out[2]};
}

Vec3 unit_normal(const ExactPlane& plane) {
  Integer3 normal = plane.normal();
  divide_by_content(normal);
  const Length size = length(normal);
  return {quotient(normal[0] << size.shift, size.root),
          quotient(normal[1] << size.shift, size.root),
          quotient(normal[2] << size.shift, size.root)};
}

double distance(const ExactPlane& plane, const ExactPoint& point) {
  Integer height = 0;
  for (int i = 0; i < 4; ++i) height += plane.v[i] * point.v[i];
  const Length size = length(plane.normal());
  return quotient(height << size.shift, point.v[3] * size.root);
}

}  // namespace nicol::solids
