// The boundary problem of a face: amplitudes of the two reflected and two transmitted waves.
//
// Tangential E and h are continuous: [T1 T2 -R1 -R2] a = incident, each column scaled to unit length, by
// Gaussian elimination with partial pivoting, lane by lane (condition <= 90 over all media), one elimination for
// one or two incident waves. Source: Berreman, J. Opt. Soc. Am. 62, 502 (1972).
// Powers are normal fluxes Re(E x h*).N/2 by that of the incident wave; lossless waves of one side are flux-orthogonal,
// so that R + T = 1 and the fluxes of single waves add. In single precision waves that are nearly alike are not
// quite orthogonal: the flux of the summed field counts, and single waves share it. Answers to two incident waves are made
// orthogonal, so that R + T = 1 for whatever both carry.
// Test: tests/kernels/vectors_test.cpp (60-digit solutions), waves_test.cpp (energy, reciprocity).
#ifndef NICOL_BOUNDARY_H
#define NICOL_BOUNDARY_H
#include "wave_medium.h"

// Per root of flux: [incident wave][outgoing wave]; evanescent waves carry nothing: 0. Where a side's waves are s and
// p the phase is that of E_s and E_p. off: R + T - 1 before the powers were made to add to 1.
typedef struct {
  cplx r[2][2], t[2][2];
  real off[2];
} FaceAmplitudes;

// The largest of column c comes to row c, columns from c on.
FUNCTION void bring_pivot(cplx m[4][6], int c, int columns) {
  for (int r = c + 1; r < 4; ++r) {
    mask larger = norm2(m[r][c]) > norm2(m[c][c]);
    for (int k = c; k < columns; ++k) {
      cplx upper = m[c][k], lower = m[r][k];
      m[c][k] = cpick(larger, lower, upper);
      m[r][k] = cpick(larger, upper, lower);
    }
  }
}

// Columns 0..3: the matrix, 4..: right sides; amplitude[i] solves for right side i.
FUNCTION void solve_four(cplx m[4][6], int count, cplx amplitude[2][4]) {
  cplx inverse[4];
  for (int c = 0; c < 4; ++c) {
    bring_pivot(m, c, 4 + count);
    real size = norm2(m[c][c]);
    inverse[c] = cscale(pick(size > lanes(0), lanes(1) / pick(size > lanes(0), size, lanes(1)), lanes(0)),
        conj_of(m[c][c]));
    for (int r = c + 1; r < 4; ++r) {
      cplx factor = cmul(m[r][c], inverse[c]);
      for (int k = c + 1; k < 4 + count; ++k) m[r][k] = csub(m[r][k], cmul(factor, m[c][k]));
    }
  }
  for (int i = 0; i < count; ++i) {
    for (int r = 3; r >= 0; --r) {
      cplx sum = m[r][4 + i];
      for (int k = r + 1; k < 4; ++k) sum = csub(sum, cmul(m[r][k], amplitude[i][k]));
      amplitude[i][r] = cmul(sum, inverse[r]);
    }
  }
}

// amplitude[i]: of transmitted[0..1], reflected[0..1] for incident wave i.
FUNCTION void match_fields(PRIVATE const Mode* incident, int count, PRIVATE const Mode* transmitted,
                           PRIVATE const Mode* reflected, cplx amplitude[2][4]) {
  cplx m[4][6];
  real unit[4];
  for (int j = 0; j < 4; ++j) {
    PRIVATE const Mode* mode = j < 2 ? &transmitted[j] : &reflected[j - 2];
    real length2 = norm2(mode->e[0]) + norm2(mode->e[1]) + norm2(mode->h[0]) + norm2(mode->h[1]);
    unit[j] = lanes(1) / sqrt_of(length2);
    real scale = j < 2 ? unit[j] : -unit[j];
    m[0][j] = cscale(scale, mode->e[0]);
    m[1][j] = cscale(scale, mode->e[1]);
    m[2][j] = cscale(scale, mode->h[0]);
    m[3][j] = cscale(scale, mode->h[1]);
  }
  for (int i = 0; i < count; ++i) {
    m[0][4 + i] = incident[i].e[0];
    m[1][4 + i] = incident[i].e[1];
    m[2][4 + i] = incident[i].h[0];
    m[3][4 + i] = incident[i].h[1];
  }
  solve_four(m, count, amplitude);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < 4; ++j) amplitude[i][j] = cscale(unit[j], amplitude[i][j]);
}

// Flux along N of two waves together.
FUNCTION real flux_of_pair(PRIVATE const WavePair* w, cplx a0, cplx a1) {
  cplx e[2], h[2];
  for (int i = 0; i < 2; ++i) {
    e[i] = cadd(cmul(a0, w->mode[0].e[i]), cmul(a1, w->mode[1].e[i]));
    h[i] = cadd(cmul(a0, w->mode[0].h[i]), cmul(a1, w->mode[1].h[i]));
  }
  return flux_of(e, h);
}

FUNCTION real clamp_below(real x) { return pick(x > lanes(0), x, lanes(0)); }

// Flux of one wave, 0 where it is evanescent.
FUNCTION real running_flux(PRIVATE const Mode* m, real sign) {
  return pick(m->p.im == lanes(0), clamp_below(sign * flux_of(m->e, m->h)), lanes(0));
}

// share: flux of the side by that of all outgoing waves; own: that of each wave of unit amplitude.
FUNCTION void scale_to_share(real share, PRIVATE const real* own, cplx a0, cplx a1, PRIVATE cplx* out) {
  real sum = norm2(a0) * own[0] + norm2(a1) * own[1];
  real factor = pick(sum > lanes(0), share / pick(sum > lanes(0), sum, lanes(1)), lanes(0));
  out[0] = cscale(sqrt_of(own[0] * factor), a0);
  out[1] = cscale(sqrt_of(own[1] * factor), a1);
}

// Powers shared out: a from match_fields of the same waves.
FUNCTION FaceAmplitudes share_powers(PRIVATE const Mode* incident, int count, PRIVATE const WavePair* reflected,
                                     PRIVATE const WavePair* transmitted, cplx a[2][4]) {
  real own_t[2], own_r[2];
  for (int j = 0; j < 2; ++j) {
    own_t[j] = running_flux(&transmitted->mode[j], lanes(1));
    own_r[j] = running_flux(&reflected->mode[j], lanes(-1));
  }
  mask any_t = own_t[0] + own_t[1] > lanes(0);
  FaceAmplitudes f;
  for (int i = 0; i < 2; ++i) {
    int from = i < count ? i : 0;
    real flux_t = pick(any_t, clamp_below(flux_of_pair(transmitted, a[from][0], a[from][1])), lanes(0));
    real flux_r = clamp_below(-flux_of_pair(reflected, a[from][2], a[from][3]));
    real all = flux_t + flux_r, inverse = lanes(1) / pick(all > lanes(0), all, lanes(1));
    real given = flux_of(incident[from].e, incident[from].h);
    f.off[i] = all / pick(given != lanes(0), given, lanes(1)) - lanes(1);
    scale_to_share(flux_t * inverse, own_t, a[from][0], a[from][1], f.t[i]);
    scale_to_share(flux_r * inverse, own_r, a[from][2], a[from][3], f.r[i]);
  }
  return f;
}

// Two incident waves of orthogonal fluxes have orthogonal answers, for R + T = 1 of every sum of both. What rounding left between
// them is taken out, half from each (Lowdin, J. Chem. Phys. 18, 365 (1950)): what remains is of third order in it.
FUNCTION void part_answers(PRIVATE const Mode* incident, PRIVATE FaceAmplitudes* f) {
  cplx overlap = complex_of(lanes(0), lanes(0));
  for (int w = 0; w < 2; ++w)
    overlap = cadd(overlap, cadd(cmul(conj_of(f->t[0][w]), f->t[1][w]), cmul(conj_of(f->r[0][w]), f->r[1][w])));
  mask both = (incident[0].p.im == lanes(0)) & (incident[1].p.im == lanes(0)) & (norm2(overlap) < lanes(0.01f));
  cplx part = cpick(both, cscale(lanes(0.5f), overlap), complex_of(lanes(0), lanes(0)));
  for (int w = 0; w < 2; ++w) {
    cplx t0 = f->t[0][w], r0 = f->r[0][w];
    f->t[0][w] = csub(t0, cmul(conj_of(part), f->t[1][w]));
    f->r[0][w] = csub(r0, cmul(conj_of(part), f->r[1][w]));
    f->t[1][w] = csub(f->t[1][w], cmul(part, t0));
    f->r[1][w] = csub(f->r[1][w], cmul(part, r0));
  }
}

// incident: count (1 or 2) waves of medium 1 running to +N with the q of the outgoing ones.
FUNCTION FaceAmplitudes face_amplitudes(PRIVATE const Mode* incident, int count, PRIVATE const WavePair* reflected,
                                        PRIVATE const WavePair* transmitted) {
  cplx a[2][4];
  match_fields(incident, count, transmitted->mode, reflected->mode, a);
  FaceAmplitudes f = share_powers(incident, count, reflected, transmitted, a);
  if (count == 2) part_answers(incident, &f);
  return f;
}

#endif
