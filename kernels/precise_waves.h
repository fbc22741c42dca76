// The four plane waves of any linear medium with a given tangential wave vector, one lane at a time: for the few
// lanes that the fast ways cannot answer, and for absorbing crystals in the probe.
//
// p Psi = Delta Psi for Psi = (E_t, E_u, h_t, h_u), after E_N and h_N are eliminated from k x E = B, k x h = -D
// (Berreman, J. Opt. Soc. Am. 62, 502 (1972)), D = eps E + i zeta h, B = h - i zeta E (Condon 1937); exact in zeta.
// Lossless: J Delta is Hermitian for the flux Psi* J Psi/2, so two real forward roots have flux-orthogonal vectors,
// found together. Forward: flux > 0 if p is real, else Im p > 0. Test: tests/kernels/vectors_test.cpp.
#ifndef NICOL_PRECISE_WAVES_H
#define NICOL_PRECISE_WAVES_H
#include "precise_math.h"

typedef struct {
  pcplx p, psi[4], e_n, h_n;
  int runs;  // p is real
} PreciseWave;

// Axes t, u, N; symmetric.
typedef struct {
  pcplx eps[3][3];
  precise zeta[3][3];
} PreciseMedium;

typedef struct {
  pcplx delta[4][4], normal[2][4];  // p Psi = delta Psi; (E_N, h_N) = normal Psi
} Berreman;

FUNCTION void berreman_matrix(PRIVATE const PreciseMedium* m, pcplx q, PRIVATE Berreman* b) {
  precise z = m->zeta[2][2];
  pcplx inverse = pc_div(pc(1, 0), pc_sub(m->eps[2][2], pc(z * z, 0)));
  pcplx x[4], y[4];
  x[0] = pc(0, m->zeta[2][0]);
  x[1] = pc(q.re, q.im + m->zeta[2][1]);
  x[2] = x[3] = pc(0, 0);
  y[0] = pc_scale(-1, m->eps[2][0]);
  y[1] = pc_scale(-1, m->eps[2][1]);
  y[2] = pc(0, -m->zeta[2][0]);
  y[3] = pc(-q.re, -q.im - m->zeta[2][1]);
  for (int c = 0; c < 4; ++c) {
    b->normal[0][c] = pc_mul(inverse, pc_sub(y[c], pc_times_i(pc_scale(z, x[c]))));
    b->normal[1][c] = pc_add(x[c], pc_times_i(pc_scale(z, b->normal[0][c])));
  }
  for (int c = 0; c < 4; ++c) {
    // E and h of the unit column, and zeta E, zeta h, eps E across N
    pcplx e[3], h[3], b_t[2], d_t[2];
    for (int i = 0; i < 2; ++i) {
      e[i] = pc(c == i, 0);
      h[i] = pc(c == i + 2, 0);
    }
    e[2] = b->normal[0][c];
    h[2] = b->normal[1][c];
    for (int i = 0; i < 2; ++i) {
      b_t[i] = h[i];
      d_t[i] = pc(0, 0);
      for (int j = 0; j < 3; ++j) {
        b_t[i] = pc_sub(b_t[i], pc_times_i(pc_scale(m->zeta[i][j], e[j])));
        d_t[i] = pc_add(d_t[i], pc_add(pc_mul(m->eps[i][j], e[j]), pc_times_i(pc_scale(m->zeta[i][j], h[j]))));
      }
    }
    b->delta[0][c] = pc_add(b_t[1], pc_mul(q, e[2]));
    b->delta[1][c] = pc_scale(-1, b_t[0]);
    b->delta[2][c] = pc_sub(pc_mul(q, h[2]), d_t[1]);
    b->delta[3][c] = d_t[0];
  }
}

// a* J b
FUNCTION pcplx flux_product(const pcplx a[4], const pcplx b[4]) {
  pcplx sum = pc_mul(pc_conj(a[0]), b[3]);
  sum = pc_sub(sum, pc_mul(pc_conj(a[1]), b[2]));
  sum = pc_sub(sum, pc_mul(pc_conj(a[2]), b[1]));
  return pc_add(sum, pc_mul(pc_conj(a[3]), b[0]));
}

FUNCTION void times_delta(PRIVATE const Berreman* b, const pcplx x[4], pcplx out[4]) {
  for (int r = 0; r < 4; ++r) {
    out[r] = pc(0, 0);
    for (int c = 0; c < 4; ++c) out[r] = pc_add(out[r], pc_mul(b->delta[r][c], x[c]));
  }
}

// Two real waves of one direction, sign of flux given, made flux-orthogonal eigenwaves of their span; smaller p first.
FUNCTION void orthogonal_pair(PRIVATE const Berreman* b, precise sign, pcplx x[4], pcplx y[4], precise p[2]) {
  pcplx to_x[4], to_y[4];
  times_delta(b, x, to_x);
  times_delta(b, y, to_y);
  precise g11 = sign * flux_product(x, x).re, g22 = sign * flux_product(y, y).re;
  pcplx g12 = pc_scale(sign, flux_product(x, y));
  // Gram matrix L L*, H = L^-1 K L^-*
  precise l1 = precise_sqrt(g11), rest = g22 - pc_norm2(g12) / g11;
  if (!(g11 > 0) || !(rest > PRECISE_EPSILON * g22)) {
    p[0] = sign * flux_product(x, to_x).re / (g11 != 0 ? g11 : 1);
    p[1] = sign * flux_product(y, to_y).re / (g22 != 0 ? g22 : 1);
    return;
  }
  precise l2 = precise_sqrt(rest);
  pcplx l21 = pc_scale(1 / l1, pc_conj(g12));
  precise k11 = sign * flux_product(x, to_x).re, k22 = sign * flux_product(y, to_y).re;
  pcplx k12 = pc_scale(sign, flux_product(x, to_y));
  precise h11 = k11 / g11;
  pcplx h12 = pc_scale(1 / (l1 * l2), pc_sub(k12, pc_scale(k11 / l1, pc_conj(l21))));
  pcplx row1 = pc_scale(1 / l2, pc_sub(pc_conj(k12), pc_scale(k11 / l1, l21)));
  precise row2 = (k22 - pc_mul(l21, k12).re / l1) / l2;
  precise h22 = (row2 - pc_mul(row1, pc_conj(l21)).re / l1) / l2;
  // eigenpair of H, larger eigenvalue (c, s)
  precise d = (h11 - h22) / 2, radius = precise_sqrt(d * d + pc_norm2(h12)), big = radius + precise_abs(d);
  precise length = precise_sqrt(big * big + pc_norm2(h12));
  pcplx c = length > 0 ? pc(big / length, 0) : pc(1, 0), s = length > 0 ? pc_scale(1 / length, h12) : pc(0, 0);
  pcplx plus1 = d >= 0 ? c : s, plus2 = d >= 0 ? pc_conj(s) : c;
  p[0] = (h11 + h22) / 2 - radius;
  p[1] = (h11 + h22) / 2 + radius;
  for (int i = 0; i < 4; ++i) {
    pcplx x1 = pc_scale(1 / l1, x[i]);
    pcplx y1 = pc_scale(1 / l2, pc_sub(y[i], pc_mul(pc_conj(l21), x1)));
    x[i] = pc_sub(pc_mul(pc_conj(plus1), y1), pc_mul(pc_conj(plus2), x1));
    y[i] = pc_add(pc_mul(plus1, x1), pc_mul(plus2, y1));
  }
}

FUNCTION void to_face(pcplx u[4][4], const pcplx x[4], pcplx out[4]) {
  precise length2 = 0;
  for (int r = 0; r < 4; ++r) {
    out[r] = pc(0, 0);
    for (int c = 0; c < 4; ++c) out[r] = pc_add(out[r], pc_mul(u[r][c], x[c]));
    length2 += pc_norm2(out[r]);
  }
  for (int r = 0; r < 4; ++r) out[r] = pc_scale(1 / precise_sqrt(length2), out[r]);
}

// How far a wave is forward: decaying ones come before all others. `size` is the norm of Delta; roots next to a
// critical angle are real if rounding alone makes them complex.
FUNCTION precise forward_score(pcplx p, const pcplx psi[4], precise size, int lossless, PRIVATE int* runs) {
  precise length = precise_sqrt(pc_norm2(p)), least = (precise)1e-300;
  precise rounding = 450 * PRECISE_EPSILON * size + 20 * PRECISE_EPSILON * size * size / (length > least ? length : least);
  if (rounding > length / 2) rounding = length / 2;
  *runs = lossless && precise_abs(p.im) <= rounding;
  if (*runs) return flux_product(psi, psi).re / 2;
  return lossless ? (p.im > 0 ? 10 : -10) : p.im;
}

// Waves 0, 1 forward, 2, 3 backward; of two running waves the one with the smaller Re p first, an evanescent wave
// before a running one. Complex q: lossless must be 0; waves are told apart by Im p, good for real q.
FUNCTION void precise_waves(PRIVATE const PreciseMedium* m, pcplx q, int lossless, PreciseWave wave[4]) {
  Berreman b;
  berreman_matrix(m, q, &b);
  pcplx t[4][4], u[4][4], axes[4][4];
  precise size2 = 0, score[4];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      t[i][j] = b.delta[i][j];
      size2 += pc_norm2(t[i][j]);
    }
  schur_form(t, u);
  // single waves
  int order[4], runs[4];
  pcplx psi[4][4];
  for (int j = 0; j < 4; ++j) {
    triangular_vector(t, j, axes[j]);
    to_face(u, axes[j], psi[j]);
    score[j] = forward_score(t[j][j], psi[j], precise_sqrt(size2), lossless, &runs[j]);
    order[j] = j;
  }
  for (int i = 1; i < 4; ++i)
    for (int j = i; j > 0 && score[order[j]] > score[order[j - 1]]; --j) {
      int swap = order[j];
      order[j] = order[j - 1];
      order[j - 1] = swap;
    }
  for (int side = 0; side < 2; ++side) {
    int first = order[2 * side], second = order[2 * side + 1];
    if (first > second) {
      int swap = first;
      first = second;
      second = swap;
    }
    pcplx p[2];
    p[0] = t[first][first];
    p[1] = t[second][second];
    // waves nearly alike: a second vector that does not depend on their difference
    int pair_runs = runs[first] && runs[second];
    if (pc_norm2(pc_sub(p[0], p[1])) < (precise)(pair_runs ? 1e-8 : 1e-18) * size2) {
      pcplx x[4];
      companion_vector(t, first, second, axes[first], x);
      to_face(u, x, psi[second]);
    }
    if (pair_runs) {
      precise real_p[2];
      orthogonal_pair(&b, side == 0 ? 1 : -1, psi[first], psi[second], real_p);
      p[0] = pc(real_p[0], 0);
      p[1] = pc(real_p[1], 0);
    }
    int swapped = !pair_runs && (runs[first] != runs[second] ? runs[first] : p[0].re > p[1].re);
    for (int j = 0; j < 2; ++j) {
      PRIVATE PreciseWave* w = &wave[2 * side + j];
      int from = (j == 0) != swapped ? first : second;
      w->p = p[(j == 0) != swapped ? 0 : 1];
      w->runs = runs[from];
      if (w->runs) w->p.im = 0;
      w->e_n = w->h_n = pc(0, 0);
      precise length2 = 0;
      for (int c = 0; c < 4; ++c) length2 += pc_norm2(psi[from][c]);
      for (int c = 0; c < 4; ++c) {
        w->psi[c] = pc_scale(1 / precise_sqrt(length2), psi[from][c]);
        w->e_n = pc_add(w->e_n, pc_mul(b.normal[0][c], w->psi[c]));
        w->h_n = pc_add(w->h_n, pc_mul(b.normal[1][c], w->psi[c]));
      }
    }
  }
}

#endif
