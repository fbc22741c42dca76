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

// Fresnel's equations for transparent media (Born & Wolf, 7th ed., 1.5.2-1.5.4); p1 = n1 cos(theta1), signs of
// kernels/README.md. Under total reflection T = 0.
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

// Stokes vector behind a plate at normal incidence with all reflections, orders added as intensities, light of unit
// radiance polarized along (cos a, sin a). Seen along -z: x right, y up. Signs of kernels/README.md.
using Stokes = std::array<Real, 4>;

// Two linear waves of indices n[j], the field of wave 0 along (cos b, sin b), of wave 1 across it.
Stokes wave_plate(const std::array<Real, 2>& n, Real b, Real waves_thick, Real a);

// A plate that turns light by `turn` rad (> 0 clockwise) and retards y against x by `retardance`, of one index n for
// both waves: J = exp(M), M = [[-i G/2, F], [-F, i G/2]], and J^T on the way back (Jones, J. Opt. Soc. Am. 38, 671
// (1948)).
Stokes turning_plate(Real n, Real retardance, Real turn, Real a);

}  // namespace nicol::hard
