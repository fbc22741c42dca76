#include "tests/kernels/uniaxial.hpp"

#include <algorithm>
#include <cmath>

namespace nicol::test {
namespace {

using Vector = std::array<Complex, 3>;
struct Wave {
  Vector e, h;
};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Complex dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double flux(const Wave& w) {
  return 0.5 * std::real(w.e[0] * std::conj(w.h[1]) - w.e[1] * std::conj(w.h[0]));
}

Wave vacuum_wave(double q, double p, bool forward, bool s) {
  const Vector k{q, 0, (forward ? p : -p)}, u{0, 1, 0};
  const Vector other = cross(k, u);
  if (s) return {u, other};
  return {{-other[0], -other[1], -other[2]}, u};  // h = u, E = -k x h
}

// Normal component of the crystal's wave vectors; forward waves carry energy along N.
Wave crystal_wave(const UniaxialFace& face, bool forward, bool ordinary) {
  const double eps_o = face.n_o * face.n_o, eps_e = face.n_e * face.n_e;
  const Vector c{face.axis[0], face.axis[1], face.axis[2]};
  Vector k{face.q, 0, 0};
  if (ordinary) {
    k[2] = (forward ? 1.0 : -1.0) * std::sqrt(Complex(eps_o - face.q * face.q));
    const Vector e = cross(k, c);
    return {e, cross(k, e)};
  }
  // k.(eps k) = eps_o eps_e as a quadratic in the normal component
  const double d = eps_e - eps_o, ct = face.axis[0], cn = face.axis[2], q = face.q;
  const double a = eps_o + d * cn * cn, b = d * q * ct * cn, rest = eps_o * q * q + d * q * q * ct * ct - eps_o * eps_e;
  k[2] = (-b + (forward ? 1.0 : -1.0) * std::sqrt(Complex(b * b - a * rest))) / a;
  const Vector h = cross(k, c);
  const Vector displaced = cross(k, h);  // -D
  const Complex along = (1 / eps_e - 1 / eps_o) * dot(c, displaced);
  Vector e;
  for (int i = 0; i < 3; ++i) e[i] = -(displaced[i] / eps_o + along * c[i]);
  return {e, h};
}

using Matrix = std::array<std::array<Complex, 5>, 4>;

std::array<Complex, 4> solve(Matrix m) {
  for (int c = 0; c < 4; ++c) {
    int pivot = c;
    for (int r = c + 1; r < 4; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    std::swap(m[c], m[pivot]);
    for (int r = 0; r < 4; ++r) {
      if (r == c) continue;
      const Complex factor = m[r][c] / m[c][c];
      for (int j = c; j < 5; ++j) m[r][j] -= factor * m[c][j];
    }
  }
  return {m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2], m[3][4] / m[3][3]};
}

// Amplitudes of two transmitted and two reflected waves: transmitted - reflected = incident.
std::array<Complex, 4> match(const Wave& incident, const std::array<Wave, 4>& out) {
  Matrix m;
  const auto fill = [&](int column, const Wave& w, double sign) {
    m[0][column] = sign * w.e[0];
    m[1][column] = sign * w.e[1];
    m[2][column] = sign * w.h[0];
    m[3][column] = sign * w.h[1];
  };
  for (int i = 0; i < 4; ++i) fill(i, out[i], i < 2 ? 1 : -1);
  fill(4, incident, 1);
  return solve(m);
}

}  // namespace

std::array<Complex, 2> into_ordinary(const UniaxialFace& face) {
  const std::array<Wave, 4> out{crystal_wave(face, true, true), crystal_wave(face, true, false),
                                vacuum_wave(face.q, face.p, false, true), vacuum_wave(face.q, face.p, false, false)};
  std::array<Complex, 2> tau;
  for (const bool s : {true, false}) {
    const Wave incident = vacuum_wave(face.q, face.p, true, s);
    tau[s ? 0 : 1] = match(incident, out)[0] * std::sqrt(flux(out[0]) / flux(incident));
  }
  return tau;
}

std::array<Complex, 2> out_of_ordinary(const UniaxialFace& face) {
  const Wave incident = crystal_wave(face, true, true);
  const std::array<Wave, 4> out{vacuum_wave(face.q, face.p, true, true), vacuum_wave(face.q, face.p, true, false),
                                crystal_wave(face, false, true), crystal_wave(face, false, false)};
  const std::array<Complex, 4> amplitude = match(incident, out);
  return {amplitude[0] * std::sqrt(flux(out[0]) / flux(incident)), amplitude[1] * std::sqrt(flux(out[1]) / flux(incident))};
}

}  // namespace nicol::test
