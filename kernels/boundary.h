// The boundary problem of a face: amplitudes of the two reflected and two transmitted waves.
//
// Tangential E and h are continuous: [T1 T2 -R1 -R2] a = incident, each column scaled to unit length, by
// Gaussian elimination with partial pivoting, lane by lane (condition <= 90 over all media).
// Source: Berreman, J. Opt. Soc. Am. 62, 502 (1972). Test: tests/kernels (oracle).
#ifndef NICOL_BOUNDARY_H
#define NICOL_BOUNDARY_H
#include "modes.h"

// Incident field in (t, u, N). Out: complex amplitudes of transmitted[0..1], reflected[0..1].
FUNCTION void match_fields(PRIVATE const cplx* e, PRIVATE const cplx* h, PRIVATE const Mode* transmitted,
                           PRIVATE const Mode* reflected, PRIVATE cplx* amplitude) {
  cplx m[4][5];
  real unit[4];
  for (int j = 0; j < 4; ++j) {
    Mode mode = j < 2 ? transmitted[j] : reflected[j - 2];
    real length2 = norm2(mode.e[0]) + norm2(mode.e[1]) + norm2(mode.h[0]) + norm2(mode.h[1]);
    unit[j] = lanes(1) / sqrt_of(length2);
    real scale = j < 2 ? unit[j] : -unit[j];
    m[0][j] = cscale(scale, mode.e[0]);
    m[1][j] = cscale(scale, mode.e[1]);
    m[2][j] = cscale(scale, mode.h[0]);
    m[3][j] = cscale(scale, mode.h[1]);
  }
  m[0][4] = e[0];
  m[1][4] = e[1];
  m[2][4] = h[0];
  m[3][4] = h[1];
  for (int c = 0; c < 4; ++c) {
    for (int r = c + 1; r < 4; ++r) {  // the largest pivot comes to row c
      mask larger = norm2(m[r][c]) > norm2(m[c][c]);
      for (int k = c; k < 5; ++k) {
        cplx upper = m[c][k], lower = m[r][k];
        m[c][k] = cpick(larger, lower, upper);
        m[r][k] = cpick(larger, upper, lower);
      }
    }
    for (int r = c + 1; r < 4; ++r) {
      cplx factor = cdiv(m[r][c], m[c][c]);
      for (int k = c + 1; k < 5; ++k) m[r][k] = csub(m[r][k], cmul(factor, m[c][k]));
    }
  }
  for (int r = 3; r >= 0; --r) {
    cplx sum = m[r][4];
    for (int k = r + 1; k < 4; ++k) sum = csub(sum, cmul(m[r][k], amplitude[k]));
    amplitude[r] = cdiv(sum, m[r][r]);
  }
  for (int j = 0; j < 4; ++j) amplitude[j] = cscale(unit[j], amplitude[j]);
}

#endif
