// `probe`: one face between transparent media, or between isotropic ones that may absorb, by the functions that render.
#ifndef NICOL_PROBE_FACE_H
#define NICOL_PROBE_FACE_H
#include "fresnel.h"
#include "probe_abi.h"
#include "waves.h"

// Axes of the face and the incident wave in them.
typedef struct {
  FaceAxes axes;
  cplx q, p1;
  Mode incident;
} FaceProblem;

FUNCTION cplx read_complex(GLOBAL const scalar* p) { return complex_of(lanes(p[0]), lanes(p[1])); }

FUNCTION cplx read_along(GLOBAL const scalar* p, vec3 axis) {
  return complex_of(lanes(p[0]) * axis.x + lanes(p[2]) * axis.y + lanes(p[4]) * axis.z,
                    lanes(p[1]) * axis.x + lanes(p[3]) * axis.y + lanes(p[5]) * axis.z);
}

FUNCTION void read_tensor(GLOBAL const scalar* in, PRIVATE real* out) {
  for (int i = 0; i < 6; ++i) out[i] = lanes(in[i]);
}

FUNCTION WaveMedium read_medium(GLOBAL const scalar* in) {
  WaveMedium m;
  m.kind = (int)in[PROBE_MEDIUM_KIND];
  m.active = (int)in[PROBE_MEDIUM_ACTIVE];
  m.n = lanes(in[PROBE_MEDIUM_N]);
  m.eps = lanes(in[PROBE_MEDIUM_EPS]);
  m.axis = broadcast(in + PROBE_MEDIUM_AXIS);
  m.eps_e = lanes(in[PROBE_MEDIUM_EPS_E]);
  m.d_eps = lanes(in[PROBE_MEDIUM_D_EPS]);
  m.d_eta = lanes(in[PROBE_MEDIUM_D_ETA]);
  read_tensor(in + PROBE_MEDIUM_ATIL, m.atil);
  read_tensor(in + PROBE_MEDIUM_GQ, m.gq);
  read_tensor(in + PROBE_MEDIUM_ZETA, m.zeta);
  m.kappa = lanes(in[PROBE_MEDIUM_KAPPA]);
  return m;
}

FUNCTION FaceProblem read_problem(GLOBAL const scalar* problem) {
  FaceProblem f;
  vec3 k = vec(lanes(problem[PROBE_K]), lanes(problem[PROBE_K + 2]), lanes(problem[PROBE_K + 4]));
  f.axes = axes_of_face(broadcast(problem + PROBE_NORMAL), k);
  f.q = read_along(problem + PROBE_K, f.axes.t);
  f.p1 = read_along(problem + PROBE_K, f.axes.n);
  vec3 axes[3];
  axes[0] = f.axes.t;
  axes[1] = f.axes.u;
  axes[2] = f.axes.n;
  f.incident.p = f.p1;
  for (int i = 0; i < 3; ++i) {
    f.incident.e[i] = read_along(problem + PROBE_E, axes[i]);
    f.incident.h[i] = read_along(problem + PROBE_H, axes[i]);
  }
  return f;
}

FUNCTION void write_complex(GLOBAL scalar* out, cplx z) {
  store_lanes(z.re, out);
  store_lanes(z.im, out + 1);
}

FUNCTION void write_world(GLOBAL scalar* out, PRIVATE const FaceAxes* f, PRIVATE const cplx* v) {
  vec3 re = add3(add3(scale3(v[0].re, f->t), scale3(v[1].re, f->u)), scale3(v[2].re, f->n));
  vec3 im = add3(add3(scale3(v[0].im, f->t), scale3(v[1].im, f->u)), scale3(v[2].im, f->n));
  write_complex(out, complex_of(re.x, im.x));
  write_complex(out + 2, complex_of(re.y, im.y));
  write_complex(out + 4, complex_of(re.z, im.z));
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
    write_complex(out + ANSWER_WAVE_P, waves[w].p);
    cplx k[3];
    k[0] = f->q;
    k[1] = complex_of(lanes(0), lanes(0));
    k[2] = waves[w].p;
    write_world(out + ANSWER_WAVE_K, &f->axes, k);
    write_world(out + ANSWER_WAVE_E, &f->axes, waves[w].e);
    write_world(out + ANSWER_WAVE_H, &f->axes, waves[w].h);
    store_lanes(power[w], out + ANSWER_WAVE_POWER);
    for (int i = 0; i < 3; ++i) total_e[w / 2][i] = cadd(total_e[w / 2][i], waves[w].e[i]);
  }
  store_lanes(r, answer + ANSWER_R);
  store_lanes(t, answer + ANSWER_T);
  write_world(answer + ANSWER_E_R, &f->axes, total_e[0]);
  write_world(answer + ANSWER_E_T, &f->axes, total_e[1]);
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
  cplx n1 = read_complex(problem + PROBE_MEDIUM1 + PROBE_MEDIUM_INDEX);
  cplx n2 = read_complex(problem + PROBE_MEDIUM2 + PROBE_MEDIUM_INDEX);
  cplx delta = read_complex(problem + PROBE_BRACKET2);
  int absorbs = problem[PROBE_MEDIUM1 + PROBE_MEDIUM_ABSORBS] != 0 || problem[PROBE_MEDIUM2 +
      PROBE_MEDIUM_ABSORBS] != 0;
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
  cplx a_s = f->incident.e[1], a_p = cdiv(f->incident.h[1], n1);
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

FUNCTION void solve_transparent(GLOBAL const scalar* problem, GLOBAL scalar* answer, PRIVATE const FaceProblem* f) {
  WaveMedium medium1 = read_medium(problem + PROBE_MEDIUM1), medium2 = read_medium(problem + PROBE_MEDIUM2);
  real p1 = f->p1.re;
  int known = (int)problem[PROBE_KNOWN], fallbacks = 0;
  mask live = p1 == p1;
  real known_p = known == 1 && medium1.kind == WAVES_UNIAXIAL ? reflected_extraordinary_root(&medium1, &f->axes,
      p1) : -p1;
  WavePair reflected = waves_of_face(&medium1, &f->axes, fma_of(p1, p1, lanes(problem[PROBE_BRACKET1])), 1, known,
      known_p, live, &fallbacks);
  WavePair transmitted = waves_of_face(&medium2, &f->axes, fma_of(p1, p1, lanes(problem[PROBE_BRACKET2])), 0, -1, p1,
      live, &fallbacks);
  cplx amplitude[2][4];
  match_fields(&f->incident, 1, transmitted.mode, reflected.mode, amplitude);
  FaceAmplitudes shared = share_powers(&f->incident, 1, &reflected, &transmitted, amplitude);
  Mode waves[4];
  real power[4];
  for (int w = 0; w < 4; ++w) {
    waves[w] = w < 2 ? reflected.mode[w] : transmitted.mode[w - 2];
    scale_mode(&waves[w], amplitude[0][w < 2 ? w + 2 : w - 2]);
    power[w] = norm2(w < 2 ? shared.r[0][w] : shared.t[0][w - 2]);
  }
  write_answer(answer, f, waves, power, power[0] + power[1], power[2] + power[3]);
  answer[ANSWER_FALLBACKS] = (scalar)fallbacks;
}

#endif
