// One problem answered with the physics that renders: a face, the waves in the bulk, a field carried through it.
#ifndef NICOL_PROBE_H
#define NICOL_PROBE_H
#include "probe_bulk.h"

FUNCTION void solve_face(GLOBAL const scalar* problem, GLOBAL scalar* answer) {
  GLOBAL const scalar* medium1 = problem + PROBE_MEDIUM1;
  GLOBAL const scalar* medium2 = problem + PROBE_MEDIUM2;
  FaceProblem f = read_problem(problem);
  answer[ANSWER_FALLBACKS] = 0;
  if (medium1[PROBE_MEDIUM_KIND] == WAVES_ISOTROPIC && medium2[PROBE_MEDIUM_KIND] == WAVES_ISOTROPIC) {
    solve_isotropic(problem, answer, &f);
  } else if (medium1[PROBE_MEDIUM_ABSORBS] != 0 || medium2[PROBE_MEDIUM_ABSORBS] != 0) {
    solve_absorbing(problem, answer, &f);
  } else {
    solve_transparent(problem, answer, &f);
  }
}

FUNCTION void solve_problem(GLOBAL const scalar* problem, GLOBAL scalar* answer) {
  if (problem[PROBE_TASK] == PROBE_FACE) {
    solve_face(problem, answer);
  } else if (problem[PROBE_TASK] == PROBE_BULK) {
    solve_bulk(problem, answer);
  } else {
    solve_propagation(problem, answer);
  }
}

#endif
