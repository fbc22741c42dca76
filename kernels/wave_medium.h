// A medium as its plane waves need it, the axes of a face, and the waves that leave the face. Constants are
// prepared in double on the host; D = eps E + i zeta h, B = h - i zeta E (Condon 1937), zeta symmetric.
#ifndef NICOL_WAVE_MEDIUM_H
#define NICOL_WAVE_MEDIUM_H
#include "modes.h"
#include "waves_kinds.h"

typedef struct {
  int kind, active;
  // isotropic, chiral: n and n^2; uniaxial: n_o and n_o^2; general: n2bar = 3/tr(eta) and its root
  real n, eps;
  vec3 axis;                 // uniaxial: optic axis, world, unit
  real eps_e, d_eps, d_eta;  // uniaxial: n_e^2, n_e^2 - n_o^2, 1/n_e^2 - 1/n_o^2
  // general, world axes, order xx yy zz yz zx xy: n2bar eta - I; n2bar det(eta) sym(eps (tr zeta - zeta)); zeta.
  // The last two only where active.
  real atil[6], gq[6], zeta[6];
  real kappa;                // chiral
} WaveMedium;

// (t, u, n) right-handed and orthonormal, n from medium 1 to medium 2; the tangential wave vector is q t, q >= 0.
typedef struct {
  vec3 t, u, n;
  real q;
} FaceAxes;

// mode 0: s, ordinary, fast or right circular; mode 1: p, extraordinary, slow or left circular.
// gap = Re(p[1] - p[0]) by formulas that do not subtract roots; 0 where either wave is evanescent.
typedef struct {
  Mode mode[2];
  real gap;
} WavePair;

// a with (a, b, s) right-handed, orthonormal to rounding (Duff et al., JCGT 6(1) 2017).
FUNCTION vec3 any_across(vec3 s) {
  real sign = pick(s.z >= lanes(0), lanes(1), lanes(-1));
  real a = lanes(-1) / (sign + s.z);
  return vec(lanes(1) + sign * s.x * s.x * a, sign * s.x * s.y * a, -sign * s.x);
}

// Axes of a face for the real wave vector k: a basis of n turned, never k - (k.n) n made unit, which fails at normal
// incidence.
FUNCTION FaceAxes axes_of_face(vec3 n, vec3 k) {
  vec3 t0 = any_across(n), u0 = cross3(n, t0);
  real a = dot3(k, t0), b = dot3(k, u0);
  FaceAxes f;
  f.n = n;
  f.q = sqrt_of(a * a + b * b);
  mask tilted = f.q > lanes(0);
  real inverse = lanes(1) / pick(tilted, f.q, lanes(1));
  real c = pick(tilted, a * inverse, lanes(1)), s = pick(tilted, b * inverse, lanes(0));
  f.t = add3(scale3(c, t0), scale3(s, u0));
  f.u = sub3(scale3(c, u0), scale3(s, t0));
  return f;
}

// A symmetric tensor in the axes of a face; mirrored: in (t, -u, -n), where backward waves run forward.
typedef struct { real tt, uu, nn, un, tn, ut; } FaceTensor;

FUNCTION vec3 times_symmetric(PRIVATE const real* m, vec3 v) {
  return vec(m[0] * v.x + m[5] * v.y + m[4] * v.z, m[5] * v.x + m[1] * v.y + m[3] * v.z,
             m[4] * v.x + m[3] * v.y + m[2] * v.z);
}

FUNCTION FaceTensor on_face(PRIVATE const real* tensor, PRIVATE const FaceAxes* f, int mirrored) {
  vec3 to_t = times_symmetric(tensor, f->t), to_u = times_symmetric(tensor, f->u), to_n = times_symmetric(tensor, f->n);
  real turn = lanes(mirrored ? -1 : 1);
  FaceTensor a;
  a.tt = dot3(f->t, to_t);
  a.uu = dot3(f->u, to_u);
  a.nn = dot3(f->n, to_n);
  a.un = dot3(f->u, to_n);
  a.tn = turn * dot3(f->t, to_n);
  a.ut = turn * dot3(f->u, to_t);
  return a;
}

// a where keep holds, b elsewhere.
FUNCTION Mode pick_mode(mask keep, Mode a, Mode b) {
  a.p = cpick(keep, a.p, b.p);
  for (int i = 0; i < 3; ++i) {
    a.e[i] = cpick(keep, a.e[i], b.e[i]);
    a.h[i] = cpick(keep, a.h[i], b.h[i]);
  }
  return a;
}

#endif
