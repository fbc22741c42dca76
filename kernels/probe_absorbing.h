// `probe`: faces and bulk of absorbing crystals, exact: the eigenproblem of precise_waves.h with complex eps. Where
// the incident medium absorbs, q is complex, and which waves run away is settled at Re q and followed from there:
// neither the sign of Im p nor that of Re p tells (a wave that runs on in a transparent medium 2 has Im p < 0 then).
#ifndef NICOL_PROBE_ABSORBING_H
#define NICOL_PROBE_ABSORBING_H
#include "probe_face.h"

FUNCTION precise component(GLOBAL const scalar* tensor, int stride, precise a[3], precise b[3]) {
  const int row[6] = {0, 1, 2, 1, 2, 0}, column[6] = {0, 1, 2, 2, 0, 1};
  precise sum = 0;
  for (int i = 0; i < 6; ++i) {
    int r = row[i], c = column[i];
    sum += (precise)tensor[i * stride] * (r == c ? a[r] * b[c] : a[r] * b[c] + a[c] * b[r]);
  }
  return sum;
}

FUNCTION void precise_axis(vec3 v, precise out[3]) {
  scalar x[LANES], y[LANES], z[LANES];
  store_lanes(v.x, x);
  store_lanes(v.y, y);
  store_lanes(v.z, z);
  out[0] = (precise)x[0];
  out[1] = (precise)y[0];
  out[2] = (precise)z[0];
}

FUNCTION PreciseMedium read_precise(GLOBAL const scalar* in, PRIVATE const FaceAxes* f) {
  PreciseMedium m;
  precise axis[3][3];
  precise_axis(f->t, axis[0]);
  precise_axis(f->u, axis[1]);
  precise_axis(f->n, axis[2]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      GLOBAL const scalar* eps = in + PROBE_MEDIUM_TENSOR;
      m.eps[i][j] = pc(component(eps, 2, axis[i], axis[j]), component(eps + 1, 2, axis[i], axis[j]));
      m.zeta[i][j] = component(in + PROBE_MEDIUM_ZETA, 1, axis[i], axis[j]);
    }
  return m;
}

// The four waves with complex q, in the order of those with its real part: of all 24 ways the one with the least
// change of p.
FUNCTION void followed_waves(PRIVATE const PreciseMedium* m, pcplx q, int lossless, PreciseWave wave[4]) {
  if (q.im == 0) {
    precise_waves(m, q, lossless, wave);
    return;
  }
  PreciseWave before[4], after[4];
  precise_waves(m, pc(q.re, 0), lossless, before);
  precise_waves(m, q, 0, after);
  precise least = -1;
  for (int way = 0; way < 256; ++way) {
    int to[4], seen = 0;
    precise change = 0;
    for (int i = 0; i < 4; ++i) {
      to[i] = way >> (2 * i) & 3;
      seen |= 1 << to[i];
      change += precise_sqrt(pc_norm2(pc_sub(after[to[i]].p, before[i].p)));
    }
    if (seen != 15 || (least >= 0 && change >= least)) continue;
    least = change;
    for (int i = 0; i < 4; ++i) wave[i] = after[to[i]];
  }
}

FUNCTION cplx rounded(pcplx z) { return complex_of(lanes(z.re), lanes(z.im)); }

FUNCTION Mode rounded_mode(PRIVATE const PreciseWave* w) {
  Mode m;
  m.p = rounded(w->p);
  m.e[0] = rounded(w->psi[0]);
  m.e[1] = rounded(w->psi[1]);
  m.e[2] = rounded(w->e_n);
  m.h[0] = rounded(w->psi[2]);
  m.h[1] = rounded(w->psi[3]);
  m.h[2] = rounded(w->h_n);
  return m;
}

// Isotropic and uniaxial media in closed form (uniaxial.h with complex eps): it keeps the digits of p at grazing, as
// a wave of known root. transparent: p_o^2 for real q and real indices, whose continuation the branch is.
typedef struct {
  cplx eps_o, eps_e, q, p1, p2_o;
  real transparent, n_o2, n_e2;
  vec3 axis;
} AbsorbingUniaxial;

FUNCTION AbsorbingUniaxial read_uniaxial(GLOBAL const scalar* problem, GLOBAL const scalar* in, cplx bracket,
    PRIVATE const FaceProblem* f) {
  AbsorbingUniaxial m;
  int isotropic = in[PROBE_MEDIUM_KIND] == WAVES_ISOTROPIC;
  cplx n_o = read_complex(in + PROBE_MEDIUM_INDEX), n_e = read_complex(in + (isotropic ? PROBE_MEDIUM_INDEX : PROBE_MEDIUM_INDEX_E));
  m.eps_o = cmul(n_o, n_o);
  m.eps_e = cmul(n_e, n_e);
  m.n_o2 = n_o.re * n_o.re;
  m.n_e2 = n_e.re * n_e.re;
  m.q = f->q;
  m.p1 = f->p1;
  m.p2_o = cadd(cmul(f->p1, f->p1), bracket);
  real k_im2 = lanes(0);
  for (int i = 0; i < 3; ++i) k_im2 += lanes(problem[PROBE_K + 2 * i + 1]) * lanes(problem[PROBE_K + 2 * i + 1]);
  m.transparent = f->p1.re * f->p1.re + bracket.re + n_o.im * n_o.im - k_im2;
  m.axis = isotropic ? f->axes.n : broadcast(in + PROBE_MEDIUM_AXIS);
  return m;
}

// The o or e wave with root p (forward axes).
FUNCTION Mode absorbing_mode(PRIVATE const AbsorbingUniaxial* m, cplx p, real ct, real cu, real cn, int is_e) {
  cplx q = m->q, k2 = cadd(cmul(p, p), cmul(q, q)), middle = csub(cscale(ct, p), cscale(cn, q));
  real length2 = (norm2(p) + norm2(q)) * cu * cu + norm2(middle);
  mask along_axis = length2 < lanes(sizeof(scalar) == 8 ? 1e-30f : 2e-13f) * (norm2(p) + norm2(q));
  real scale = pick(along_axis, lanes(0), lanes(1) / sqrt_of(pick(along_axis, lanes(1), length2))), g = cu * scale;
  cplx w[3], x[3];  // w and k x w
  w[0] = cscale(-g, p);
  w[1] = complex_of(pick(along_axis, lanes(1), scale * middle.re), scale * middle.im);
  w[2] = cscale(g, q);
  x[0] = cmul(complex_of(-p.re, -p.im), w[1]);
  x[1] = cscale(-g, is_e ? k2 : m->eps_o);
  x[2] = cmul(q, w[1]);
  Mode out;
  out.p = p;
  for (int i = 0; i < 3; ++i) {
    out.e[i] = w[i];
    out.h[i] = x[i];
  }
  if (!is_e) return out;
  cplx along_c = cadd(cscale(ct, x[0]), cadd(cscale(cu, x[1]), cscale(cn, x[2])));
  cplx difference = csub(cdiv(along_c, m->eps_e), cdiv(along_c, m->eps_o));
  for (int i = 0; i < 3; ++i) {
    real c = i == 0 ? ct : i == 1 ? cu : cn;
    cplx e = cadd(cdiv(x[i], m->eps_o), cscale(c, difference));
    out.e[i] = complex_of(-e.re, -e.im);
    out.h[i] = w[i];
  }
  return out;
}

// The two waves to +N or back, in (t, u, N). known: see waves.h; the incident wave's own root is -p1 or its partner.
FUNCTION void absorbing_uniaxial_waves(PRIVATE const AbsorbingUniaxial* m, PRIVATE const FaceAxes* f, int backward,
    int known, PRIVATE Mode* out) {
  real turn = lanes(backward ? -1 : 1);
  real ct = dot3(m->axis, f->t), cu = turn * dot3(m->axis, f->u), cn = turn * dot3(m->axis, f->n), cn2 = cn * cn,
      cu2 = cu * cu;
  cplx d_eps = csub(m->eps_e, m->eps_o), p_o = forward_root(m->p2_o, m->transparent <= lanes(0));
  cplx a = cadd(m->eps_o, cscale(cn2, d_eps)), b = cscale(cn * ct, cmul(d_eps, m->q));
  cplx rest = cmul(d_eps, cadd(cscale(cn2, m->eps_e), cscale(cu2, m->eps_o)));
  cplx disc = cmul(m->eps_o, cadd(rest, cmul(m->p2_o, csub(m->eps_e, cscale(cu2, d_eps)))));
  real d_real = m->n_e2 - m->n_o2;
  real disc_real = d_real * (m->n_e2 * cn2 + m->n_o2 * cu2) + m->transparent * (m->n_e2 - d_real * cu2);
  cplx p_e = cdiv(csub(forward_root(disc, disc_real <= lanes(0)), b), a);
  if (known == 0 || known == 2) p_o = m->p1;
  if (known == 2) p_e = m->p1;
  if (known == 1) {
    cplx partner = cscale(lanes(2), cdiv(b, a));
    p_e = backward ? csub(m->p1, partner) : m->p1;
  }
  out[0] = absorbing_mode(m, p_o, ct, cu, cn, 0);
  out[1] = absorbing_mode(m, p_e, ct, cu, cn, 1);
  for (int i = 0; i < 2 && backward; ++i) out[i] = turned_back(out[i]);
}

// sum of a* b over E and h
FUNCTION cplx inner_of_modes(PRIVATE const Mode* a, PRIVATE const Mode* b) {
  cplx sum = complex_of(lanes(0), lanes(0));
  for (int i = 0; i < 3; ++i) sum = cadd(sum, cadd(cmul(conj_of(a->e[i]), b->e[i]), cmul(conj_of(a->h[i]), b->h[i])));
  return sum;
}

// The incident field as a multiple of the wave it is: its flux then keeps its digits at grazing.
FUNCTION Mode incident_from(PRIVATE const Mode* wave, PRIVATE const Mode* given) {
  Mode m = *wave;
  scale_mode(&m, cscale(lanes(1) / inner_of_modes(wave, wave).re, inner_of_modes(wave, given)));
  return m;
}

FUNCTION int in_closed_form(GLOBAL const scalar* medium) {
  return medium[PROBE_MEDIUM_KIND] == WAVES_ISOTROPIC || medium[PROBE_MEDIUM_KIND] == WAVES_UNIAXIAL;
}

FUNCTION void solve_absorbing(GLOBAL const scalar* problem, GLOBAL scalar* answer, PRIVATE const FaceProblem* f) {
  precise t[3], q[2];
  precise_axis(f->axes.t, t);
  for (int part = 0; part < 2; ++part) {
    q[part] = 0;
    for (int i = 0; i < 3; ++i) q[part] += (precise)problem[PROBE_K + 2 * i + part] * t[i];
  }
  Mode side[2][2], waves[4], given = f->incident;
  for (int i = 0; i < 2; ++i) {
    GLOBAL const scalar* in = problem + (i == 0 ? PROBE_MEDIUM1 : PROBE_MEDIUM2);
    if (in_closed_form(in)) {
      AbsorbingUniaxial u = read_uniaxial(problem, in, read_complex(problem + (i == 0 ? PROBE_BRACKET1 : PROBE_BRACKET2)), f);
      int known = i == 0 ? (int)problem[PROBE_KNOWN] : -1;
      absorbing_uniaxial_waves(&u, &f->axes, i == 0, known, side[i]);
      if (i == 0 && known != 2) {
        Mode forward[2];
        absorbing_uniaxial_waves(&u, &f->axes, 0, known, forward);
        given = incident_from(&forward[known], &f->incident);
      }
      continue;
    }
    PreciseMedium m = read_precise(in, &f->axes);
    PreciseWave all[4];
    followed_waves(&m, pc(q[0], q[1]), in[PROBE_MEDIUM_ABSORBS] == 0, all);
    for (int j = 0; j < 2; ++j) side[i][j] = rounded_mode(&all[i == 0 ? 2 + j : j]);
  }
  cplx amplitude[2][4];
  match_fields(&given, 1, side[1], side[0], amplitude);
  real power[4], incident = flux_of(given.e, given.h), total[2];
  for (int i = 0; i < 2; ++i) {
    Mode sum;
    for (int c = 0; c < 3; ++c) sum.e[c] = sum.h[c] = complex_of(lanes(0), lanes(0));
    for (int j = 0; j < 2; ++j) {
      PRIVATE Mode* w = &waves[2 * i + j];
      *w = side[i][j];
      scale_mode(w, amplitude[0][i == 0 ? 2 + j : j]);
      power[2 * i + j] = pick(w->p.im != lanes(0) && q[1] == 0 && problem[(i == 0 ? PROBE_MEDIUM1 : PROBE_MEDIUM2) +
          PROBE_MEDIUM_ABSORBS] == 0,
                              lanes(0), lanes(i == 0 ? -1 : 1) * flux_of(w->e, w->h) / incident);
      for (int c = 0; c < 3; ++c) {
        sum.e[c] = cadd(sum.e[c], w->e[c]);
        sum.h[c] = cadd(sum.h[c], w->h[c]);
      }
    }
    total[i] = lanes(i == 0 ? -1 : 1) * flux_of(sum.e, sum.h) / incident;
  }
  write_answer(answer, f, waves, power, total[0], total[1]);
}

#endif
