// Complex numbers and 4x4 eigenproblems of a single lane in the best precision there is.
// Schur form by shifted QR with Givens rotations: Golub & Van Loan, Matrix Computations, 4th ed., ch. 7.
#ifndef NICOL_PRECISE_MATH_H
#define NICOL_PRECISE_MATH_H
#include "portable.h"

typedef struct { precise re, im; } pcplx;

FUNCTION pcplx pc(precise re, precise im) { pcplx c; c.re = re; c.im = im; return c; }
FUNCTION pcplx pc_add(pcplx a, pcplx b) { return pc(a.re + b.re, a.im + b.im); }
FUNCTION pcplx pc_sub(pcplx a, pcplx b) { return pc(a.re - b.re, a.im - b.im); }
FUNCTION pcplx pc_mul(pcplx a, pcplx b) { return pc(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re); }
FUNCTION pcplx pc_scale(precise s, pcplx a) { return pc(s * a.re, s * a.im); }
FUNCTION pcplx pc_times_i(pcplx a) { return pc(-a.im, a.re); }
FUNCTION pcplx pc_conj(pcplx a) { return pc(a.re, -a.im); }
FUNCTION precise pc_norm2(pcplx a) { return a.re * a.re + a.im * a.im; }
FUNCTION pcplx pc_div(pcplx a, pcplx b) { return pc_scale(1 / pc_norm2(b), pc_mul(a, pc_conj(b))); }
FUNCTION pcplx pc_sqrt(pcplx a) {
  precise big = precise_sqrt((precise)0.5 * (precise_sqrt(pc_norm2(a)) + precise_abs(a.re)));
  precise small = big > 0 ? (precise)0.5 * precise_abs(a.im) / big : 0;
  precise re = a.re >= 0 ? big : small, im = a.re >= 0 ? small : big;
  return pc(re, a.im < 0 ? -im : im);
}

#define PRECISE_EPSILON (sizeof(precise) == 8 ? (precise)2.220446049250313e-16 : (precise)1.1920929e-7)

// A rotation of rows i, i + 1 that leaves 0 below f: new rows f* x + g* y, -g x + f y (f, g of unit length together).
typedef struct { pcplx f, g; } Rotation;

FUNCTION Rotation rotation_onto(pcplx f, pcplx g) {
  precise length = precise_sqrt(pc_norm2(f) + pc_norm2(g));
  Rotation r;
  r.f = length > 0 ? pc_scale(1 / length, f) : pc(1, 0);
  r.g = length > 0 ? pc_scale(1 / length, g) : pc(0, 0);
  return r;
}

FUNCTION void rotate_rows(pcplx a[4][4], int i, Rotation r) {
  for (int c = 0; c < 4; ++c) {
    pcplx x = a[i][c], y = a[i + 1][c];
    a[i][c] = pc_add(pc_mul(pc_conj(r.f), x), pc_mul(pc_conj(r.g), y));
    a[i + 1][c] = pc_sub(pc_mul(r.f, y), pc_mul(r.g, x));
  }
}

FUNCTION void rotate_columns(pcplx a[4][4], int i, Rotation r) {
  for (int c = 0; c < 4; ++c) {
    pcplx x = a[c][i], y = a[c][i + 1];
    a[c][i] = pc_add(pc_mul(r.f, x), pc_mul(r.g, y));
    a[c][i + 1] = pc_sub(pc_mul(pc_conj(r.f), y), pc_mul(pc_conj(r.g), x));
  }
}

// The eigenvalue of [[a, b], [c, d]] next to d.
FUNCTION pcplx corner_eigenvalue(pcplx a, pcplx b, pcplx c, pcplx d) {
  pcplx middle = pc_scale((precise)0.5, pc_sub(a, d)), product = pc_mul(b, c);
  pcplx root = pc_sqrt(pc_add(pc_mul(middle, middle), product));
  if (root.re * middle.re + root.im * middle.im < 0) root = pc_scale(-1, root);
  pcplx sum = pc_add(middle, root);
  return pc_norm2(sum) > 0 ? pc_sub(d, pc_div(product, sum)) : d;
}

// One QR step of rows lo..hi, Hessenberg.
FUNCTION void qr_step(pcplx a[4][4], pcplx u[4][4], int lo, int hi, pcplx shift) {
  Rotation r[3];
  for (int i = lo; i <= hi; ++i) a[i][i] = pc_sub(a[i][i], shift);
  for (int i = lo; i < hi; ++i) {
    r[i] = rotation_onto(a[i][i], a[i + 1][i]);
    rotate_rows(a, i, r[i]);
    a[i + 1][i] = pc(0, 0);
  }
  for (int i = lo; i < hi; ++i) {
    rotate_columns(a, i, r[i]);
    rotate_columns(u, i, r[i]);
  }
  for (int i = lo; i <= hi; ++i) a[i][i] = pc_add(a[i][i], shift);
}

// a = u t u^H, t upper triangular (returned in a). False if it does not converge.
FUNCTION int schur_form(pcplx a[4][4], pcplx u[4][4]) {
  precise size2 = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      u[i][j] = pc(i == j, 0);
      size2 += pc_norm2(a[i][j]);
    }
  precise negligible = PRECISE_EPSILON * PRECISE_EPSILON * size2 * (precise)0.0625;
  for (int c = 0; c < 2; ++c)
    for (int i = 2; i > c; --i) {  // Hessenberg form: zero below the subdiagonal
      Rotation r = rotation_onto(a[i][c], a[i + 1][c]);
      rotate_rows(a, i, r);
      rotate_columns(a, i, r);
      rotate_columns(u, i, r);
      a[i + 1][c] = pc(0, 0);
    }
  int hi = 3;
  for (int step = 0; step < 80 && hi > 0; ++step) {
    int lo = hi;
    while (lo > 0 && pc_norm2(a[lo][lo - 1]) > negligible) --lo;
    if (lo > 0) a[lo][lo - 1] = pc(0, 0);
    if (lo == hi) {
      --hi;
      continue;
    }
    pcplx shift = corner_eigenvalue(a[hi - 1][hi - 1], a[hi - 1][hi], a[hi][hi - 1], a[hi][hi]);
    if (step % 16 == 15) shift = pc_add(shift, a[hi][hi - 1]);
    qr_step(a, u, lo, hi, shift);
  }
  return hi == 0;
}

// Eigenvector j of the triangular t, in the axes of t.
FUNCTION void triangular_vector(pcplx t[4][4], int j, pcplx x[4]) {
  for (int r = 3; r >= 0; --r) {
    x[r] = pc(r == j, 0);
    if (r >= j) continue;
    pcplx sum = pc(0, 0), gap = pc_sub(t[j][j], t[r][r]);
    for (int s = r + 1; s <= j; ++s) sum = pc_add(sum, pc_mul(t[r][s], x[s]));
    if (pc_norm2(gap) < PRECISE_EPSILON * PRECISE_EPSILON) gap = pc(PRECISE_EPSILON, 0);
    x[r] = pc_div(sum, gap);
  }
}

// A vector that spans with eigenvector i the invariant space of eigenvalues i < j, however close they are.
FUNCTION void companion_vector(pcplx t[4][4], int i, int j, const pcplx xi[4], pcplx x[4]) {
  pcplx tie = pc(0, 0);
  for (int r = 3; r >= 0; --r) {
    x[r] = pc(r == j, 0);
    if (r >= j) continue;
    pcplx sum = pc(0, 0), gap = pc_sub(t[j][j], t[r][r]);
    for (int s = r + 1; s <= j; ++s) sum = pc_add(sum, pc_mul(t[r][s], x[s]));
    if (r == i) {
      tie = sum;
      continue;
    }
    if (pc_norm2(gap) < PRECISE_EPSILON * PRECISE_EPSILON) gap = pc(PRECISE_EPSILON, 0);
    x[r] = pc_div(r < i ? pc_sub(sum, pc_mul(tie, xi[r])) : sum, gap);
  }
}

#endif
