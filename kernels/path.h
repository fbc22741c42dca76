// A path traced from the camera, what it gathers, and what lights give it.
#ifndef NICOL_PATH_H
#define NICOL_PATH_H
#include "element.h"
#include "hit.h"
#include "jones.h"
#include "optical_rotation.h"
#include "polarizer.h"

// The waves that a path stands for. In an isotropic medium: any polarization, in the axes (e, f). In a crystal: one
// eigenwave, or both of a direction as amplitudes. Wave 0 has D along c e + i s f, wave 1 along i s e + c f, with c^2 + s^2 = 1,
// f = e x k/|k|; the columns e and f of the Jones matrix are the responses to wave 0 and wave 1 (one wave: column e is its own).
enum { CARRIES_ANY = 0, CARRIES_ONE, CARRIES_ORDINARY, CARRIES_PAIR };

typedef struct {
  Ray ray;
  vec3 axis;    // e of jones.h; f = axis x direction (in a crystal: x wave normal)
  vec3 k;       // in a crystal: wave vector in units of k0 (of a pair: the mean)
  real ellipse; // in a crystal: s
  real gap;     // of a pair: what wave 1's phase gains over wave 0's, in wavelengths of vacuum per length along the ray
  int carries;
  Jones jones;
  int level;    // faces met so far
  int pinned;   // patch whose cell the ray enters next, without a way to go; -1: none
} Path;

// The path as it is in an isotropic medium.
FUNCTION void carry_any(PRIVATE Path* path) {
  path->carries = CARRIES_ANY;
  path->k = path->ray.direction;
  path->ellipse = path->gap = lanes(0);
}

// Stokes radiance in the axes of the path's start, and the weight that was cut off. `lost` is what rounding
// took from the sums so far: a tree may bring 1e6 small terms (Kahan, Commun. ACM 8, 40 (1965)).
typedef struct {
  real stokes[4], lost[4];
  real cut_off, lost_cut_off;
  lane_int signature;  // of what the sample's paths met
  mask energy_off;  // a face gave R + T off 1
  mask cones;       // a path met the binormal of a crystal: its light depends on the azimuth taken there
} Gathered;

FUNCTION void add_compensated(PRIVATE real* sum, PRIVATE real* lost, real value) {
  real term = value - *lost;
  real total = *sum + term;
  *lost = (total - *sum) - term;
  *sum = total;
}

FUNCTION void add_stokes(PRIVATE Gathered* sum, int s, real value) {
  add_compensated(&sum->stokes[s], &sum->lost[s], value);
}

FUNCTION void add_cut_off(PRIVATE Gathered* sum, real weight) {
  add_compensated(&sum->cut_off, &sum->lost_cut_off, weight);
}

// What a path's lanes meet, into the signature of their sample: where samples have the same they saw the same faces and waves, so that
// light changes smoothly from one to the other. Faint lanes do not count, nor does the order. 30 bits, no overflow.
#define SIGNATURE_WEIGHT lanes(1e-3f)
FUNCTION void sign(PRIVATE const SceneView* view, PRIVATE const Path* path, mask bright, lane_int key, lane_int face,
                   lane_int patch, PRIVATE Gathered* sum) {
  int where = (path->level * 127 + path->carries * 31 + path->ray.cell * 17) & 0xffff;
  lane_int met = (key + lane_ints(2)) * lane_ints(241) ^ (patch + lane_ints(2)) * lane_ints(53);
  mask on_face = (key >= lane_ints(KEY_EXIT)) & (key < lane_ints(key_of_sheet(view, 0)));
  met = (met ^ pick(on_face, (face & lane_ints(0x7fff)) * lane_ints(8191), lane_ints(0))) + lane_ints(where);
  lane_int mixed = (met & lane_ints(0x7fff)) * lane_ints(30011) + ((met >> 15) & lane_ints(0x7fff)) * lane_ints(20479);
  mixed = mixed ^ (mixed >> 9);
  sum->signature = (sum->signature + pick(bright, mixed, lane_ints(0))) & lane_ints(0x3fffffff);
}

FUNCTION vec3 second_axis(PRIVATE const Path* path) { return cross3(path->axis, path->ray.direction); }

// J M for an element: `m` in the axes that it was asked for, the path's own having been turned to a->u.
FUNCTION void times_element(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const ElementAxes* a, JonesMatrix m) {
  if (!has(polarization, view)) {
    path->jones.e[0].re *= lanes(0.5) * (norm2(m.ss) + norm2(m.sp) + norm2(m.ps) + norm2(m.pp));
    return;
  }
  cplx turn = renew_phase(complex_of(dot3(path->axis, a->u), dot3(second_axis(path), a->u)));
  turn_axes(view, &path->jones, turn.re, turn.im);
  path->axis = a->u;
  for (int r = 0; r < jones_rows(view); ++r) {
    cplx e = path->jones.e[r], f = path->jones.f[r];
    path->jones.e[r] = csub(cmul(e, m.ss), cmul(f, m.ps));
    path->jones.f[r] = csub(cmul(f, m.pp), cmul(e, m.sp));
  }
}

// Index of the medium that the path is in.
FUNCTION real index_around(PRIVATE const SceneView* view, PRIVATE const Path* path) {
  return spectral(view, medium_row(view, cell_of(view, path->ray.cell)[CELL_MEDIUM], MEDIUM_ROW_N));
}

FUNCTION void pass_element(PRIVATE const SceneView* view, PRIVATE Path* path, int polarizer) {
  vec3 d = path->ray.direction;
  ElementAxes a = element_axes(view, polarizer, d);
  times_element(view, path, &a, element_matrices(view, polarizer, &a, scale3(lanes(-1), d), index_around(view, path)).t);
}

// The path goes back from the element: what comes along it was thrown back.
FUNCTION void reflect_off_element(PRIVATE const SceneView* view, PRIVATE Path* path, int polarizer) {
  vec3 d = path->ray.direction;
  ElementAxes a = element_axes(view, polarizer, d);
  vec3 mirrored = renew_unit(along(lanes(-2) * dot3(d, a.forward), a.forward, d));
  times_element(view, path, &a, element_matrices(view, polarizer, &a, scale3(lanes(-1), mirrored), index_around(view, path)).r);
  path->ray.direction = mirrored;
}

// Adds the intensities of one row-pair of fields (a at the camera's x, b at y), times `half_radiance`.
FUNCTION void gather_fields(PRIVATE const SceneView* view, real half_radiance, cplx a, cplx b, PRIVATE Gathered* sum) {
  real xx = half_radiance * norm2(a);
  if (!has(full_jones, view)) {
    add_stokes(sum, 0, xx);
    sum->stokes[1] = sum->stokes[0];  // what an analyzer passes is polarized along it
    return;
  }
  real yy = half_radiance * norm2(b);
  cplx xy = cmul(a, conj_of(b));
  add_stokes(sum, 0, xx + yy);
  add_stokes(sum, 1, xx - yy);
  add_stokes(sum, 2, lanes(2) * half_radiance * xy.re);
  add_stokes(sum, 3, lanes(2) * half_radiance * xy.im);  // > 0 right circular
}

// Unpolarized radiance.
FUNCTION void gather_unpolarized(PRIVATE const SceneView* view, PRIVATE const Path* path, real radiance,
                                 PRIVATE Gathered* sum) {
  if (!has(polarization, view)) {
    add_stokes(sum, 0, radiance * path->jones.e[0].re);
    return;
  }
  gather_fields(view, lanes(0.5) * radiance, path->jones.e[0], path->jones.e[1], sum);
  gather_fields(view, lanes(0.5) * radiance, path->jones.f[0], path->jones.f[1], sum);
}

FUNCTION void gather_light(PRIVATE const SceneView* view, PRIVATE const Path* path, int light, mask where,
                           PRIVATE Gathered* sum) {
  WITNESS(ends_at_light(path->ray.cell, path->carries == CARRIES_PAIR, path_weight(view, &path->jones), light, where));
  GLOBAL const int* record = view->lights + light * LIGHT_INTS;
  real radiance = pick(where, spectral(view, record[LIGHT_ROW]), lanes(0));
  int polarizer = record[LIGHT_POLARIZER];
  if (has_elements(view) && polarizer >= 0 && is_element(view, polarizer)) {
    Path behind = *path;
    pass_element(view, &behind, polarizer);
    gather_unpolarized(view, &behind, radiance, sum);
    return;
  }
  if ((has(ideal_polarizer, view) || has(calcite_polarizer, view)) && polarizer >= 0) {
    PassingState state = passing_state(view, polarizer, path->ray.direction);
    real passed = radiance * state.amplitude * state.amplitude;
    if (!has(polarization, view)) {
      add_stokes(sum, 0, lanes(0.5) * passed * path->jones.e[0].re);
      return;
    }
    real me = dot3(state.axis, path->axis), mf = dot3(state.axis, second_axis(path));
    cplx a = cadd(cscale(me, path->jones.e[0]), cscale(mf, path->jones.f[0])), b = a;
    if (has(full_jones, view)) b = cadd(cscale(me, path->jones.e[1]), cscale(mf, path->jones.f[1]));
    gather_fields(view, lanes(0.5) * passed, a, b, sum);
    return;
  }
  gather_unpolarized(view, path, radiance, sum);
}

FUNCTION void gather_sky(PRIVATE const SceneView* view, PRIVATE const Path* path, mask where, PRIVATE Gathered* sum) {
  WITNESS(ends_at_sky(path->ray.cell, path->carries == CARRIES_PAIR, path_weight(view, &path->jones), where));
  real radiance = spectral(view, view->header[HEADER_SKY_ROW]);
  gather_unpolarized(view, path, pick(where, radiance, lanes(0)), sum);
}

// A light on a sheet is seen from its front, or from both sides.
FUNCTION mask shines_towards(PRIVATE const SceneView* view, PRIVATE const Path* path, int light, vec3 outward) {
  mask front = dot3(outward, path->ray.direction) < lanes(0);
  return view->lights[light * LIGHT_INTS + LIGHT_ONE_SIDED] ? front : (front | not_mask(front));
}

// J M for a polarizer: the path goes on in the state that passes.
FUNCTION void pass_polarizer(PRIVATE const SceneView* view, PRIVATE Path* path, int polarizer) {
  WITNESS(passes_polarizer(polarizer));
  if (has_elements(view) && is_element(view, polarizer)) {
    pass_element(view, path, polarizer);
    return;
  }
  PassingState state = passing_state(view, polarizer, path->ray.direction);
  if (!has(polarization, view)) {
    path->jones.e[0].re = lanes(0.5) * state.amplitude * state.amplitude * path->jones.e[0].re;
    return;
  }
  real me = dot3(state.axis, path->axis), mf = dot3(state.axis, second_axis(path));
  for (int r = 0; r < jones_rows(view); ++r) {
    cplx passed = cadd(cscale(me, path->jones.e[r]), cscale(mf, path->jones.f[r]));
    path->jones.e[r] = cscale(state.amplitude, passed);
    path->jones.f[r] = complex_of(lanes(0), lanes(0));
  }
  path->axis = state.axis;
}

FUNCTION int is_live(PRIVATE const SceneView* view, PRIVATE const Path* path) {
  return any_lane(path_weight(view, &path->jones) > lanes(0));
}

// Drops the lanes at or under adc_bailout, and all at max_trace_level, into the cut-off; says if any is left.
FUNCTION int keep_bright(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE Gathered* sum,
                         GLOBAL event_count* counters) {
  real w = path_weight(view, &path->jones);
  mask bright = w > lanes(view->adc_bailout);
  if (path->level >= view->max_trace_level) bright = w > FAR_MM;
  if (any_lane(w != w)) count_event(counters, COUNT_NAN);
  mask dropped = (w > lanes(0)) & not_mask(bright);
  add_cut_off(sum, pick(dropped, w, lanes(0)));
  path->jones = keep_lanes(view, bright, path->jones);
  return any_lane(bright);
}

#endif
