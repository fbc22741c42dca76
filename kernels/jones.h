// Jones matrices along a path that is traced from the camera.
//
// A path carries the matrix J that maps the field of light at its far end to the field at the camera.
// J acts on (E_e, E_f): e is a unit vector across the path's direction d, f = e x d. Light runs along -d, so
// (e, f, -d) is right-handed, as (x, y, towards the viewer) is in kernels/README.md. Each event on the way
// out multiplies J from the right by the event's matrix for light on the way in (the same matrix,
// by reciprocity: physics of README.md, "Tracing backwards").
// With an analyzer at the camera J has rank one: only its first row is kept (feature full_jones off).
// Without polarization (feature off) row[0][0] is the intensity weight and nothing else is used.
#ifndef NICOL_JONES_H
#define NICOL_JONES_H
#include "scene_view.h"
#include "vec3.h"

typedef struct {
  cplx e[2], f[2];  // columns: response to E_e and to E_f, for row 0 (camera x) and row 1 (camera y)
} Jones;

#define jones_rows(view) (has(full_jones, view) ? 2 : 1)

// Share of unpolarized light's intensity that the path passes: half the sum of |J|^2.
FUNCTION real path_weight(PRIVATE const SceneView* view, PRIVATE const Jones* j) {
  if (!has(polarization, view)) return j->e[0].re;
  real w = norm2(j->e[0]) + norm2(j->f[0]);
  if (has(full_jones, view)) w += norm2(j->e[1]) + norm2(j->f[1]);
  return lanes(0.5) * w;
}

// J for axes turned by the angle whose cosine and sine are given, from e towards f.
FUNCTION void turn_axes(PRIVATE const SceneView* view, PRIVATE Jones* j, real c, real s) {
  for (int r = 0; r < jones_rows(view); ++r) {
    cplx e = j->e[r], f = j->f[r];
    j->e[r] = complex_of(c * e.re + s * f.re, c * e.im + s * f.im);
    j->f[r] = complex_of(c * f.re - s * e.re, c * f.im - s * e.im);
  }
}

FUNCTION void scale_jones(PRIVATE const SceneView* view, PRIVATE Jones* j, real amplitude) {
  for (int r = 0; r < jones_rows(view); ++r) {
    j->e[r] = cscale(amplitude, j->e[r]);
    j->f[r] = cscale(amplitude, j->f[r]);
  }
}

// J diag(a_e, a_f).
FUNCTION Jones times_diagonal(PRIVATE const SceneView* view, PRIVATE const Jones* j, cplx a_e, cplx a_f) {
  Jones out = *j;
  for (int r = 0; r < jones_rows(view); ++r) {
    out.e[r] = cmul(j->e[r], a_e);
    out.f[r] = cmul(j->f[r], a_f);
  }
  return out;
}

// J diag(a_e, a_f) for real amplitudes.
FUNCTION Jones times_real_diagonal(PRIVATE const SceneView* view, PRIVATE const Jones* j, real a_e, real a_f) {
  Jones out = *j;
  for (int r = 0; r < jones_rows(view); ++r) {
    out.e[r] = cscale(a_e, j->e[r]);
    out.f[r] = cscale(a_f, j->f[r]);
  }
  return out;
}

// Zero in the lanes where m does not hold: a lane is dead when its J is zero.
FUNCTION Jones keep_lanes(PRIVATE const SceneView* view, mask m, Jones j) {
  cplx zero = complex_of(lanes(0), lanes(0));
  for (int r = 0; r < jones_rows(view); ++r) {
    j.e[r] = cpick(m, j.e[r], zero);
    j.f[r] = cpick(m, j.f[r], zero);
  }
  return j;
}

#endif
