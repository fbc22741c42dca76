// Rotation of the plane of polarization in an optically active isotropic medium.
//
// A path of length d turns the plane by rho d, clockwise for the receiver if the medium is dextrorotatory
// (rho > 0): in axes (x, y) seen by the receiver J' = J R, R = [[cos, sin], [-sin, cos]]
// (Tannenbaum, Tannenbaum & Wozny 1994). The sense is the same for light running either way.
// The phase is kept in turns: rho = hi + lo turns/mm, so that 27008 deg (or 1e7) lose no digits but those
// of the path length itself. Assumes one refracted ray (mean index); the two circular waves: modes.h.
// Test: tests/kernels (refs_active_slab, refs_fig7_rotation).
#ifndef NICOL_OPTICAL_ROTATION_H
#define NICOL_OPTICAL_ROTATION_H
#include "vec3.h"

// Cosine and sine of 2 pi (hi + lo) depth, the product reduced to a fraction of a turn.
FUNCTION cplx rotation_of(real turns_hi_per_mm, real turns_lo_per_mm, real depth_mm) {
  real product = turns_hi_per_mm * depth_mm;
  real error = fma_of(turns_hi_per_mm, depth_mm, -product);
  real turn = (product - rint_of(product)) + fma_of(turns_lo_per_mm, depth_mm, error);
  real quarter = rint_of(lanes(4) * turn);
  real x = (turn - lanes(0.25) * quarter) * lanes(6.283185307179586477);  // |x| <= pi/4
  real xx = x * x;
  // Taylor series; the error of the last term kept is below the rounding of the scalar
  real s, c;
  if (sizeof(scalar) == 8) {
    s = lanes(-1.0 / 1307674368000.0);
    s = s * xx + lanes(1.0 / 6227020800.0);
    s = s * xx + lanes(-1.0 / 39916800.0);
    s = s * xx + lanes(1.0 / 362880.0);
    c = lanes(1.0 / 20922789888000.0);
    c = c * xx + lanes(-1.0 / 87178291200.0);
    c = c * xx + lanes(1.0 / 479001600.0);
    c = c * xx + lanes(-1.0 / 3628800.0);
    c = c * xx + lanes(1.0 / 40320.0);
  } else {
    s = lanes(1.0f / 362880.0f);
    c = lanes(-1.0f / 3628800.0f);
    c = c * xx + lanes(1.0f / 40320.0f);
  }
  s = s * xx + lanes(-1.0 / 5040.0);
  s = s * xx + lanes(1.0 / 120.0);
  s = s * xx + lanes(-1.0 / 6.0);
  s = s * xx * x + x;
  c = c * xx + lanes(-1.0 / 720.0);
  c = c * xx + lanes(1.0 / 24.0);
  c = c * xx + lanes(-0.5);
  c = c * xx + lanes(1);
  mask odd = abs_of(quarter) == lanes(1), opposite = abs_of(quarter) == lanes(2);
  real sign = pick(quarter < lanes(0), lanes(-1), lanes(1));
  return complex_of(pick(odd, -sign * s, pick(opposite, -c, c)), pick(odd, sign * c, pick(opposite, -s, s)));
}

#endif
