// A polarizing element of a plugin on the way of a traced ray: the fragment's input, and its matrices in the axes of the path.
//
// Light runs against the traced ray: along -d where the element passes it, and along -d' where it throws it back, d' the mirrored ray.
// For traced rays the plane of incidence has u = N x t as fresnel.h has it; light that passes has s = u and p = -(u x d), light that is
// thrown back s = -u and p = u x d' in, u x d out. So in the axes (u, u x d) both matrices are the fragment's with the signs of sp and
// ps turned. The fragment is asked for the very light at hand: nothing is taken from reciprocity.
// Test: tests/fragments/element_test.cpp.
#ifndef NICOL_ELEMENT_H
#define NICOL_ELEMENT_H
#include "scene_fragments.h"
#include "scene_view.h"

#define has_elements(view) (FRAGMENTS_HERE && has(fragment_elements, view))
#define has_surfaces(view) (FRAGMENTS_HERE && has(fragment_surfaces, view))

FUNCTION int is_element(PRIVATE const SceneView* view, int polarizer) {
  return view->polarizers[polarizer * POLARIZER_INTS + POLARIZER_KIND] == POLARIZER_FRAGMENT;
}

FUNCTION GLOBAL const int* fragment_use(PRIVATE const SceneView* view, int use) {
  return view->fragments + use * FRAGMENT_INTS;
}

FUNCTION real wavelength_nm(PRIVATE const SceneView* view) {
  return lanes(1e6f) / spectral(view, view->header[HEADER_WAVELENGTH_ROW]);
}

typedef struct {
  vec3 x, y, z;   // of the element, in the world
  vec3 forward;   // its normal, along the ray
  vec3 u;         // across the plane of incidence
} ElementAxes;

FUNCTION ElementAxes element_axes(PRIVATE const SceneView* view, int polarizer, vec3 d) {
  GLOBAL const scalar* reals = view->polarizer_reals + polarizer * POLARIZER_REALS;
  ElementAxes a;
  a.x = broadcast(reals + POLARIZER_AXIS);
  a.z = broadcast(reals + POLARIZER_NORMAL);
  a.y = cross3(a.z, a.x);
  a.forward = pick3(dot3(d, a.z) < lanes(0), scale3(lanes(-1), a.z), a.z);
  real tx = dot3(d, a.x), ty = dot3(d, a.y);
  real q2 = tx * tx + ty * ty;
  mask tilted = q2 > lanes(0);
  real inverse = lanes(1) / sqrt_of(pick(tilted, q2, lanes(1)));
  tx = pick(tilted, tx * inverse, lanes(-1));   // of the light: +x
  ty = pick(tilted, ty * inverse, lanes(0));
  a.u = cross3(a.forward, add3(scale3(tx, a.x), scale3(ty, a.y)));
  return a;
}

#define LEAST_ELEMENT_COSINE lanes(1e-6f)

// The fragment's input for light along `direction` (of the element's axes).
FUNCTION ElementIn element_input(real lambda_nm, real n, vec3 direction) {
  ElementIn in;
  in.lambda_nm = lambda_nm;
  in.n = n;
  in.direction = direction;
  in.cosine = pick(abs_of(direction.z) > LEAST_ELEMENT_COSINE, abs_of(direction.z), LEAST_ELEMENT_COSINE);
  real side = pick(direction.z < lanes(0), lanes(-1), lanes(1));
  real q2 = direction.x * direction.x + direction.y * direction.y;
  mask tilted = q2 > lanes(0);
  real inverse = lanes(1) / sqrt_of(pick(tilted, q2, lanes(1)));
  real tx = pick(tilted, direction.x * inverse, lanes(1)), ty = pick(tilted, direction.y * inverse, lanes(0));
  in.s = vec(-side * ty, side * tx, lanes(0));
  in.p = cross3(in.s, direction);
  in.p_reflected = cross3(in.s, vec(direction.x, direction.y, -direction.z));
  return in;
}

FUNCTION ElementOut element_matrices(PRIVATE const SceneView* view, int polarizer, PRIVATE const ElementAxes* a, vec3 light,
                                     real n) {
  GLOBAL const int* use = fragment_use(view, view->polarizers[polarizer * POLARIZER_INTS + POLARIZER_USE]);
  ElementIn in = element_input(wavelength_nm(view), n, vec(dot3(light, a->x), dot3(light, a->y), dot3(light, a->z)));
  ElementOut out;
  out.t = out.r = no_light();
  run_element(use[FRAGMENT_INDEX], &in, view->fragment_reals + use[FRAGMENT_FIRST], &out);
  return out;
}

// Whether light off the element is traced.
FUNCTION int reflects(PRIVATE const SceneView* view, int polarizer) {
  return has_elements(view) && is_element(view, polarizer) &&
         fragment_use(view, view->polarizers[polarizer * POLARIZER_INTS + POLARIZER_USE])[FRAGMENT_REFLECTS];
}

#endif
