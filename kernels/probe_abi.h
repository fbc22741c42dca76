// Layout of `probe`: one face problem and its answer, as scalars. Complex numbers are re, im.
// Directions as in the oracle: N from medium 1 to medium 2, time factor exp(-i w t), k in units of k0, h = Z0 H.
#ifndef NICOL_PROBE_ABI_H
#define NICOL_PROBE_ABI_H

enum {
  PROBE_ISOTROPIC = 0,
  PROBE_CHIRAL = 1,
  // problem
  PROBE_CLASS1 = 0, PROBE_CLASS2,      // PROBE_ISOTROPIC or PROBE_CHIRAL
  PROBE_ABSORBS,                       // 1 if either medium absorbs (isotropic media only)
  PROBE_NORMAL,                        // 3
  PROBE_K = PROBE_NORMAL + 3,          // incident wave vector, 3 complex
  PROBE_E = PROBE_K + 6,               // incident fields, 3 complex each
  PROBE_H = PROBE_E + 6,
  PROBE_N1 = PROBE_H + 6,              // n + i k, complex
  PROBE_N2 = PROBE_N1 + 2,
  PROBE_KAPPA1 = PROBE_N2 + 2,
  PROBE_KAPPA2,
  // (index of the wave)^2 - (incident index)^2, complex, computed in double: waves of medium 1, then of
  // medium 2; chiral: hand -1 (right, n - kappa) first. Isotropic: both the same.
  PROBE_BRACKETS1,                     // 2 complex
  PROBE_BRACKETS2 = PROBE_BRACKETS1 + 4,
  PROBE_SCALARS = PROBE_BRACKETS2 + 4,

  // answer: waves reflected 0, 1, then transmitted 0, 1
  ANSWER_WAVE_P = 0,                   // complex
  ANSWER_WAVE_K = 2,                   // 3 complex, world
  ANSWER_WAVE_E = 8,                   // 3 complex, world
  ANSWER_WAVE_H = 14,
  ANSWER_WAVE_POWER = 20,              // of the incident normal flux
  ANSWER_WAVE_SCALARS = 21,
  ANSWER_R = 4 * ANSWER_WAVE_SCALARS,  // from the total fields
  ANSWER_T,
  ANSWER_E_R,                          // 3 complex, world
  ANSWER_E_T = ANSWER_E_R + 6,
  ANSWER_SCALARS = ANSWER_E_T + 6
};

#endif
