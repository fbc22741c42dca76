#include "tests/hard/closed_forms.hpp"

namespace nicol::hard {

Face face_between(Real n1, Real n2, Real p1) {
  const Real eps1 = n1 * n1, eps2 = n2 * n2, delta = (n2 - n1) * (n2 + n1), square = p1 * p1 + delta;
  const Field p2 = square > 0 ? Field(std::sqrt(square)) : Field(0, std::sqrt(-square));
  Face f;
  const Field sum_s = p1 + p2, sum_p = eps2 * p1 + eps1 * p2;
  // (p1 - p2)(p1 + p2) and (eps2 p1 - eps1 p2)(eps2 p1 + eps1 p2), without differences of like numbers
  f.r_s = -delta / (sum_s * sum_s);
  f.r_p = delta * (p1 * p1 * (eps1 + eps2) - eps1 * eps1) / (sum_p * sum_p);
  f.p2 = p2.real();
  f.T_s = 4 * p1 * f.p2 / std::norm(p1 + p2);
  f.T_p = 4 * eps1 * eps2 * p1 * f.p2 / std::norm(eps2 * p1 + eps1 * p2);
  return f;
}

Plate plate_between(Real n1, Real n2, Real p1, int plates) {
  const Face f = face_between(n1, n2, p1);
  const auto through = [&](Real T) {
    const Real R = 1 - T;
    return T / (T + 2 * plates * R);   // 1 + (2 N - 1) R = T + 2 N R
  };
  return {through(f.T_s), through(f.T_p)};
}

namespace {

void add_field(Stokes& sum, Field x, Field y) {
  sum[0] += std::norm(x) + std::norm(y);
  sum[1] += std::norm(x) - std::norm(y);
  sum[2] += 2 * (x * std::conj(y)).real();
  sum[3] += 2 * (x * std::conj(y)).imag();
}

struct Matrix {
  Field xx, xy, yx, yy;
};
Matrix operator*(const Matrix& a, const Matrix& b) {
  return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
}

}  // namespace

Stokes wave_plate(const std::array<Real, 2>& n, Real b, Real waves_thick, Real a) {
  Stokes sum{};
  const Real c = std::cos(b), s = std::sin(b), share[2] = {std::cos(a - b), std::sin(a - b)};
  for (int m = 0; m < 400; ++m) {
    Field wave[2];
    for (int j = 0; j < 2; ++j) {
      const Real root = (n[j] - 1) / (n[j] + 1), turns = j == 0 ? 0 : (2 * m + 1) * (n[1] - n[0]) * waves_thick;
      wave[j] = std::polar(share[j] * (1 - root * root) * std::pow(root, 2 * m), Real(0)) *
                std::polar(Real(1), 2 * pi_real * (turns - std::rint(turns)));
    }
    add_field(sum, c * wave[0] - s * wave[1], s * wave[0] + c * wave[1]);
  }
  return sum;
}

Stokes turning_plate(Real n, Real retardance, Real turn, Real a) {
  const Real psi = std::sqrt(retardance * retardance / 4 + turn * turn), sine = psi > 0 ? std::sin(psi) / psi : 1;
  const Field along(0, sine * retardance / 2);
  const Matrix there{std::cos(psi) - along, sine * turn, -sine * turn, std::cos(psi) + along};
  const Matrix back{there.xx, there.yx, there.xy, there.yy};
  const Real root = (n - 1) / (n + 1), R = root * root;
  Stokes sum{};
  Matrix way = there;
  Real amplitude = 1 - R;
  for (int m = 0; m < 400; ++m, way = way * back * there, amplitude *= R)
    add_field(sum, amplitude * (way.xx * std::cos(a) + way.xy * std::sin(a)),
        amplitude * (way.yx * std::cos(a) + way.yy * std::sin(a)));
  return sum;
}

}  // namespace nicol::hard
