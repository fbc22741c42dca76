// One face problem answered with the physics that renders: Fresnel's formulas between isotropic media
// (transparent or absorbing), the boundary problem of circular waves where a medium is optically active.
#ifndef NICOL_PROBE_H
#define NICOL_PROBE_H
#include "boundary.h"
#include "interface.h"
#include "probe_abi.h"

// Axes of the face and the incident wave in them.
typedef struct {
  vec3 t, u, n;
  cplx q, p1;
  cplx e[3], h[3];
} FaceProblem;

FUNCTION cplx read_complex(GLOBAL const scalar* p) { return complex_of(lanes(p[0]), lanes(p[1])); }

FUNCTION cplx read_along(GLOBAL const scalar* p, vec3 axis) {
  return complex_of(lanes(p[0]) * axis.x + lanes(p[2]) * axis.y + lanes(p[4]) * axis.z,
                    lanes(p[1]) * axis.x + lanes(p[3]) * axis.y + lanes(p[5]) * axis.z);
}

FUNCTION FaceProblem read_problem(GLOBAL const scalar* problem) {
  FaceProblem f;
  f.n = broadcast(problem + PROBE_NORMAL);
  vec3 k = vec(lanes(problem[PROBE_K]), lanes(problem[PROBE_K + 2]), lanes(problem[PROBE_K + 4]));
  f.u = across_incidence(f.n, k);
  f.t = cross3(f.u, f.n);
  f.q = read_along(problem + PROBE_K, f.t);
  f.p1 = read_along(problem + PROBE_K, f.n);
  vec3 axes[3];
  axes[0] = f.t;
  axes[1] = f.u;
  axes[2] = f.n;
  for (int i = 0; i < 3; ++i) {
    f.e[i] = read_along(problem + PROBE_E, axes[i]);
    f.h[i] = read_along(problem + PROBE_H, axes[i]);
  }
  return f;
}

FUNCTION void write_world(GLOBAL scalar* out, PRIVATE const FaceProblem* f, PRIVATE const cplx* v) {
  vec3 re = add3(add3(scale3(v[0].re, f->t), scale3(v[1].re, f->u)), scale3(v[2].re, f->n));
  vec3 im = add3(add3(scale3(v[0].im, f->t), scale3(v[1].im, f->u)), scale3(v[2].im, f->n));
  store_lanes(re.x, out);
  store_lanes(im.x, out + 1);
  store_lanes(re.y, out + 2);
  store_lanes(im.y, out + 3);
  store_lanes(re.z, out + 4);
  store_lanes(im.z, out + 5);
}

FUNCTION void scale_mode(PRIVATE Mode* m, cplx amplitude) {
  for (int i = 0; i < 3; ++i) {
    m->e[i] = cmul(amplitude, m->e[i]);
    m->h[i] = cmul(amplitude, m->h[i]);
  }
}

// waves: reflected 0, 1, transmitted 0, 1, fields already scaled by their amplitudes.
FUNCTION void write_answer(GLOBAL scalar* answer, PRIVATE const FaceProblem* f, PRIVATE const Mode* waves,
                           PRIVATE const real* power, real r, real t) {
  cplx total_e[2][3];
  for (int i = 0; i < 3; ++i) total_e[0][i] = total_e[1][i] = complex_of(lanes(0), lanes(0));
  for (int w = 0; w < 4; ++w) {
    GLOBAL scalar* out = answer + w * ANSWER_WAVE_SCALARS;
    store_lanes(waves[w].p.re, out + ANSWER_WAVE_P);
    store_lanes(waves[w].p.im, out + ANSWER_WAVE_P + 1);
    cplx k[3];
    k[0] = f->q;
    k[1] = complex_of(lanes(0), lanes(0));
    k[2] = waves[w].p;
    write_world(out + ANSWER_WAVE_K, f, k);
    write_world(out + ANSWER_WAVE_E, f, waves[w].e);
    write_world(out + ANSWER_WAVE_H, f, waves[w].h);
    store_lanes(power[w], out + ANSWER_WAVE_POWER);
    for (int i = 0; i < 3; ++i) total_e[w / 2][i] = cadd(total_e[w / 2][i], waves[w].e[i]);
  }
  store_lanes(r, answer + ANSWER_R);
  store_lanes(t, answer + ANSWER_T);
  write_world(answer + ANSWER_E_R, f, total_e[0]);
  write_world(answer + ANSWER_E_T, f, total_e[1]);
}

// The field of an s or p wave with complex q, p and index: E of amplitude 1.
FUNCTION Mode plane_wave(cplx q, cplx p, cplx n, int is_s) {
  cplx zero = complex_of(lanes(0), lanes(0)), one = complex_of(lanes(1), lanes(0));
  Mode m;
  m.p = p;
  for (int i = 0; i < 3; ++i) m.e[i] = m.h[i] = zero;
  if (is_s) {
    m.e[1] = one;
    m.h[0] = complex_of(-p.re, -p.im);
    m.h[2] = q;
  } else {
    m.h[1] = n;
    m.e[0] = cdiv(p, n);
    m.e[2] = complex_of(lanes(0), lanes(0));
    m.e[2] = csub(m.e[2], cdiv(q, n));
  }
  return m;
}

// Normal flux of the s and p waves of plane_wave: Re p and Re(p n*/n), twice over.
FUNCTION real flux_s(cplx p) { return p.re; }
FUNCTION real flux_p(cplx p, cplx n) { return cmul(p, cdiv(conj_of(n), n)).re; }

FUNCTION void solve_isotropic(GLOBAL const scalar* problem, GLOBAL scalar* answer, PRIVATE const FaceProblem* f) {
  cplx n1 = read_complex(problem + PROBE_N1), n2 = read_complex(problem + PROBE_N2);
  cplx delta = read_complex(problem + PROBE_BRACKETS2);
  int absorbs = problem[PROBE_ABSORBS] != 0;
  cplx r_s, r_p, p2;
  real t_power_s = lanes(0), t_power_p = lanes(0);
  if (absorbs) {
    // the transparent case that this one continues: n2^2 - (Re q)^2, without the extinctions in delta
    real transparent = f->p1.re * f->p1.re + delta.re + (n2.im * n2.im - n1.im * n1.im);
    mask evanescent = transparent <= lanes(0);
    FresnelAbsorbing g = fresnel_absorbing(f->p1, delta, cmul(n1, n1), cmul(n2, n2), evanescent);
    r_s = g.r_s;
    r_p = g.r_p;
    p2 = g.p2;
  } else {
    Fresnel g = fresnel(f->p1.re, delta.re, n1.re * n1.re);
    r_s = g.r_s;
    r_p = g.r_p;
    t_power_s = g.t_s * g.t_s;
    t_power_p = g.t_p * g.t_p;
    real p2_squared = f->p1.re * f->p1.re + delta.re;
    p2 = complex_of(g.p2, pick(g.total, sqrt_of(abs_of(p2_squared)), lanes(0)));
  }
  cplx one = complex_of(lanes(1), lanes(0));
  cplx a_s = f->e[1], a_p = cdiv(f->h[1], n1);
  cplx back = complex_of(-f->p1.re, -f->p1.im);
  Mode waves[4];
  waves[0] = plane_wave(f->q, back, n1, 1);
  waves[1] = plane_wave(f->q, back, n1, 0);
  waves[2] = plane_wave(f->q, p2, n2, 1);
  waves[3] = plane_wave(f->q, p2, n2, 0);
  scale_mode(&waves[0], cmul(r_s, a_s));
  scale_mode(&waves[1], cmul(r_p, a_p));
  // continuity: E_u = 1 + r_s, h_u = n1 (1 + r_p)
  scale_mode(&waves[2], cmul(cadd(one, r_s), a_s));
  scale_mode(&waves[3], cmul(cmul(cadd(one, r_p), a_p), cdiv(n1, n2)));
  // s and p light carry their energy apart; |a|^2 times the flux of a unit wave keeps its digits at grazing
  real share_s = norm2(a_s) * flux_s(f->p1), share_p = norm2(a_p) * flux_p(f->p1, n1), all = share_s + share_p;
  real power[4];
  power[0] = norm2(r_s) * share_s / all;
  power[1] = norm2(r_p) * share_p / all;
  if (absorbs) {
    power[2] = norm2(cmul(cadd(one, r_s), a_s)) * flux_s(p2) / all;
    power[3] = norm2(cmul(cmul(cadd(one, r_p), a_p), cdiv(n1, n2))) * flux_p(p2, n2) / all;
  } else {
    power[2] = t_power_s * share_s / all;
    power[3] = t_power_p * share_p / all;
  }
  write_answer(answer, f, waves, power, power[0] + power[1], power[2] + power[3]);
}

// The two waves of a medium going forward (direction +1) or back (-1) from the face.
FUNCTION void medium_modes(int chiral, real q, cplx p_right, cplx p_left, real n, real kappa, int backward, PRIVATE Mode* out) {
  if (chiral) {
    out[0] = circular_mode(q, p_right, n, kappa, lanes(-1));
    out[1] = circular_mode(q, p_left, n, kappa, lanes(1));
  } else {
    out[0] = s_mode(q, p_right);
    out[1] = p_mode(q, p_left, n);
  }
  if (!backward) return;
  out[0] = turned_back(out[0]);
  out[1] = turned_back(out[1]);
}

FUNCTION cplx root_from(real p1, GLOBAL const scalar* bracket) {
  real squared = p1 * p1 + lanes(bracket[0]);
  return forward_root(complex_of(squared, lanes(0)), squared <= lanes(0));
}

FUNCTION void solve_active(GLOBAL const scalar* problem, GLOBAL scalar* answer, PRIVATE const FaceProblem* f) {
  real p1 = f->p1.re;
  Mode reflected[2], transmitted[2];
  medium_modes(problem[PROBE_CLASS1] == PROBE_CHIRAL, f->q.re, root_from(p1, problem + PROBE_BRACKETS1),
               root_from(p1, problem + PROBE_BRACKETS1 + 2), lanes(problem[PROBE_N1]), lanes(problem[PROBE_KAPPA1]), 1, reflected);
  medium_modes(problem[PROBE_CLASS2] == PROBE_CHIRAL, f->q.re, root_from(p1, problem + PROBE_BRACKETS2),
               root_from(p1, problem + PROBE_BRACKETS2 + 2), lanes(problem[PROBE_N2]), lanes(problem[PROBE_KAPPA2]), 0, transmitted);
  cplx amplitude[2][4];
  Mode in;
  for (int i = 0; i < 3; ++i) {
    in.e[i] = f->e[i];
    in.h[i] = f->h[i];
  }
  match_fields(&in, 1, transmitted, reflected, amplitude);
  Mode waves[4];
  real power[4], incident = flux_of(f->e, f->h);
  cplx sum_e[3], sum_h[3];
  for (int i = 0; i < 3; ++i) sum_e[i] = sum_h[i] = complex_of(lanes(0), lanes(0));
  for (int w = 0; w < 4; ++w) {
    waves[w] = w < 2 ? reflected[w] : transmitted[w - 2];
    scale_mode(&waves[w], amplitude[0][w < 2 ? w + 2 : w - 2]);
    real share = (w < 2 ? lanes(-1) : lanes(1)) * flux_of(waves[w].e, waves[w].h) / incident;
    power[w] = pick(share > lanes(0), share, lanes(0));
    for (int i = 0; i < 3 && w >= 2; ++i) {
      sum_e[i] = cadd(sum_e[i], waves[w].e[i]);
      sum_h[i] = cadd(sum_h[i], waves[w].h[i]);
    }
  }
  // lossless media: T from the transmitted field, R = 1 - T, shared out as the single waves say
  real t = flux_of(sum_e, sum_h) / incident;
  t = pick(t > lanes(0), pick(t < lanes(1), t, lanes(1)), lanes(0));
  real t_sum = power[2] + power[3], r_sum = power[0] + power[1];
  real t_scale = t / pick(t_sum > lanes(0), t_sum, lanes(1)), r_scale = (lanes(1) - t) / pick(r_sum > lanes(0), r_sum, lanes(1));
  for (int w = 0; w < 4; ++w) power[w] = power[w] * (w < 2 ? r_scale : t_scale);
  write_answer(answer, f, waves, power, lanes(1) - t, t);
}

FUNCTION void solve_face(GLOBAL const scalar* problem, GLOBAL scalar* answer) {
  FaceProblem f = read_problem(problem);
  if (problem[PROBE_CLASS1] == PROBE_CHIRAL || problem[PROBE_CLASS2] == PROBE_CHIRAL) {
    solve_active(problem, answer, &f);
  } else {
    solve_isotropic(problem, answer, &f);
  }
}

#endif
