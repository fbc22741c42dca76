// Plane waves of a medium with a given tangential wave vector, in the axes (t, u, N) of a face: t along the
// tangential part of the wave vector, u = N x t, wave vector (q, 0, p) in units of k0, h = Z0 H.
//
// Isotropic: s wave E = u, h = (-p, 0, q); p wave h = n u, E = (p, 0, -q)/n.
// Isotropic and optically active, D = eps E + i kappa h, B = h - i kappa E (Condon 1937; Bohren & Huffman
// 1983, ch. 8): two circular waves, hand +1 (left, n + kappa) and -1 (right, n - kappa),
//   E = (-i hand p/n_hand, 1, i hand q/n_hand)/sqrt 2,  h = -i hand n E   (n, not n_hand: one impedance).
// p comes in, from p^2 = p1^2 + (n^2 - |k_incident|^2) with the bracket computed in double on the host.
// Backward waves: the forward ones of the axes (t, -u, -N), turned back. Test: tests/kernels (oracle).
#ifndef NICOL_MODES_H
#define NICOL_MODES_H
#include "vec3.h"

typedef struct {
  cplx p;       // normal component of the wave vector
  cplx e[3];    // fields in (t, u, N)
  cplx h[3];
} Mode;

// Forward root of p^2: decays (Im p > 0) where `evanescent` holds, runs forward (Re p >= 0) elsewhere.
FUNCTION cplx forward_root(cplx p_squared, mask evanescent) {
  cplx root = csqrt_of(p_squared);
  mask wrong = (evanescent & (root.im < lanes(0))) | (not_mask(evanescent) & (root.re < lanes(0)));
  return complex_of(pick(wrong, -root.re, root.re), pick(wrong, -root.im, root.im));
}

FUNCTION Mode s_mode(real q, cplx p) {
  cplx zero = complex_of(lanes(0), lanes(0));
  Mode m;
  m.p = p;
  m.e[0] = m.e[2] = zero;
  m.e[1] = complex_of(lanes(1), lanes(0));
  m.h[0] = complex_of(-p.re, -p.im);
  m.h[1] = zero;
  m.h[2] = complex_of(q, lanes(0));
  return m;
}

FUNCTION Mode p_mode(real q, cplx p, real n) {
  cplx zero = complex_of(lanes(0), lanes(0));
  Mode m;
  m.p = p;
  m.e[0] = cscale(lanes(1) / n, p);
  m.e[1] = zero;
  m.e[2] = complex_of(-q / n, lanes(0));
  m.h[0] = m.h[2] = zero;
  m.h[1] = complex_of(n, lanes(0));
  return m;
}

FUNCTION Mode circular_mode(real q, cplx p, real n, real kappa, real hand) {
  real scale = lanes(0.70710678118654752440) * hand / (n + hand * kappa);
  Mode m;
  m.p = p;
  m.e[0] = complex_of(scale * p.im, -scale * p.re);
  m.e[1] = complex_of(lanes(0.70710678118654752440), lanes(0));
  m.e[2] = complex_of(lanes(0), scale * q);
  for (int i = 0; i < 3; ++i) m.h[i] = complex_of(hand * n * m.e[i].im, -hand * n * m.e[i].re);
  return m;
}

// A forward mode of the axes (t, -u, -N) seen in (t, u, N).
FUNCTION Mode turned_back(Mode m) {
  m.p = complex_of(-m.p.re, -m.p.im);
  for (int i = 1; i < 3; ++i) {
    m.e[i] = complex_of(-m.e[i].re, -m.e[i].im);
    m.h[i] = complex_of(-m.h[i].re, -m.h[i].im);
  }
  return m;
}

// Normal energy flux Re(E x h*) . N / 2.
FUNCTION real flux_of(PRIVATE const cplx* e, PRIVATE const cplx* h) {
  return lanes(0.5) * (e[0].re * h[1].re + e[0].im * h[1].im - e[1].re * h[0].re - e[1].im * h[0].im);
}

#endif
