// `probe` (one lane): the two waves with a given wave normal, and a field carried along it. Transparent media by
// section.h, which launches rays; absorbing ones exactly (precise_waves.h at q = 0).
#ifndef NICOL_PROBE_BULK_H
#define NICOL_PROBE_BULK_H
#include "optical_rotation.h"
#include "probe_absorbing.h"

// E, h and D of a wave, world.
typedef struct {
  cplx n;
  cvec3 e, h, d;
} BulkWave;

FUNCTION cvec3 in_world(PRIVATE const FaceAxes* f, PRIVATE const cplx* v) {
  cvec3 w;
  w.re = add3(add3(scale3(v[0].re, f->t), scale3(v[1].re, f->u)), scale3(v[2].re, f->n));
  w.im = add3(add3(scale3(v[0].im, f->t), scale3(v[1].im, f->u)), scale3(v[2].im, f->n));
  return w;
}

FUNCTION cvec3 scale_complex3(real s, cvec3 v) {
  v.re = scale3(s, v.re);
  v.im = scale3(s, v.im);
  return v;
}

// gap: n[1] - n[0].
FUNCTION void transparent_waves(GLOBAL const scalar* medium, vec3 s, PRIVATE BulkWave* w, PRIVATE cplx* gap) {
  WaveMedium m = read_medium(medium);
  SectionWaves section = waves_of_section(&m, s);
  for (int j = 0; j < 2; ++j) {
    w[j].n = complex_of(section.n[j], lanes(0));
    fields_of_wave(&m, scale3(section.n[j], s), section.d_re[j], section.d_im[j], &w[j].e, &w[j].h);
    w[j].d = scale_complex3(-section.n[j], cross_complex(s, &w[j].h));
  }
  *gap = complex_of(section.gap, lanes(0));
}

// D = -k x h
FUNCTION void absorbing_waves(GLOBAL const scalar* medium, vec3 s, PRIVATE BulkWave* w, PRIVATE cplx* gap) {
  FaceAxes f;
  f.n = s;
  f.t = any_across(s);
  f.u = cross3(s, f.t);
  f.q = lanes(0);
  PreciseMedium m = read_precise(medium, &f);
  PreciseWave all[4];
  precise_waves(&m, pc(0, 0), 0, all);
  for (int j = 0; j < 2; ++j) {
    Mode mode = rounded_mode(&all[j]);
    w[j].n = mode.p;
    w[j].e = in_world(&f, mode.e);
    w[j].h = in_world(&f, mode.h);
    cplx d[3];
    d[0] = cmul(mode.p, mode.h[1]);
    d[1] = cmul(complex_of(-mode.p.re, -mode.p.im), mode.h[0]);
    d[2] = complex_of(lanes(0), lanes(0));
    w[j].d = in_world(&f, d);
  }
  *gap = rounded(pc_sub(all[1].p, all[0].p));
}

FUNCTION void bulk_waves(GLOBAL const scalar* problem, PRIVATE BulkWave* w, PRIVATE cplx* gap) {
  GLOBAL const scalar* medium = problem + PROBE_MEDIUM1;
  vec3 s = broadcast(problem + PROBE_NORMAL);
  if (medium[PROBE_MEDIUM_ABSORBS] != 0) {
    absorbing_waves(medium, s, w, gap);
  } else {
    transparent_waves(medium, s, w, gap);
    if (any_lane(gap->re < lanes(0))) {  // the fast one first
      BulkWave first = w[0];
      w[0] = w[1];
      w[1] = first;
      gap->re = -gap->re;
    }
  }
}

FUNCTION void write_complex3(GLOBAL scalar* out, cvec3 v) {
  write_complex(out, complex_of(v.re.x, v.im.x));
  write_complex(out + 2, complex_of(v.re.y, v.im.y));
  write_complex(out + 4, complex_of(v.re.z, v.im.z));
}

FUNCTION void solve_bulk(GLOBAL const scalar* problem, GLOBAL scalar* answer) {
  BulkWave w[2];
  cplx gap;
  bulk_waves(problem, w, &gap);
  for (int j = 0; j < 2; ++j) {
    GLOBAL scalar* out = answer + j * BULK_SCALARS;
    real unit = lanes(1) / sqrt_of(dot3(w[j].e.re, w[j].e.re) + dot3(w[j].e.im, w[j].e.im));
    write_complex(out + BULK_N, w[j].n);
    write_complex3(out + BULK_E, scale_complex3(unit, w[j].e));
    write_complex3(out + BULK_H, scale_complex3(unit, w[j].h));
    write_complex3(out + BULK_D, scale_complex3(unit, w[j].d));
  }
  write_complex(answer + BULK_GAP, gap);
}

FUNCTION cplx along_axis(cvec3 v, vec3 axis) { return complex_of(dot3(v.re, axis), dot3(v.im, axis)); }

// D = c0 D0 + c1 D1 in (x, y) across s, the waves' phases -+ pi (n1 - n0) d/lambda, their mean left out.
FUNCTION void solve_propagation(GLOBAL const scalar* problem, GLOBAL scalar* answer) {
  BulkWave w[2];
  cplx gap;
  bulk_waves(problem, w, &gap);
  vec3 x = broadcast(problem + PROBE_K), y = cross3(broadcast(problem + PROBE_NORMAL), x);
  real depth = lanes(problem[PROBE_DEPTH]);
  cplx in_x = read_complex(problem + PROBE_D_IN), in_y = read_complex(problem + PROBE_D_IN + 2);
  cplx dx[2], dy[2], c[2];
  for (int j = 0; j < 2; ++j) {
    dx[j] = along_axis(w[j].d, x);
    dy[j] = along_axis(w[j].d, y);
  }
  cplx det = csub(cmul(dx[0], dy[1]), cmul(dx[1], dy[0]));
  c[0] = cdiv(csub(cmul(in_x, dy[1]), cmul(in_y, dx[1])), det);
  c[1] = cdiv(csub(cmul(in_y, dx[0]), cmul(in_x, dy[0])), det);
  cplx turn = rotation_of(lanes(0.5) * gap.re, lanes(0), depth);
  real decay = lanes(3.14159265358979323846) * gap.im * depth;
  c[0] = cmul(c[0], cscale(exp_of(decay), conj_of(turn)));
  c[1] = cmul(c[1], cscale(exp_of(-decay), turn));
  write_complex(answer + PROPAGATION_N, w[0].n);
  write_complex(answer + PROPAGATION_N + 2, w[1].n);
  store_lanes(lanes(6.28318530717958647692) * gap.re * depth, answer + PROPAGATION_RETARDANCE);
  write_complex(answer + PROPAGATION_D_OUT, cadd(cmul(c[0], dx[0]), cmul(c[1], dx[1])));
  write_complex(answer + PROPAGATION_D_OUT + 2, cadd(cmul(c[0], dy[0]), cmul(c[1], dy[1])));
}

#endif
