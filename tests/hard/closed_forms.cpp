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

}  // namespace nicol::hard
