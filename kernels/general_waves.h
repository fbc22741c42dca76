// Plane waves of biaxial and of anisotropic active media that leave a face, by the way that suits each lane:
// frozen_polarization.h where both waves run, evanescent_waves.h where one does not, precise_waves.h in double for
// what neither settles (fewer than 1 in 1000 internal faces of minerals; total reflection in crystals of birefringence above
// 0.5 always).
// Thresholds: residual and distance below which a complex root or a pair of them is not trusted in single precision.
// Test: tests/kernels/vectors_test.cpp, waves_test.cpp; float against double where it is hardest: precision_test.cpp.
#ifndef NICOL_GENERAL_WAVES_H
#define NICOL_GENERAL_WAVES_H
#include "evanescent_waves.h"
#include "precise_waves.h"

#define EVANESCENT_RESIDUAL (sizeof(scalar) == 8 ? 1e-14f : 1e-5f)
#define EVANESCENT_LEAST 3e-3f       // Im p/n below which the critical angle is too near
#define EVANESCENT_CLOSE 3e-5f       // distance of two roots, with overlap of their polarizations^2:
#define EVANESCENT_ALIKE 0.49f
#define STRONG_DEVIATION2 0.16f      // |n2bar eta - I|^2 of a birefringence of 0.5

// A wave on its way to fields: p and D = e1 u + e2 v.
typedef struct { cplx p, e1, e2; } FaceWave;

FUNCTION Mode fields_of_face_wave(PRIVATE const GeneralFace* f, PRIVATE const FaceTensor* z,
    PRIVATE const FaceWave* w, int complex_p) {
  cplx d[3], inverse = complex_of(lanes(1) / sqrt_of(f->q * f->q + w->p.re * w->p.re), lanes(0));
  if (complex_p) {
    cplx k2 = cmul(w->p, w->p);
    k2.re += f->q * f->q;
    inverse = cpick(w->p.im != lanes(0), cdiv(complex_of(lanes(1), lanes(0)), csqrt_of(k2)), inverse);
  }
  cplx v_t = cmul(w->p, inverse);
  d[0] = cmul(complex_of(-v_t.re, -v_t.im), w->e2);
  d[1] = w->e1;
  d[2] = cmul(cscale(f->q, inverse), w->e2);
  return fields_of_d(f, z, w->p, d);
}

FUNCTION mask strongly_birefringent(PRIVATE const FaceTensor* a) {
  real off = a->un * a->un + a->tn * a->tn + a->ut * a->ut;
  return a->tt * a->tt + a->uu * a->uu + a->nn * a->nn + lanes(2) * off > lanes(STRONG_DEVIATION2);
}

// Evanescent roots in the lanes where the quadratics had none. Returns the lanes that are not to be trusted.
FUNCTION mask take_evanescent(PRIVATE const GeneralFace* f, mask gone_fast, mask gone_slow, PRIVATE FaceWave* wave) {
  mask doubtful = gone_fast & not_mask(gone_fast), both = gone_fast & gone_slow;
  for (int j = 0; j < 2; ++j) {
    mask gone = j == 0 ? gone_fast : gone_slow;
    if (!any_lane(gone)) continue;
    EvanescentRoot root = evanescent_root(f, lanes(j == 0 ? 1 : -1), gone);
    mask good = (root.residual < lanes(EVANESCENT_RESIDUAL) * f->n * f->n) & (root.p.im > lanes(EVANESCENT_LEAST) * f->n);
    doubtful = doubtful | (gone & not_mask(good));
    wave[j].p = cpick(gone, root.p, wave[j].p);
    wave[j].e1 = cpick(gone, root.e1, wave[j].e1);
    wave[j].e2 = cpick(gone, root.e2, wave[j].e2);
  }
  real distance2 = norm2(csub(wave[0].p, wave[1].p)), least = lanes(EVANESCENT_CLOSE) * f->n;
  mask same = (distance2 < least * least) & (overlap(wave[0].e1, wave[0].e2, wave[1].e1,
      wave[1].e2) > lanes(EVANESCENT_ALIKE));
  return doubtful | (both & same);
}

// One lane of face and medium in double: eps = n2bar (I + a)^-1.
FUNCTION void precise_medium(PRIVATE const precise* a, PRIVATE const precise* zeta, precise eps,
    PRIVATE PreciseMedium* m) {
  const int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
  precise s[3][3];
  for (int i = 0; i < 6; ++i) {
    s[row[i]][column[i]] = s[column[i]][row[i]] = a[i] + (row[i] == column[i] ? 1 : 0);
    m->zeta[row[i]][column[i]] = m->zeta[column[i]][row[i]] = zeta[i];
  }
  precise minor[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      minor[i][j] = s[i1][j1] * s[i2][j2] - s[i1][j2] * s[i2][j1];
    }
  precise scale = eps / (s[0][0] * minor[0][0] + s[0][1] * minor[0][1] + s[0][2] * minor[0][2]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m->eps[i][j] = pc(scale * minor[i][j], 0);
}

#define MODE_SCALARS 14

FUNCTION void store_mode(PRIVATE const Mode* m, scalar out[MODE_SCALARS][LANES]) {
  store_lanes(m->p.re, out[0]);
  store_lanes(m->p.im, out[1]);
  for (int i = 0; i < 3; ++i) {
    store_lanes(m->e[i].re, out[2 + 2 * i]);
    store_lanes(m->e[i].im, out[3 + 2 * i]);
    store_lanes(m->h[i].re, out[8 + 2 * i]);
    store_lanes(m->h[i].im, out[9 + 2 * i]);
  }
}

FUNCTION void load_mode(scalar in[MODE_SCALARS][LANES], PRIVATE Mode* m) {
  m->p = complex_of(load_lanes(in[0]), load_lanes(in[1]));
  for (int i = 0; i < 3; ++i) {
    m->e[i] = complex_of(load_lanes(in[2 + 2 * i]), load_lanes(in[3 + 2 * i]));
    m->h[i] = complex_of(load_lanes(in[8 + 2 * i]), load_lanes(in[9 + 2 * i]));
  }
}

FUNCTION void put_precise_wave(PRIVATE const PreciseWave* w, int lane, scalar out[MODE_SCALARS][LANES]) {
  pcplx value[7];
  value[0] = w->p;
  value[1] = w->psi[0];
  value[2] = w->psi[1];
  value[3] = w->e_n;
  value[4] = w->psi[2];
  value[5] = w->psi[3];
  value[6] = w->h_n;
  for (int i = 0; i < 7; ++i) {
    out[2 * i][lane] = (scalar)value[i].re;
    out[2 * i + 1][lane] = (scalar)value[i].im;
  }
}

// Both waves anew, lane by lane, where `doubtful`.
FUNCTION void take_precise(PRIVATE const GeneralFace* f, PRIVATE const FaceTensor* zeta, real eps, mask doubtful,
    PRIVATE WavePair* w) {
  scalar modes[2][MODE_SCALARS][LANES], given[15][LANES], wanted[LANES], gap[LANES];
  PRIVATE const FaceTensor* tensor[2];
  tensor[0] = &f->a;
  tensor[1] = zeta;
  for (int i = 0; i < 2; ++i) {
    store_lanes(tensor[i]->tt, given[6 * i]);
    store_lanes(tensor[i]->uu, given[6 * i + 1]);
    store_lanes(tensor[i]->nn, given[6 * i + 2]);
    store_lanes(tensor[i]->un, given[6 * i + 3]);
    store_lanes(tensor[i]->tn, given[6 * i + 4]);
    store_lanes(tensor[i]->ut, given[6 * i + 5]);
    store_mode(&w->mode[i], modes[i]);
  }
  store_lanes(eps, given[12]);
  store_lanes(f->q, given[13]);
  store_lanes(f->p2, given[14]);
  store_lanes(w->gap, gap);
  store_lanes(pick(doubtful, lanes(1), lanes(0)), wanted);
  for (int lane = 0; lane < LANES; ++lane) {
    if (wanted[lane] == 0) continue;
    precise a[6], z[6], n2 = (precise)given[12][lane], q = (precise)given[13][lane], p2 = (precise)given[14][lane];
    for (int i = 0; i < 6; ++i) {
      a[i] = (precise)given[i][lane];
      z[i] = f->active ? (precise)given[6 + i][lane] : 0;
    }
    if (q * q > n2 / 4) q = precise_sqrt(n2 - p2);  // p2 knows more of grazing waves than q does
    PreciseMedium m;
    precise_medium(a, z, n2, &m);
    PreciseWave wave[4];
    precise_waves(&m, pc(q, 0), 1, wave);
    for (int i = 0; i < 2; ++i) put_precise_wave(&wave[i], lane, modes[i]);
    gap[lane] = wave[0].runs && wave[1].runs ? (scalar)(wave[1].p.re - wave[0].p.re) : 0;
  }
  for (int i = 0; i < 2; ++i) load_mode(modes[i], &w->mode[i]);
  w->gap = load_lanes(gap);
}

FUNCTION WavePair general_waves(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* axes, real p2, int backward,
    mask live,
                                PRIVATE int* fallbacks) {
  GeneralFace f = general_face(m, axes, p2, backward);
  FaceTensor zeta = f.a;
  if (m->active) zeta = on_face(m->zeta, axes, backward);
  // real roots
  SheetRoot fast = sheet_root(&f, lanes(1), live), slow = sheet_root(&f, lanes(-1), live);
  mask gone_fast = live & fast.gone, gone_slow = live & slow.gone, gone = gone_fast | gone_slow;
  mask doubtful = live & not_mask((fast.gone | settled(&f, &fast)) & (slow.gone | settled(&f, &slow)));
  // polarizations
  SheetWave sheets[2];
  real gap = sheets_apart(&f, fast.p, slow.p, sheets);
  mask close = not_mask(gone) & (abs_of(fast.p - slow.p) < lanes(CLOSE_PAIR) * f.n);
  if (any_lane(live & close)) {
    SheetWave both[2];
    real joint_gap = sheets_together(&f, lanes(0.5) * (fast.p + slow.p), both);
    for (int j = 0; j < 2; ++j) sheets[j] = pick_sheet(close, both[j], sheets[j]);
    gap = pick(close, joint_gap, gap);
  }
  FaceWave wave[2];
  for (int j = 0; j < 2; ++j) {
    wave[j].p = complex_of(sheets[j].p, lanes(0));
    wave[j].e1 = sheets[j].e1;
    wave[j].e2 = sheets[j].e2;
  }
  int some_gone = any_lane(gone);
  if (some_gone) doubtful = doubtful | take_evanescent(&f, gone_fast, gone_slow,
      wave) | (gone & strongly_birefringent(&f.a));
  // fields
  WavePair w;
  for (int j = 0; j < 2; ++j) w.mode[j] = fields_of_face_wave(&f, &zeta, &wave[j], some_gone);
  w.gap = pick(gone, lanes(0), gap);
  if (any_lane(doubtful)) {
    take_precise(&f, &zeta, m->eps, doubtful, &w);
    *fallbacks += count_lanes(doubtful);
  }
  if (!backward) return w;
  w.mode[0] = turned_back(w.mode[0]);
  w.mode[1] = turned_back(w.mode[1]);
  w.gap = -w.gap;
  return w;
}

#endif
