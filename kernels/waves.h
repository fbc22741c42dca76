// The two plane waves of any transparent medium that leave a face, and all that goes with them: amplitudes at the face
// (boundary.h), waves in the bulk (section.h).
#ifndef NICOL_WAVES_H
#define NICOL_WAVES_H
#include "boundary.h"
#include "general_waves.h"
#include "section.h"
#include "uniaxial.h"

// The two waves of m that run away from the face: to +N (backward = 0) or to -N (backward = 1), fields in (t, u, N),
// of any finite length; evanescent waves have Im p != 0.
// p2: m.eps - q^2, computed without cancellation: fma(p1, p1, m.eps - |k|^2), the bracket from the host or from
// bracket_of_wave. known: the mode (0, 1; 2 both, of an isotropic medium; -1 none) whose root known_p is known from
// the incident wave (the N component of the reflected wave vector). live: lanes that count, the others hold anything
// finite.
// *fallbacks grows by the number of waves that took the precise way.
FUNCTION WavePair waves_of_face(PRIVATE const WaveMedium* m, PRIVATE const FaceAxes* f, real p2, int backward,
    int known,
                                real known_p, mask live, PRIVATE int* fallbacks) {
  if (m->kind == WAVES_ISOTROPIC) return isotropic_waves(m, f, p2, backward, known, known_p);
  if (m->kind == WAVES_UNIAXIAL) return uniaxial_waves(m, f, p2, backward, known, known_p);
  if (m->kind == WAVES_CHIRAL) return chiral_waves(m, f, p2, backward, known, known_p);
  return general_waves(m, f, p2, backward, live, fallbacks);
}

#endif
