// Evanescent waves of biaxial and of anisotropic active media: frozen-polarization quadratic with complex roots.
//
// The formulas of frozen_polarization.h are analytic in p: without conjugates, left eigenvectors in place of
// conjugated ones, they hold for complex p. M is complex symmetric but for the gyration; d = (m11 - m22)/2, r^2 = d^2
// + m12^2 + g^2, Re(r d*) >= 0:
//   eigenvectors (d + r, m12 - i g) and (-(m12 + i g), d + r), weights w11 = (1 +- d/r)/2, rho = +- m12/(2 r)
// From step to step the polarization is followed, not its label: sorted eigenvalues change sheets in 1 of 100 cases.
// Each root is the one with Im p > 0. Source as in frozen_polarization.h. Test: tests/kernels/vectors_test.cpp,
// waves_test.cpp.
#ifndef NICOL_EVANESCENT_WAVES_H
#define NICOL_EVANESCENT_WAVES_H
#include "frozen_polarization.h"

typedef struct {
  cplx p, e1, e2;  // D = e1 u + e2 v, of unit (Hermitian) length
  real residual;   // |(F + M) e|
} EvanescentRoot;

typedef struct {
  cplx m11, m12, m22, g, kk;
  cplx middle, r;  // eigenvalues (m11 + m22)/2 +- r
  cplx a1, ab, ba; // eigenvectors (a1, ab) and (-ba, a1)
} ComplexSection;

FUNCTION cplx caxpy(real s, cplx a, cplx b) { return complex_of(s * a.re + b.re, s * a.im + b.im); }

FUNCTION ComplexSection complex_section(PRIVATE const GeneralFace* f, cplx p) {
  ComplexSection s;
  real q = f->q, q2 = q * q;
  cplx p2 = cmul(p, p), k2 = complex_of(p2.re + q2, p2.im);
  s.kk = csqrt_of(k2);
  s.m11 = cscale(f->a.uu, k2);
  s.m12 = cmul(s.kk, complex_of(q * f->a.un - p.re * f->a.ut, -p.im * f->a.ut));
  s.m22 = caxpy(f->a.tt, p2, cscale(-lanes(2) * q * f->a.tn, p));
  s.m22.re += q2 * f->a.nn;
  s.g = complex_of(lanes(0), lanes(0));
  if (f->active) {
    cplx along_k = caxpy(f->g.nn, p2, cscale(lanes(2) * q * f->g.tn, p));
    along_k.re += q2 * f->g.tt;
    s.g = cmul(s.kk, along_k);
  }
  s.middle = cscale(lanes(0.5), cadd(s.m11, s.m22));
  cplx d = cscale(lanes(0.5), csub(s.m11, s.m22));
  s.r = csqrt_of(cadd(cmul(d, d), cadd(cmul(s.m12, s.m12), cmul(s.g, s.g))));
  mask turned = s.r.re * d.re + s.r.im * d.im < lanes(0);
  s.r = complex_of(pick(turned, -s.r.re, s.r.re), pick(turned, -s.r.im, s.r.im));
  s.a1 = cadd(d, s.r);
  s.ab = complex_of(s.m12.re + s.g.im, s.m12.im - s.g.re);
  s.ba = complex_of(s.m12.re - s.g.im, s.m12.im + s.g.re);
  return s;
}

// |<(e1, e2), (x1, x2)>|^2
FUNCTION real overlap(cplx e1, cplx e2, cplx x1, cplx x2) {
  return norm2(cadd(cmul(conj_of(e1), x1), cmul(conj_of(e2), x2)));
}

// One step from the polarization whose eigenvalue is middle + sign r.
FUNCTION cplx quadratic_step(PRIVATE const GeneralFace* f, PRIVATE const ComplexSection* s, cplx p, real sign) {
  real q = f->q, two = lanes(2), middle = lanes(0.5);
  mask split = norm2(s->r) > lanes(0);
  cplx inverse_r = cdiv(complex_of(middle * sign, lanes(0)), cpick(split, s->r, complex_of(lanes(1), lanes(0))));
  cplx d = csub(s->a1, s->r), tilt = cmul(d, inverse_r), rho = cmul(s->m12, inverse_r);
  tilt = cpick(split, tilt, complex_of(middle * sign, lanes(0)));
  cplx w11 = complex_of(middle + tilt.re, tilt.im), w22 = complex_of(middle - tilt.re, -tilt.im);
  cplx c0 = cdiv(complex_of(q * q, lanes(0)), s->kk), c1 = cdiv(p, s->kk);
  cplx w11_uu = cscale(f->a.uu, w11), rho2 = cscale(two, rho), w11_c1 = cmul(w11_uu, c1), w11_c0 = cmul(w11_uu, c0);
  cplx a = cadd(cmul(w11_c1, c1), caxpy(f->a.tt, w22, cscale(-f->a.ut, cmul(rho2, c1))));
  a.re += lanes(1);
  cplx b = cadd(cmul(w11_c0, c1), cscale(-q * f->a.tn, w22));
  b = cadd(b, cmul(rho, csub(cscale(q * f->a.un, c1), cscale(f->a.ut, c0))));
  cplx c = cadd(cmul(w11_c0, c0), caxpy(q * f->a.un, cmul(rho2, c0), cscale(q * q * f->a.nn, w22)));
  if (f->active) c = cadd(c, cscale(two, cmul(cmul(s->g, s->g), inverse_r)));
  c.re -= f->p2;
  cplx root = csqrt_of(csub(cmul(b, b), cmul(a, c)));
  cplx inverse_a = cdiv(complex_of(lanes(1), lanes(0)), a), up = cmul(root, inverse_a);
  mask down = up.im < lanes(0);
  up = complex_of(pick(down, -up.re, up.re), pick(down, -up.im, up.im));
  return csub(up, cmul(b, inverse_a));
}

// The evanescent root of a sheet (sign +1 fast, -1 slow) in the lanes of `which`.
FUNCTION EvanescentRoot evanescent_root(PRIVATE const GeneralFace* f, real sheet, mask which) {
  EvanescentRoot root;
  real start = sqrt_of(abs_of(f->p2));
  root.p = complex_of(lanes(0), pick(abs_of(f->p2) < lanes(1e-3f), lanes(0.0316f), start));
  root.e1 = root.e2 = complex_of(lanes(0), lanes(0));
  root.residual = lanes(0);
  mask moving = which;
  for (int i = 0; i <= FPQ_STEPS; ++i) {
    ComplexSection s = complex_section(f, root.p);
    // (a1, ab) or (-ba, a1): by eigenvalue first, then the one more like the last
    real n_a = norm2(s.a1) + norm2(s.ab), n_b = norm2(s.a1) + norm2(s.ba);
    cplx minus_ba = complex_of(-s.ba.re, -s.ba.im);
    mask like_a = overlap(root.e1, root.e2, s.a1, s.ab) * n_b >= overlap(root.e1, root.e2, minus_ba, s.a1) * n_a;
    mask take_a = i == 0 ? sheet * s.r.re >= lanes(0) : like_a;
    real n = pick(take_a, n_a, n_b);
    mask any = n > lanes(0);
    real unit = lanes(1) / sqrt_of(pick(any, n, lanes(1)));
    cplx e1 = cscale(unit, cpick(take_a, s.a1, minus_ba)), e2 = cscale(unit, cpick(take_a, s.ab, s.a1));
    root.e1 = e1;
    root.e2 = e2;
    mask none = not_mask(any);
    root.e1.re = pick(none, pick(take_a, lanes(1), lanes(0)), root.e1.re);
    root.e2.re = pick(none, pick(take_a, lanes(0), lanes(1)), root.e2.re);
    if (i == FPQ_STEPS || !any_lane(moving)) {
      cplx off = csub(cmul(root.p, root.p), complex_of(f->p2, lanes(0)));
      cplx row1 = cadd(cmul(cadd(off, s.m11), root.e1), cmul(s.ba, root.e2));
      cplx row2 = cadd(cmul(s.ab, root.e1), cmul(cadd(off, s.m22), root.e2));
      root.residual = sqrt_of(norm2(row1)) + sqrt_of(norm2(row2));
      break;
    }
    cplx next = quadratic_step(f, &s, root.p, pick(take_a, lanes(1), lanes(-1)));
    real moved = norm2(csub(next, root.p));
    root.p = cpick(moving, next, root.p);
    moving = moving & (moved > lanes(FPQ_SETTLED) * lanes(FPQ_SETTLED));
  }
  return root;
}

#endif
