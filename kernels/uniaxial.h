// Plane waves of isotropic, chiral and uniaxial media that leave a face, in closed form.
//
// Forward waves, wave vector (q, 0, p) in (t, u, N). Isotropic: p^2 = n^2 - q^2. Chiral: p^2 = (n -+ kappa)^2 - q^2.
// Uniaxial, axis c, De = eps_e - eps_o (Yariv & Yeh, Optical Waves in Crystals, 1984, ch. 4):
//   p_o^2 = eps_o - q^2;  A p^2 + 2 B p + C = 0,  A = eps_o + De c_N^2,  B = De c_N c_t q,  p_e = (sqrt(disc) - B)/A,
//   disc = B^2 - A C = eps_o [De (eps_e c_N^2 + eps_o c_u^2) + p_o^2 (eps_e - De c_u^2)]     (eps_o - q^2 = p_o^2 put
//   in)
//   o: E = w, h = k x w;  e: h = w, D = -k x w, E = D/eps_o + (1/eps_e - 1/eps_o)(c.D) c;  w = k x c / |k x c|, own k
//   p_e - p_o = De |k_e x c|^2 / (eps_e (p_e + p_o))
// p^2 < 0: evanescent, p = i sqrt. p_o^2 comes in, without cancellation. Valid for any birefringence, lossless.
// Test: tests/kernels/vectors_test.cpp, waves_test.cpp.
#ifndef NICOL_UNIAXIAL_H
#define NICOL_UNIAXIAL_H
#include "wave_medium.h"

// sqrt(squared), i sqrt(-squared) where that is negative.
FUNCTION cplx root_of_real(real squared) {
  real root = sqrt_of(abs_of(squared));
  mask runs = squared > lanes(0);
  return complex_of(pick(runs, root, lanes(0)), pick(runs, lanes(0), root));
}

FUNCTION WavePair isotropic_waves(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p2, int backward,
    int known,
                                  real known_p) {
  cplx p = root_of_real(p2);
  if (backward) p = complex_of(-p.re, -p.im);
  if (known >= 0) p = complex_of(known_p, lanes(0));
  WavePair w;
  w.mode[0] = s_mode(f->q, p);
  w.mode[1] = p_mode(f->q, p, m->n);
  w.gap = lanes(0);
  return w;
}

FUNCTION WavePair chiral_waves(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p2, int backward, int known,
                               real known_p) {
  real forward_p = backward ? -known_p : known_p;
  cplx right = root_of_real(p2 - m->kappa * (lanes(2) * m->n - m->kappa));
  cplx left = root_of_real(p2 + m->kappa * (lanes(2) * m->n + m->kappa));
  if (known == 0) right = complex_of(forward_p, lanes(0));
  if (known == 1) left = complex_of(forward_p, lanes(0));
  WavePair w;
  w.mode[0] = circular_mode(f->q, right, m->n, m->kappa, lanes(-1));
  w.mode[1] = circular_mode(f->q, left, m->n, m->kappa, lanes(1));
  mask both = (right.re > lanes(0)) & (left.re > lanes(0));
  w.gap = pick(both, lanes(4) * m->n * m->kappa / pick(both, left.re + right.re, lanes(1)), lanes(0));
  if (!backward) return w;
  w.mode[0] = turned_back(w.mode[0]);
  w.mode[1] = turned_back(w.mode[1]);
  w.gap = -w.gap;
  return w;
}

// w = k x c / |k x c| in (t, u, N), g = w_N/q; where k lies along the axis any w across k will do: u.
typedef struct {
  cplx w[3], g;
  real length2;  // |k x c|^2
} Across;

FUNCTION Across across_axis(real q, cplx p, real ct, real cu, real cn) {
  Across a;
  cplx middle = complex_of(p.re * ct - q * cn, p.im * ct);
  real cu_part = cu * cu;
  a.length2 = (norm2(p) + q * q) * cu_part + norm2(middle);
  mask along_axis = a.length2 < lanes(sizeof(scalar) == 8 ? 1e-30f : 2e-13f) * (norm2(p) + q * q);
  real scale = pick(along_axis, lanes(0), lanes(1) / sqrt_of(pick(along_axis, lanes(1), a.length2)));
  real g = cu * scale;
  a.g = complex_of(g, lanes(0));
  a.w[0] = complex_of(-p.re * g, -p.im * g);
  a.w[1] = complex_of(pick(along_axis, lanes(1), middle.re * scale), middle.im * scale);
  a.w[2] = complex_of(q * g, lanes(0));
  return a;
}

// k x w has the middle component p w_t - q w_N = -k^2 g: written so, it does not cancel.
FUNCTION Mode ordinary_mode(real q, cplx p, PRIVATE const Across* a, real eps_o) {
  Mode m;
  m.p = p;
  for (int i = 0; i < 3; ++i) m.e[i] = a->w[i];
  m.h[0] = cmul(complex_of(-p.re, -p.im), a->w[1]);
  m.h[1] = cscale(-eps_o, a->g);
  m.h[2] = cscale(q, a->w[1]);
  return m;
}

FUNCTION Mode extraordinary_mode(real q, cplx p, PRIVATE const Across* a, real ct, real cu, real cn, real eps_o,
    real d_eta) {
  Mode m;
  m.p = p;
  cplx k2 = cmul(p, p);
  k2.re += q * q;
  cplx d[3];
  d[0] = cmul(p, a->w[1]);
  d[1] = cmul(k2, a->g);
  d[2] = cscale(-q, a->w[1]);
  cplx along_c = cscale(d_eta, cadd(cscale(ct, d[0]), cadd(cscale(cu, d[1]), cscale(cn, d[2]))));
  real inverse = lanes(1) / eps_o;
  m.e[0] = cadd(cscale(inverse, d[0]), cscale(ct, along_c));
  m.e[1] = cadd(cscale(inverse, d[1]), cscale(cu, along_c));
  m.e[2] = cadd(cscale(inverse, d[2]), cscale(cn, along_c));
  for (int i = 0; i < 3; ++i) m.h[i] = a->w[i];
  return m;
}

// N component of the wave vector of the reflected e wave, from that of the incident one, p1: the two roots of the
// quadratic sum to -2 B/A.
FUNCTION real reflected_extraordinary_root(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p1) {
  real ct = dot3(m->axis, f->t), cn = dot3(m->axis, f->n);
  return -lanes(2) * m->d_eps * cn * ct * f->q / (m->eps + m->d_eps * cn * cn) - p1;
}

FUNCTION WavePair uniaxial_waves(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p2_o, int backward,
    int known,
                                 real known_p) {
  real turn = lanes(backward ? -1 : 1), q = f->q;
  real ct = dot3(m->axis, f->t), cu = turn * dot3(m->axis, f->u), cn = turn * dot3(m->axis, f->n);
  // roots
  cplx p_o = root_of_real(p2_o);
  real a = m->eps + m->d_eps * cn * cn, b = m->d_eps * cn * ct * q, cu2 = cu * cu;
  real disc = m->eps * (m->d_eps * (m->eps_e * cn * cn + m->eps * cu2) + p2_o * (m->eps_e - m->d_eps * cu2));
  cplx p_e = root_of_real(disc);
  real inverse = lanes(1) / a;
  p_e = complex_of((p_e.re - b) * inverse, p_e.im * inverse);
  if (known == 0) p_o = complex_of(turn * known_p, lanes(0));
  if (known == 1) p_e = complex_of(turn * known_p, lanes(0));
  // fields
  Across across_o = across_axis(q, p_o, ct, cu, cn), across_e = across_axis(q, p_e, ct, cu, cn);
  WavePair w;
  w.mode[0] = ordinary_mode(q, p_o, &across_o, m->eps);
  w.mode[1] = extraordinary_mode(q, p_e, &across_e, ct, cu, cn, m->eps, m->d_eta);
  // difference of the roots
  real sum = p_e.re + p_o.re, plain = p_e.re - p_o.re;
  mask formula = sum > abs_of(plain);
  real gap = pick(formula, m->d_eps * across_e.length2 / (m->eps_e * pick(formula, sum, lanes(1))), plain);
  w.gap = pick((p_o.im == lanes(0)) & (p_e.im == lanes(0)), turn * gap, lanes(0));
  if (!backward) return w;
  w.mode[0] = turned_back(w.mode[0]);
  w.mode[1] = turned_back(w.mode[1]);
  return w;
}

#endif
