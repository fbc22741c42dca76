// Plane waves with a given wave normal s in the bulk: the section of the index ellipsoid across s.
//
// D = e1 a + e2 b in the plane across s, impermeability section of (n2bar eta - I) with the gyration as its
// imaginary part (Born & Wolf, Principles of Optics, 7th ed., 15.2; Landau & Lifshitz, Electrodynamics of Continuous
// Media, 101):
//   Lam = [[aa, ab + i g], [ab - i g, bb]],  Lam e = lambda e,  n = nbar/sqrt(1 + lambda),  g = n s.gq.s
//   n_slow - n_fast = 2 r (n_f n_s)^2/(n2bar (n_f + n_s)),  2 r = lambda_fast - lambda_slow
// g is first order in zeta: n is good to 2e-9 for quartz. Uniaxial and chiral media: closed form.
// E from D: E0 = eta D, E = eta (D - i G x E0), G = (tr zeta - zeta) k, h = k x E + i zeta E (Condon 1937).
// Test: tests/kernels/vectors_test.cpp (bulk, propagation).
#ifndef NICOL_SECTION_H
#define NICOL_SECTION_H
#include "wave_medium.h"

// D orthonormal, complex, world; 0 fast, ordinary or right circular. Where active: -k x (k x E), which is D but for
// terms of order zeta, and orthogonal but for such terms.
typedef struct {
  vec3 d_re[2], d_im[2];
  real n[2];
  real gap;  // n[1] - n[0]
} SectionWaves;

// Eigenvectors of [[m11, b], [b*, m22]], orthonormal: (plus1, plus2), (-plus2*, plus1*); plus has the larger
// eigenvalue.
typedef struct {
  cplx plus1, plus2;
  real mean, radius;
} Eigenpair;

FUNCTION Eigenpair eigenpair_of(real m11, real m22, cplx b) {
  Eigenpair out;
  real d = lanes(0.5) * (m11 - m22);
  out.mean = lanes(0.5) * (m11 + m22);
  out.radius = sqrt_of(d * d + norm2(b));
  real c = out.radius + abs_of(d), length2 = c * c + norm2(b);
  mask any = length2 > lanes(0);
  real scale = lanes(1) / sqrt_of(pick(any, length2, lanes(1)));
  cplx ce = complex_of(pick(any, c * scale, lanes(1)), lanes(0)), be = cscale(scale, b);
  mask first = d >= lanes(0);
  out.plus1 = cpick(first, ce, be);
  out.plus2 = cpick(first, conj_of(be), ce);
  return out;
}

FUNCTION void general_section(PRIVATE const WaveMedium* m, vec3 s, PRIVATE SectionWaves* w) {
  vec3 a = any_across(s), b = cross3(s, a);
  vec3 to_a = times_symmetric(m->atil, a), to_b = times_symmetric(m->atil, b);
  real aa = dot3(a, to_a), ab = dot3(a, to_b), bb = dot3(b, to_b);
  real gyration = m->active ? dot3(s, times_symmetric(m->gq, s)) : lanes(0);
  Eigenpair pair = eigenpair_of(aa, bb, complex_of(ab, lanes(0)));
  real radii = lanes(0);
  for (int j = 0; j < 2; ++j) {
    real sign = lanes(j == 0 ? 1 : -1), n = m->n;
    for (int pass = 0; pass < (m->active ? 4 : 1); ++pass) {  // the gyration has the wave's own index
      pair = eigenpair_of(aa, bb, complex_of(ab, n * gyration));
      n = m->n / sqrt_of(lanes(1) + pair.mean + sign * pair.radius);
    }
    cplx e1 = j == 0 ? pair.plus1 : complex_of(-pair.plus2.re, pair.plus2.im);
    cplx e2 = j == 0 ? pair.plus2 : conj_of(pair.plus1);
    w->n[j] = n;
    radii += pair.radius;
    w->d_re[j] = add3(scale3(e1.re, a), scale3(e2.re, b));
    w->d_im[j] = add3(scale3(e1.im, a), scale3(e2.im, b));
  }
  real product = w->n[0] * w->n[1];
  w->gap = radii * product * product / (m->eps * (w->n[0] + w->n[1]));
}

FUNCTION void uniaxial_section(PRIVATE const WaveMedium* m, vec3 s, PRIVATE SectionWaves* w) {
  vec3 across = cross3(s, m->axis), zero = vec(lanes(0), lanes(0), lanes(0));
  real sin2 = dot3(across, across);
  mask tilted = sin2 > lanes(sizeof(scalar) == 8 ? 1e-30f : 2e-13f);
  real scale = lanes(1) / sqrt_of(pick(tilted, sin2, lanes(1)));
  w->d_re[0] = pick3(tilted, scale3(scale, across), any_across(s));
  w->d_re[1] = cross3(w->d_re[0], s);
  w->d_im[0] = w->d_im[1] = zero;
  w->n[0] = m->n;
  real inverse_n2 = lanes(1) / m->eps + m->d_eta * sin2;
  w->n[1] = lanes(1) / sqrt_of(inverse_n2);
  w->gap = -m->d_eta * sin2 * m->eps / (inverse_n2 * (w->n[0] + w->n[1]));
}

// The two waves of m with wave normal s.
FUNCTION SectionWaves waves_of_section(PRIVATE const WaveMedium* m, vec3 s) {
  SectionWaves w;
  if (m->kind == WAVES_GENERAL) {
    general_section(m, s, &w);
  } else if (m->kind == WAVES_UNIAXIAL) {
    uniaxial_section(m, s, &w);
  } else {
    vec3 a = any_across(s), b = cross3(s, a), zero = vec(lanes(0), lanes(0), lanes(0));
    real length = lanes(m->kind == WAVES_CHIRAL ? 0.70710678118654752440 : 1);
    w.d_re[0] = w.d_re[1] = scale3(length, a);
    if (m->kind == WAVES_CHIRAL) {
      w.d_im[0] = scale3(-length, b);
      w.d_im[1] = scale3(length, b);
    } else {
      w.d_re[1] = b;
      w.d_im[0] = w.d_im[1] = zero;
    }
    real kappa = m->kind == WAVES_CHIRAL ? m->kappa : lanes(0);
    w.n[0] = m->n - kappa;
    w.n[1] = m->n + kappa;
    w.gap = lanes(2) * kappa;
  }
  return w;
}

FUNCTION cvec3 cross_complex(vec3 a, PRIVATE const cvec3* b) {
  cvec3 c;
  c.re = cross3(a, b->re);
  c.im = cross3(a, b->im);
  return c;
}

// (v + atil v)/n2bar
FUNCTION vec3 impermeability(PRIVATE const WaveMedium* m, vec3 v) {
  return scale3(lanes(1) / m->eps, add3(v, times_symmetric(m->atil, v)));
}

// E and h, world, of the wave with real wave vector k (world) and D = d_re + i d_im.
FUNCTION void fields_of_wave(PRIVATE const WaveMedium* m, vec3 k, vec3 d_re, vec3 d_im, PRIVATE cvec3* e,
    PRIVATE cvec3* h) {
  if (m->kind == WAVES_ISOTROPIC) {
    e->re = scale3(lanes(1) / m->eps, d_re);
    e->im = scale3(lanes(1) / m->eps, d_im);
  } else if (m->kind == WAVES_CHIRAL) {  // D = n |k| E
    real scale = lanes(1) / (m->n * sqrt_of(dot3(k, k)));
    e->re = scale3(scale, d_re);
    e->im = scale3(scale, d_im);
  } else if (m->kind == WAVES_UNIAXIAL) {
    real inverse = lanes(1) / m->eps;
    e->re = along(m->d_eta * dot3(m->axis, d_re), m->axis, scale3(inverse, d_re));
    e->im = along(m->d_eta * dot3(m->axis, d_im), m->axis, scale3(inverse, d_im));
  } else {
    e->re = impermeability(m, d_re);
    e->im = impermeability(m, d_im);
    if (m->active) {
      real trace = m->zeta[0] + m->zeta[1] + m->zeta[2];
      vec3 g = sub3(scale3(trace, k), times_symmetric(m->zeta, k));
      cvec3 x = cross_complex(g, e);
      e->re = add3(e->re, impermeability(m, x.im));
      e->im = sub3(e->im, impermeability(m, x.re));
    }
  }
  *h = cross_complex(k, e);
  if (m->kind == WAVES_CHIRAL) {
    h->re = along(-m->kappa, e->im, h->re);
    h->im = along(m->kappa, e->re, h->im);
  } else if (m->kind == WAVES_GENERAL && m->active) {
    h->re = sub3(h->re, times_symmetric(m->zeta, e->im));
    h->im = add3(h->im, times_symmetric(m->zeta, e->re));
  }
}

// m.eps - |k|^2 of the wave with real wave vector k and unit D, without subtracting squares: |k|^2 lambda, lambda =
// D*.Lam.D.
// With p1 = k.N: m.eps - q^2 = p1^2 + this.
FUNCTION real bracket_of_wave(PRIVATE const WaveMedium* m, vec3 k, vec3 d_re, vec3 d_im) {
  if (m->kind == WAVES_ISOTROPIC) return lanes(0);
  real k2 = dot3(k, k);
  if (m->kind == WAVES_UNIAXIAL) {
    real re = dot3(m->axis, d_re), im = dot3(m->axis, d_im);
    return k2 * m->eps * m->d_eta * (re * re + im * im);
  }
  real turning = lanes(2) * dot3(cross3(d_re, d_im), k);  // |k| by the handedness: +1 left, -1 right circular
  if (m->kind == WAVES_CHIRAL) {
    real kappa = pick(turning > lanes(0), m->kappa, -m->kappa);
    return -kappa * (lanes(2) * m->n + kappa);
  }
  real lambda = dot3(d_re, times_symmetric(m->atil, d_re)) + dot3(d_im, times_symmetric(m->atil, d_im));
  real bracket = k2 * lambda;
  if (m->active) bracket -= turning * dot3(k, times_symmetric(m->gq, k));
  return bracket;
}

// Direction of the energy flux Re(E x h*), unit.
FUNCTION vec3 ray_of_fields(PRIVATE const cvec3* e, PRIVATE const cvec3* h) {
  return unit3(add3(cross3(e->re, h->re), cross3(e->im, h->im)));
}

#endif
