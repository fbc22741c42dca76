// A face where at least one side is a crystal: every wave on either side, as paths of their own.
//
// Amplitudes: boundary.h, per root of flux. Test: tests/kernels/crystal_*_test.cpp.
#ifndef NICOL_CRYSTAL_FACE_H
#define NICOL_CRYSTAL_FACE_H
#include "send_waves.h"

// waves_of_face (waves.h) without the solvers that the scene does not need.
FUNCTION WavePair waves_away(PRIVATE const SceneView* view, PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f,
                             real p2,
                             int backward, int known, real known_p, mask live, PRIVATE int* fallbacks) {
  if (m->kind == WAVES_ISOTROPIC) return isotropic_waves(m, f, p2, backward, known, known_p);
  if (has(gyration, view) && m->kind == WAVES_CHIRAL) return chiral_waves(m, f, p2, backward, known, known_p);
  if (has(general_waves, view) && m->kind == WAVES_GENERAL) return general_waves(m, f, p2, backward, live, fallbacks);
  return uniaxial_waves(m, f, p2, backward, known, known_p);
}

// The waves of the path where it meets the face, amplitudes in the columns of its Jones matrix. pair: the face's own
// waves of medium 1, for a path that carries both.
FUNCTION Incident incident_waves(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const FaceAxes* f,
                                 PRIVATE const WaveMedium* m, real p1, PRIVATE const WavePair* pair,
                                 PRIVATE Gathered* sum) {
  Incident in;
  in.count = path->carries == CARRIES_ANY || path->carries == CARRIES_PAIR ? 2 : 1;
  if (path->carries == CARRIES_ANY) {
    cplx p = complex_of(p1, lanes(0));
    in.mode[0] = s_mode(f->q, p);
    in.mode[1] = p_mode(f->q, p, m->n);
  } else if (has(coherent_waves, view) && path->carries == CARRIES_PAIR) {
    in.mode[0] = pair->mode[0];
    in.mode[1] = pair->mode[1];
    pair_on_face(view, path, f, in.mode, sum);
  } else {
    cvec3 e, h, d = unit_d(path->axis, cross3(path->axis, wave_normal(path->k)), path->ellipse, 0);
    fields_of_wave(m, path->k, d.re, d.im, &e, &h);
    in.mode[0] = in.mode[1] = mode_of_fields(f, path->k, e, h);
  }
  return in;
}

// What rounding may leave of R + T - 1 before the powers are shared out: the incident flux is known to eps/p1^2; waves
// of active crystals are first order in the gyration.
FUNCTION real energy_tolerance(real p1, int active) {
  real inverse = lanes(1) / (p1 * p1 + lanes(1e-12f));
  if (sizeof(scalar) != 8) return lanes(1e-2f) + lanes(1e-5f) * inverse;
  return active ? lanes(1e-5f) + lanes(1e-8f) * inverse : lanes(1e-9f) + lanes(1e-13f) * inverse;
}

// Splits the path, which stands on the face, into `reflected` and `refracted` ones. Those keep position and cell of
// `back` and `through`, where they start.
FUNCTION void split_waves(PRIVATE const SceneView* view, PRIVATE Path* path, Interface face, PRIVATE const Path* back,
                          PRIVATE const Path* through, PRIVATE Children* reflected, PRIVATE Children* refracted,
                          PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  int fallbacks = 0;
  mask live = path_weight(view, &path->jones) > lanes(0);
  WaveMedium m1 = wave_medium(view, face.medium1), m2 = wave_medium(view, face.medium2);
  vec3 k = path->carries == CARRIES_ANY ? scale3(m1.n, path->ray.direction) : path->k;
  FaceAxes f = axes_of_face(face.normal, k);
  real p1 = dot3(k, face.normal);
  // eps - q^2 of both sides, from p1 and eps - |k|^2
  int on_reference = path->carries == CARRIES_ANY || path->carries == CARRIES_ORDINARY;
  if (on_reference) p1 = pick(p1 > LEAST_P1, p1, LEAST_P1);
  real delta = spectral(view, pair_row(view, face.medium1, face.medium2));
  real square1 = on_reference ? p1 * p1 : (m1.n - f.q) * (m1.n + f.q);
  real square2 = on_reference ? p1 * p1 + delta : (m2.n - f.q) * (m2.n + f.q);
  if (path->carries == CARRIES_ONE) {
    cvec3 d = unit_d(path->axis, cross3(path->axis, wave_normal(path->k)), path->ellipse, 0);
    real bracket = bracket_of_wave(&m1, path->k, d.re, d.im);
    square1 = fma_of(p1, p1, bracket);
    square2 = fma_of(p1, p1, bracket + delta);
  }
  int known = path->carries == CARRIES_ANY ? 2 : path->carries == CARRIES_ORDINARY ? 0 : -1;
  real known_p = -p1;
  if (m1.kind == WAVES_UNIAXIAL && path->carries == CARRIES_ONE) {
    known = 1;
    known_p = reflected_extraordinary_root(&m1, &f, p1);
  }
  // one call for all three, because every call is a copy of the solvers: reflected, refracted, and incident where both
  // waves are
  WavePair pairs[3];
  int sides = has(coherent_waves, view) && path->carries == CARRIES_PAIR ? 3 : 2;
  for (int i = 0; i < sides; ++i)
    pairs[i] = waves_away(view, i == 1 ? &m2 : &m1, &f, i == 1 ? square2 : square1, i == 0, i == 0 ? known : -1,
        known_p, live, &fallbacks);
  Incident in = incident_waves(view, path, &f, &m1, p1, &pairs[2], sum);
  FaceAmplitudes a = face_amplitudes(in.mode, in.count, &pairs[0], &pairs[1]);
  sum->energy_off = sum->energy_off | (live & (abs_of(a.off[0]) > energy_tolerance(p1, m1.active || m2.active)));
  if (fallbacks) add_event(counters, COUNT_FALLBACK, (event_count)fallbacks);
  reflected->count = refracted->count = 0;
  for (int side = 0; side < 2; ++side) {
    cplx amplitude[2][2];
    for (int w = 0; w < 2; ++w) {
      for (int r = 0; r < jones_rows(view); ++r) {
        cplx a0 = side ? a.t[0][w] : a.r[0][w];
        amplitude[w][r] = cmul(path->jones.e[r], a0);
        cplx a1 = side ? a.t[1][w] : a.r[1][w];
        if (in.count == 2) amplitude[w][r] = cadd(amplitude[w][r], cmul(path->jones.f[r], a1));
        amplitude[w][r] = cpick(live, amplitude[w][r], complex_of(lanes(0), lanes(0)));
      }
    }
    send(view, side ? through : back, &f, side ? &m2 : &m1, &pairs[side], amplitude, side ? refracted : reflected, sum);
  }
}

#endif
