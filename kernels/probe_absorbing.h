// `probe`: faces and bulk of absorbing crystals, exact: the eigenproblem of precise_waves.h with complex eps. Where the incident
// medium absorbs, q is complex, and which waves run away is settled at Re q and followed from there: neither the sign of Im p
// nor that of Re p tells (a wave that runs on in a transparent medium 2 has Im p < 0 then).
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

// The four waves with complex q, in the order of those with its real part: of all 24 ways the one with the least change of p.
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

FUNCTION void solve_absorbing(GLOBAL const scalar* problem, GLOBAL scalar* answer, PRIVATE const FaceProblem* f) {
  precise t[3], q[2];
  precise_axis(f->axes.t, t);
  for (int part = 0; part < 2; ++part) {
    q[part] = 0;
    for (int i = 0; i < 3; ++i) q[part] += (precise)problem[PROBE_K + 2 * i + part] * t[i];
  }
  Mode side[2][2], waves[4];
  for (int i = 0; i < 2; ++i) {
    GLOBAL const scalar* in = problem + (i == 0 ? PROBE_MEDIUM1 : PROBE_MEDIUM2);
    PreciseMedium m = read_precise(in, &f->axes);
    PreciseWave all[4];
    followed_waves(&m, pc(q[0], q[1]), in[PROBE_MEDIUM_ABSORBS] == 0, all);
    for (int j = 0; j < 2; ++j) side[i][j] = rounded_mode(&all[i == 0 ? 2 + j : j]);
  }
  cplx amplitude[2][4];
  match_fields(&f->incident, 1, side[1], side[0], amplitude);
  real power[4], incident = flux_of(f->incident.e, f->incident.h), total[2];
  for (int i = 0; i < 2; ++i) {
    Mode sum;
    for (int c = 0; c < 3; ++c) sum.e[c] = sum.h[c] = complex_of(lanes(0), lanes(0));
    for (int j = 0; j < 2; ++j) {
      PRIVATE Mode* w = &waves[2 * i + j];
      *w = side[i][j];
      scale_mode(w, amplitude[0][i == 0 ? 2 + j : j]);
      power[2 * i + j] = pick(w->p.im != lanes(0) && q[1] == 0 && problem[(i == 0 ? PROBE_MEDIUM1 : PROBE_MEDIUM2) + PROBE_MEDIUM_ABSORBS] == 0,
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
