// Layout of `probe`: one problem and its answer, as scalars. Complex numbers are re, im.
// Directions: N from medium 1 to medium 2, time factor exp(-i w t), k in units of k0, h = Z0 H. Tensors: xx yy zz yz
// zx xy.
#ifndef NICOL_PROBE_ABI_H
#define NICOL_PROBE_ABI_H

enum {
  PROBE_FACE = 0, PROBE_BULK, PROBE_PROPAGATION,

  // medium: members of WaveMedium (wave_medium.h), computed in double
  PROBE_MEDIUM_KIND = 0, PROBE_MEDIUM_ACTIVE, PROBE_MEDIUM_ABSORBS,
  PROBE_MEDIUM_N, PROBE_MEDIUM_EPS,
  PROBE_MEDIUM_AXIS,                                // 3
  PROBE_MEDIUM_EPS_E = PROBE_MEDIUM_AXIS + 3, PROBE_MEDIUM_D_EPS, PROBE_MEDIUM_D_ETA,
  PROBE_MEDIUM_ATIL,                                // 6 each
  PROBE_MEDIUM_GQ = PROBE_MEDIUM_ATIL + 6,
  PROBE_MEDIUM_ZETA = PROBE_MEDIUM_GQ + 6,
  PROBE_MEDIUM_KAPPA = PROBE_MEDIUM_ZETA + 6,
  PROBE_MEDIUM_TENSOR,                              // eps, 6 complex
  PROBE_MEDIUM_INDEX = PROBE_MEDIUM_TENSOR + 12,    // n + i k, complex: isotropic, ordinary
  PROBE_MEDIUM_INDEX_E = PROBE_MEDIUM_INDEX + 2,    // the same, extraordinary
  PROBE_MEDIUM_SCALARS = PROBE_MEDIUM_INDEX_E + 2,

  // problem
  PROBE_TASK = 0,
  // wave of medium 1 that comes in: 0, 1, 2 both (isotropic), -1 unknown
  PROBE_KNOWN,
  PROBE_NORMAL,                                     // 3; bulk, propagation: the wave normal
  // incident wave vector, 3 complex; propagation: x axis of D in the first 3
  PROBE_K = PROBE_NORMAL + 3,
  // incident fields, 3 complex each; propagation: D_in (2 complex), d/lambda
  PROBE_E = PROBE_K + 6,
  PROBE_H = PROBE_E + 6,
  PROBE_BRACKET1 = PROBE_H + 6,                     // eps of the medium (PROBE_MEDIUM_EPS) - |k|^2, complex
  PROBE_BRACKET2 = PROBE_BRACKET1 + 2,
  PROBE_MEDIUM1 = PROBE_BRACKET2 + 2,
  PROBE_MEDIUM2 = PROBE_MEDIUM1 + PROBE_MEDIUM_SCALARS,
  PROBE_SCALARS = PROBE_MEDIUM2 + PROBE_MEDIUM_SCALARS,
  PROBE_D_IN = PROBE_E, PROBE_DEPTH = PROBE_E + 4,

  // answer of a face: waves reflected 0, 1, then transmitted 0, 1
  ANSWER_WAVE_P = 0,                                // complex
  ANSWER_WAVE_K = 2,                                // 3 complex each, world
  ANSWER_WAVE_E = 8,
  ANSWER_WAVE_H = 14,
  ANSWER_WAVE_POWER = 20,                           // of the incident normal flux
  ANSWER_WAVE_SCALARS = 21,
  ANSWER_R = 4 * ANSWER_WAVE_SCALARS,               // from the total fields
  ANSWER_T,
  ANSWER_E_R,                                       // 3 complex each, world
  ANSWER_E_T = ANSWER_E_R + 6,
  ANSWER_FALLBACKS = ANSWER_E_T + 6,                // waves that took the precise way
  ANSWER_SCALARS = ANSWER_FALLBACKS + 1,

  // answer of bulk: two waves
  BULK_N = 0,                                       // complex
  BULK_E = 2, BULK_H = 8, BULK_D = 14,              // 3 complex each, world, |E| = 1
  BULK_SCALARS = 20,
  BULK_GAP = 2 * BULK_SCALARS,                      // n of wave 1 less that of wave 0, complex
  // answer of propagation
  PROPAGATION_N = 0,                                // 2 complex
  PROPAGATION_RETARDANCE = 4,                       // radians
  PROPAGATION_D_OUT                                 // 2 complex
};

#endif
