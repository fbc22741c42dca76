// Closed forms in extended precision that hard cases are held to.
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "host/scene.hpp"

namespace nicol::hard {

using Real = long double;
using Field = std::complex<Real>;

constexpr Real pi_real = 3.14159265358979323846264338327950288L;

// Fresnel's equations for transparent media (Born & Wolf, 7th ed., 1.5.2-1.5.4); p1 = n1 cos(theta1), signs of kernels/README.md.
// Under total reflection T = 0.
struct Face {
  Field r_s, r_p;
  Real T_s, T_p, p2;
};
Face face_between(Real n1, Real n2, Real p1);

// A plate of n2 in n1 with all reflections, intensities added: T = (1 - R)/(1 + R); N plates with gaps between them:
// (1 - R)/(1 + (2 N - 1) R) (Stokes, Proc. R. Soc. 11, 545 (1862)).
struct Plate {
  Real T_s, T_p;
  Real mean() const { return (T_s + T_p) / 2; }
  Real difference() const { return (T_s - T_p) / 2; }
};
Plate plate_between(Real n1, Real n2, Real p1, int plates = 1);

// Largest change of f when x changes by up to dx.
inline Real spread(const std::function<Real(Real)>& f, Real x, Real dx) {
  return std::max(std::fabs(f(x + dx) - f(x)), std::fabs(f(x - dx) - f(x)));
}

}  // namespace nicol::hard
