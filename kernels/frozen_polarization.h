// Waves of biaxial and of anisotropic active media that run away from a face: frozen-polarization quadratic.
//
// Forward waves, wave vector (q, 0, p) in (t, u, N), kk^2 = q^2 + p^2, v = (q N - p t)/kk, so that (u, v, s) is
// right-handed. a = n2bar eta - I (deviatoric), g = kk k.gq.k; D = e1 u + e2 v is an eigenvector of the section
//   M(p) = [[m11, m12 + i g], [m12 - i g, m22]],  m11 = kk^2 a_uu,  m12 = kk (q a_uN - p a_ut),
//   m22 = q^2 a_NN - 2 q p a_tN + p^2 a_tt,  p^2 - (n2bar - q^2) + lambda(p) = 0;  fast: larger lambda, slow: smaller.
// With the polarization frozen, (p^2 - ...) + e*.M(p).e is A p^2 + 2 B p + C but for the slow kk: one step p =
// (sqrt(B^2 - A C) - B)/A.
// It is Newton's method on the exact sheet (Hellmann-Feynman: dlambda/dp = e*.M'.e) that keeps the curvature, so it
// passes the critical angle, and A p + B = sqrt(disc) > 0 makes the root forward by flux. Index ellipsoid: Born & Wolf,
// Principles of Optics, 15.2; wave surface for a given tangential vector: Booker, Phil. Trans. R. Soc. A 237, 411
// (1936).
// Two real roots closer than sqrt(epsilon) nbar are solved together, so that their fields stay flux-orthogonal:
//   (F + F' (p - p0)) e = 0,  F = (p0^2 - ...) I + M(p0) Hermitian, F' = L L^H.
// Activity to first order in zeta. Good for roots that settle (FPQ_SLACK); others: evanescent_waves.h, precise_waves.h.
// Test: tests/kernels/vectors_test.cpp, waves_test.cpp.
#ifndef NICOL_FROZEN_POLARIZATION_H
#define NICOL_FROZEN_POLARIZATION_H
#include "section.h"

#define FPQ_STEPS (sizeof(scalar) == 8 ? 12 : 8)
#define FPQ_SETTLED (sizeof(scalar) == 8 ? 1e-10f : 2e-6f)
#define FPQ_SLACK (sizeof(scalar) == 8 ? 4.5e-8f : 1e-3f)     // 3 sqrt(epsilon)
#define FPQ_FLOOR (sizeof(scalar) == 8 ? 3.6e-15f : 2e-6f)    // 16 epsilon
#define CLOSE_PAIR (sizeof(scalar) == 8 ? 1.5e-8f : 3.5e-4f)  // sqrt(epsilon)

// What the quadratic needs of medium and face. Forward frame: mirrored for backward waves.
typedef struct {
  FaceTensor a, g;  // a, gq; g only where active
  int active;
  real q, p2, n, inverse_eps;  // p2 = n2bar - q^2
} GeneralFace;

typedef struct {
  real m11, m12, m22, g, kk;
} SectionMatrix;

FUNCTION real squared_along(PRIVATE const FaceTensor* a, real q, real p) {
  return q * q * a->nn + p * (p * a->tt - lanes(2) * q * a->tn);
}

FUNCTION SectionMatrix section_at(PRIVATE const GeneralFace* f, real p) {
  SectionMatrix m;
  real k2 = f->q * f->q + p * p;
  m.kk = sqrt_of(k2);
  m.m11 = k2 * f->a.uu;
  m.m12 = m.kk * (f->q * f->a.un - p * f->a.ut);
  m.m22 = squared_along(&f->a, f->q, p);
  m.g = lanes(0);
  if (f->active) m.g = m.kk * (f->q * (f->q * f->g.tt + lanes(2) * p * f->g.tn) + p * p * f->g.nn);
  return m;
}

// A root of one sheet: sign +1 fast, -1 slow.
typedef struct {
  real p, step;  // step: length of the last one
  mask gone;     // the last quadratic had no real root
} SheetRoot;

FUNCTION SheetRoot sheet_root(PRIVATE const GeneralFace* f, real sign, mask live) {
  SheetRoot root;
  // lanes that are not live get a root that makes no face singular
  root.p = pick(live, sqrt_of(pick(f->p2 > lanes(0), f->p2, lanes(0))), f->n);
  root.step = lanes(0);
  root.gone = root.p != root.p;
  mask moving = live;
  real q = f->q, middle = lanes(0.5);
  for (int i = 0; i < FPQ_STEPS && any_lane(moving); ++i) {
    real p = root.p;
    SectionMatrix m = section_at(f, p);
    // weights of the frozen polarization: its projector is I/2 +- (M - mean)/(2 r)
    real d = middle * (m.m11 - m.m22), r = sqrt_of(d * d + m.m12 * m.m12 + m.g * m.g);
    mask split = r > lanes(0);
    real weight = middle * sign / pick(split, r, lanes(1));
    real tilt = pick(split, weight * d, middle * sign), w11 = middle + tilt, w22 = middle - tilt, rho = weight * m.m12;
    // quadratic
    real inverse = lanes(1) / m.kk, c0 = q * q * inverse, c1 = p * inverse;
    real a = lanes(1) + w11 * f->a.uu * c1 * c1 - lanes(2) * rho * c1 * f->a.ut + w22 * f->a.tt;
    real b = w11 * f->a.uu * c0 * c1 + rho * (c1 * q * f->a.un - c0 * f->a.ut) - w22 * q * f->a.tn;
    real c = w11 * f->a.uu * c0 * c0 + lanes(2) * rho * c0 * q * f->a.un + w22 * q * q * f->a.nn +
             lanes(2) * weight * m.g * m.g - f->p2;
    real disc = b * b - a * c;
    real next = (sqrt_of(pick(disc > lanes(0), disc, lanes(0))) - b) / a;
    root.gone = pick(moving, not_mask(disc > lanes(0)), root.gone);
    root.step = pick(moving, abs_of(next - p), root.step);
    root.p = pick(moving, next, p);
    moving = moving & (root.step > lanes(FPQ_SETTLED));
  }
  return root;
}

// A real wave: p, D = e1 u + e2 v.
typedef struct {
  real p;
  cplx e1, e2;
} SheetWave;

// (v + a v)/n2bar
FUNCTION void impermeability_on_face(PRIVATE const GeneralFace* f, PRIVATE const cplx* v, PRIVATE cplx* out) {
  PRIVATE const FaceTensor* a = &f->a;
  out[0] = cadd(cscale(lanes(1) + a->tt, v[0]), cadd(cscale(a->ut, v[1]), cscale(a->tn, v[2])));
  out[1] = cadd(cscale(a->ut, v[0]), cadd(cscale(lanes(1) + a->uu, v[1]), cscale(a->un, v[2])));
  out[2] = cadd(cscale(a->tn, v[0]), cadd(cscale(a->un, v[1]), cscale(lanes(1) + a->nn, v[2])));
  for (int i = 0; i < 3; ++i) out[i] = cscale(f->inverse_eps, out[i]);
}

FUNCTION cplx add_times_i(cplx a, real s, cplx b) { return complex_of(a.re - s * b.im, a.im + s * b.re); }

// k x e for k = (q, 0, p), complex p.
FUNCTION void times_wave_vector(real q, cplx p, PRIVATE const cplx* e, PRIVATE cplx* h) {
  cplx pu = cmul(p, e[1]);
  h[0] = complex_of(-pu.re, -pu.im);
  h[1] = csub(cmul(p, e[0]), cscale(q, e[2]));
  h[2] = cscale(q, e[1]);
}

// E and h of D with wave vector (q, 0, p): E0 = eta D, E = eta (D - i G x E0), h = k x E + i zeta E.
FUNCTION Mode fields_of_d(PRIVATE const GeneralFace* f, PRIVATE const FaceTensor* z, cplx p, PRIVATE const cplx* d) {
  Mode m;
  m.p = p;
  impermeability_on_face(f, d, m.e);
  if (f->active) {
    real trace = z->tt + z->uu + z->nn, q = f->q;
    cplx g[3], x[3], bent[3];
    g[0] = complex_of((z->uu + z->nn) * q - z->tn * p.re, -z->tn * p.im);
    g[1] = complex_of(-z->ut * q - z->un * p.re, -z->un * p.im);
    g[2] = complex_of((trace - z->nn) * p.re - z->tn * q, (trace - z->nn) * p.im);
    for (int i = 0; i < 3; ++i) {
      int j = (i + 1) % 3, l = (i + 2) % 3;
      x[i] = csub(cmul(g[j], m.e[l]), cmul(g[l], m.e[j]));
    }
    impermeability_on_face(f, x, bent);
    for (int i = 0; i < 3; ++i) m.e[i] = add_times_i(m.e[i], lanes(-1), bent[i]);
  }
  times_wave_vector(f->q, p, m.e, m.h);
  if (f->active) {
    m.h[0] = add_times_i(add_times_i(add_times_i(m.h[0], z->tt, m.e[0]), z->ut, m.e[1]), z->tn, m.e[2]);
    m.h[1] = add_times_i(add_times_i(add_times_i(m.h[1], z->ut, m.e[0]), z->uu, m.e[1]), z->un, m.e[2]);
    m.h[2] = add_times_i(add_times_i(add_times_i(m.h[2], z->tn, m.e[0]), z->un, m.e[1]), z->nn, m.e[2]);
  }
  return m;
}

// Both sheets on their own. Returns p_slow - p_fast = (lambda_fast - lambda_slow)/(p_fast + p_slow).
FUNCTION real sheets_apart(PRIVATE const GeneralFace* f, real p_fast, real p_slow, PRIVATE SheetWave* w) {
  SectionMatrix m = section_at(f, p_fast), n = section_at(f, p_slow);
  Eigenpair fast = eigenpair_of(m.m11, m.m22, complex_of(m.m12, m.g));
  Eigenpair slow = eigenpair_of(n.m11, n.m22, complex_of(n.m12, n.g));
  w[0].p = p_fast;
  w[0].e1 = fast.plus1;
  w[0].e2 = fast.plus2;
  w[1].p = p_slow;
  w[1].e1 = complex_of(-slow.plus2.re, slow.plus2.im);
  w[1].e2 = conj_of(slow.plus1);
  real sum = p_fast + p_slow, plain = p_slow - p_fast;
  mask formula = sum > abs_of(plain);
  real lambdas = (fast.mean - slow.mean) + (fast.radius + slow.radius);
  return pick(formula, lambdas / pick(formula, sum, lanes(1)), plain);
}

// Two real roots close to p0, together. Returns p_slow - p_fast.
FUNCTION real sheets_together(PRIVATE const GeneralFace* f, real p0, PRIVATE SheetWave* w) {
  SectionMatrix m = section_at(f, p0);
  real q = f->q, slope = p0 / m.kk, lin = q * f->a.un - p0 * f->a.ut, two = lanes(2);
  // F and F'
  real base = p0 * p0 - f->p2;
  cplx b = complex_of(m.m12, m.g), db = complex_of(slope * lin - m.kk * f->a.ut, lanes(0));
  if (f->active)
    db.im = slope * m.g / m.kk + m.kk * (two * q * f->g.tn + two * p0 * f->g.nn);
  real f11 = base + m.m11, f22 = base + m.m22;
  real a1 = two * p0 * (lanes(1) + f->a.uu), a2 = two * (p0 + p0 * f->a.tt - q * f->a.tn);
  // F' = L L^H, H = L^-1 F L^-H
  mask sound = a1 > lanes(0);
  real l1 = sqrt_of(pick(sound, a1, lanes(1))), inverse1 = lanes(1) / l1;
  cplx l21 = cscale(inverse1, conj_of(db));
  real rest = a2 - norm2(l21);
  real inverse2 = lanes(1) / sqrt_of(pick(rest > lanes(0), rest, lanes(1)));
  real h11 = f11 * inverse1 * inverse1;
  cplx h12 = cscale(inverse1 * inverse2, csub(b, cscale(f11 * inverse1, conj_of(l21))));
  cplx g21 = cscale(inverse2, csub(conj_of(b), cscale(f11 * inverse1, l21)));
  real g22 = inverse2 * (f22 - inverse1 * cmul(l21, b).re);
  real h22 = inverse2 * (g22 - inverse1 * cmul(g21, conj_of(l21)).re);
  Eigenpair pair = eigenpair_of(h11, h22, h12);
  // e = L^-H y, unit
  for (int j = 0; j < 2; ++j) {
    cplx y1 = j == 0 ? pair.plus1 : complex_of(-pair.plus2.re, pair.plus2.im);
    cplx y2 = j == 0 ? pair.plus2 : conj_of(pair.plus1);
    cplx e2 = cscale(inverse2, y2), e1 = cscale(inverse1, csub(y1, cmul(conj_of(l21), e2)));
    real unit = lanes(1) / sqrt_of(norm2(e1) + norm2(e2));
    w[j].e1 = cscale(unit, e1);
    w[j].e2 = cscale(unit, e2);
    w[j].p = p0 - pair.mean - (j == 0 ? pair.radius : -pair.radius);
  }
  return two * pair.radius;
}

FUNCTION SheetWave pick_sheet(mask keep, SheetWave a, SheetWave b) {
  a.p = pick(keep, a.p, b.p);
  a.e1 = cpick(keep, a.e1, b.e1);
  a.e2 = cpick(keep, a.e2, b.e2);
  return a;
}

FUNCTION GeneralFace general_face(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p2, int backward) {
  GeneralFace g;
  g.a = on_face(m->atil, f, backward);
  g.g = g.a;
  if (m->active) g.g = on_face(m->gq, f, backward);
  g.active = m->active;
  g.q = f->q;
  g.p2 = p2;
  g.n = m->n;
  g.inverse_eps = lanes(1) / m->eps;
  return g;
}

// The last step was short enough to trust the root.
FUNCTION mask settled(PRIVATE const GeneralFace* f, PRIVATE const SheetRoot* root) {
  return root->step <= lanes(FPQ_SLACK) * abs_of(root->p) + lanes(FPQ_FLOOR) * f->n;
}

#endif
