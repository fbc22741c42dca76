// The waves of a medium on one side of a face, as paths that go on from there: one path in an isotropic medium (s and p
// together); in a crystal one path per eigenwave, or one for both where they cannot be told apart, or shares of each
// (crystal_path.h says when). Test: tests/kernels/crystal_*_test.cpp.
#ifndef NICOL_SEND_WAVES_H
#define NICOL_SEND_WAVES_H
#include "crystal_path.h"
#include "interface.h"
#include "path_stack.h"

// three on either side: a pair and two single waves
enum { MOST_CHILDREN = 6 };

typedef struct {
  Path paths[MOST_CHILDREN];
  int count;
} Children;

// Dead lanes get something finite to carry.
FUNCTION void tame_dead_lanes(PRIVATE const SceneView* view, PRIVATE Path* path) {
  mask live = path_weight(view, &path->jones) > lanes(0);
  vec3 z = vec(lanes(0), lanes(0), lanes(1));
  path->ray.direction = pick3(live, path->ray.direction, z);
  path->k = pick3(live, path->k, z);
  path->axis = pick3(live, path->axis, vec(lanes(1), lanes(0), lanes(0)));
  path->ellipse = pick(live, path->ellipse, lanes(0));
  path->gap = pick(live, path->gap, lanes(0));
}

// amplitude[wave][row] of the two waves of an isotropic medium: one path.
FUNCTION void send_isotropic(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const FaceAxes* f,
                             PRIVATE const WaveMedium* m, PRIVATE const WavePair* waves, cplx amplitude[2][2],
                                 PRIVATE Children* out) {
  PRIVATE Path* path = &out->paths[out->count++];
  *path = *from;
  path->axis = f->u;
  mask runs = waves->mode[0].p.im == lanes(0);
  real inverse_n = lanes(1) / m->n;
  vec3 d = add3(scale3(f->q * inverse_n, f->t), scale3(waves->mode[0].p.re * inverse_n, f->n));
  path->ray.direction = pick3(runs, renew_unit(d), f->n);
  carry_any(path);
  for (int r = 0; r < jones_rows(view); ++r) {
    path->jones.e[r] = amplitude[0][r];
    path->jones.f[r] = amplitude[1][r];
  }
  path->jones = keep_lanes(view, runs, path->jones);
  tame_dead_lanes(view, path);
}

// What a wave is, seen from the medium: its wave vector, unit D, ray.
typedef struct {
  vec3 k, ray;
  cvec3 d;
  mask runs;  // not evanescent
} Wave;

FUNCTION Wave wave_of_mode(PRIVATE const FaceAxes* f, PRIVATE const Mode* mode) {
  Wave w;
  w.runs = mode->p.im == lanes(0);
  w.k = add3(scale3(f->q, f->t), scale3(mode->p.re, f->n));
  vec3 er = vec(mode->e[0].re, mode->e[1].re, mode->e[2].re), ei = vec(mode->e[0].im, mode->e[1].im, mode->e[2].im);
  vec3 hr = vec(mode->h[0].re, mode->h[1].re, mode->h[2].re), hi = vec(mode->h[0].im, mode->h[1].im, mode->h[2].im);
  vec3 flow = add3(cross3(er, hr), cross3(ei, hi));
  real size2 = dot3(flow, flow);
  w.runs = w.runs & (size2 > lanes(0));
  w.ray = pick3(w.runs, to_world(f, scale3(lanes(1) / sqrt_of(pick(w.runs, size2, lanes(1))), flow)), f->n);
  w.k = pick3(w.runs, w.k, f->n);
  w.d = displacement(f, mode);
  return w;
}

// Where a crystal's ray leaves it or meets what is inside.
FUNCTION Hit next_exit(PRIVATE const SceneView* view, PRIVATE const Ray* ray) {
  if (has(nested_solids, view)) return next_hit(view, ray);
  Hit hit = no_hit(ray);
  meet_exits(view, ray, &hit);
  return hit;
}

// Size in mm of a pixel where the path stands, seen straight from the camera.
FUNCTION real footprint_mm(PRIVATE const SceneView* view, PRIVATE const Ray* ray) {
  vec3 away = sub3(add3(ray->position, cell_centre(view, ray->cell)), broadcast(view->camera + CAMERA_LOCATION));
  return lanes(view->camera[CAMERA_FOOTPRINT]) + lanes(view->camera[CAMERA_FOOTPRINT + 1]) * sqrt_of(dot3(away, away));
}

// sin(pi x)/(pi x) up to its first zero, 0 beyond: even polynomial, error below 2e-4.
FUNCTION real fringe_contrast(real x) {
  real y = x * x;
  real c = lanes(0.0261478f) - y * lanes(0.0023461f);
  c = lanes(1) + y * (lanes(-1.644934f) + y * (lanes(0.8117424f) + y * (lanes(-0.1907518f) + y * c)));
  return pick((y < lanes(1)) & (c > lanes(0)), c, lanes(0));
}

// Share of the light in which two waves add as amplitudes.
FUNCTION real coherent_share(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const Wave* w, real gap,
                             mask both) {
  Ray mean = from->ray;
  mean.direction = pick3(both, unit3(add3(w[0].ray, w[1].ray)), w[0].ray);
  Hit exit = next_exit(view, &mean);
  real depth = exit.depth_mm, footprint = footprint_mm(view, &from->ray);
  vec3 apart = sub3(w[1].ray, w[0].ray);
  real walk_off = sqrt_of(dot3(apart, apart)) * depth / footprint;
  real overlap = pick(walk_off < lanes(1), lanes(1) - walk_off, lanes(0));
  int row = view->header[HEADER_WAVELENGTH_ROW];
  real per_mm = spectral(view, row);
  real drift = abs_of(gap) * depth * per_mm * spectral(view, row + 1);
  // tangential wave vectors at the face where they leave
  vec3 change = sub3(w[1].k, w[0].k);
  change = along(-dot3(change, exit.normal), exit.normal, change);
  real change_q = sqrt_of(dot3(change, change)), p = lanes(0.5f) * dot3(add3(w[0].k, w[1].k), exit.normal);
  real bend = change_q / (lanes(0.02f) * p * p + lanes(1e-9f));
  overlap = overlap * pick(bend < lanes(1), lanes(1) - bend, lanes(0));
  real contrast = fringe_contrast(drift) * fringe_contrast(change_q * footprint * per_mm);
  real share = (overlap * contrast - lanes(0.1f)) * lanes(1.25f);
  share = pick(share > lanes(0), pick(share < lanes(1), share, lanes(1)), lanes(0));
  return pick(both, share, lanes(0));
}

// One path for both waves, with the share mu of their light.
FUNCTION void send_pair(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const Wave* w, real gap,
                        cplx amplitude[2][2], real mu, PRIVATE Children* out) {
  PRIVATE Path* path = &out->paths[out->count++];
  *path = *from;
  path->carries = CARRIES_PAIR;
  path->k = scale3(lanes(0.5f), add3(w[0].k, w[1].k));
  path->ray.direction = unit3(add3(w[0].ray, w[1].ray));
  path->gap = gap;
  vec3 normal = wave_normal(path->k);
  cplx phase[2];
  path->axis = any_across(normal);
  cvec3 d0 = half_across(unit_complex(w[0].d), unit_complex(w[1].d));
  phase[0] = polarization_axes(d0, normal, &path->axis, &path->ellipse);
  phase[1] = unit_phase(inner(unit_d(path->axis, cross3(path->axis, normal), path->ellipse, 1), w[1].d));
  real root = sqrt_of(mu);
  for (int r = 0; r < jones_rows(view); ++r) {
    path->jones.e[r] = cscale(root, cmul(amplitude[0][r], phase[0]));
    path->jones.f[r] = cscale(root, cmul(amplitude[1][r], phase[1]));
  }
  path->jones = keep_lanes(view, mu > lanes(0), path->jones);
  tame_dead_lanes(view, path);
}

FUNCTION void send_single(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const Wave* w,
                          PRIVATE const cplx* amplitude, real share, int carries, PRIVATE Children* out) {
  PRIVATE Path* path = &out->paths[out->count++];
  *path = *from;
  path->carries = carries;
  path->k = w->k;
  path->ray.direction = w->ray;
  vec3 normal = wave_normal(path->k);
  path->axis = any_across(normal);
  polarization_axes(w->d, normal, &path->axis, &path->ellipse);
  real root = sqrt_of(share);
  for (int r = 0; r < jones_rows(view); ++r) {
    path->jones.e[r] = cscale(root, amplitude[r]);
    path->jones.f[r] = complex_of(lanes(0), lanes(0));
  }
  path->jones = keep_lanes(view, w->runs & (share > lanes(0)), path->jones);
  tame_dead_lanes(view, path);
}

// Where the wave normals that a ray stands for hold a binormal (sheets gap = n |r1 - r0| delta apart at the angle delta
// from it), the two waves of an azimuth of the cone stand for all: any orthonormal pair of D does.
FUNCTION void take_azimuth(PRIVATE const SceneView* view, PRIVATE const WaveMedium* m, PRIVATE Wave* w, real gap,
                           cplx amplitude[2][2],
                           PRIVATE Gathered* sum) {
  vec3 apart = sub3(w[1].ray, w[0].ray);
  real opening = sqrt_of(dot3(apart, apart));
  mask here = w[0].runs & w[1].runs & (opening > lanes(1e-4f)) &
              (abs_of(gap) < lanes(view->conical_spread) * opening);
  if (!any_lane(here)) return;
  sum->cones = sum->cones | here;
  WITNESS(meets_cone());
  vec3 normal = wave_normal(scale3(lanes(0.5f), add3(w[0].k, w[1].k)));
  vec3 e = any_across(normal);
  real s = lanes(0);
  polarization_axes(w[0].d, normal, &e, &s);
  vec3 f = cross3(e, normal);
  real c = view->conical_cos, sine = view->conical_sin;
  vec3 axis[2];
  axis[0] = add3(scale3(c, e), scale3(sine, f));
  axis[1] = sub3(scale3(c, f), scale3(sine, e));
  cplx turned[2][2];
  for (int i = 0; i < 2; ++i) {
    cvec3 d;
    d.re = axis[i];
    d.im = scale3(lanes(0), axis[i]);
    cplx on0 = inner(d, unit_complex(w[0].d)), on1 = inner(d, unit_complex(w[1].d));
    for (int r = 0; r < jones_rows(view); ++r) turned[i][r] = cadd(cmul(on0, amplitude[0][r]), cmul(on1,
        amplitude[1][r]));
  }
  for (int i = 0; i < 2; ++i) {
    cvec3 e_field, h_field, d;
    d.re = axis[i];
    d.im = scale3(lanes(0), axis[i]);
    fields_of_wave(m, w[i].k, d.re, d.im, &e_field, &h_field);
    w[i].ray = pick3(here, ray_of_fields(&e_field, &h_field), w[i].ray);
    w[i].d.re = pick3(here, d.re, w[i].d.re);
    w[i].d.im = pick3(here, d.im, w[i].d.im);
    for (int r = 0; r < jones_rows(view); ++r) amplitude[i][r] = cpick(here, turned[i][r], amplitude[i][r]);
  }
}

// Share of unpolarized light's intensity in one wave.
FUNCTION real wave_weight(PRIVATE const SceneView* view, PRIVATE const cplx* amplitude) {
  real w = norm2(amplitude[0]);
  if (has(full_jones, view)) w += norm2(amplitude[1]);
  return lanes(0.5f) * w;
}

// Lanes worth a path. If there are none, w is cut off here, before the path is made; else keep_bright does it.
FUNCTION int worth_following(PRIVATE const SceneView* view, PRIVATE const Path* from, real w, PRIVATE Gathered* sum) {
  mask dim = w <= lanes(view->adc_bailout);  // not a number is not dim: keep_bright counts it
  if (from->level >= view->max_trace_level) dim = w <= FAR_MM;
  if (any_lane(not_mask(dim))) return 1;
  add_cut_off(sum, w);
  return 0;
}

// The two waves of a crystal from where `from` stands: together, apart, or shares of both. gap: wavelengths of vacuum
// that wave 1 gains per length along the mean ray.
FUNCTION void send_waves(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const WaveMedium* m,
                         PRIVATE Wave* w,
                         real gap, cplx amplitude[2][2], PRIVATE Children* out, PRIVATE Gathered* sum) {
  real mu = lanes(0);
  if (has(coherent_waves, view)) {
    mu = coherent_share(view, from, w, gap, w[0].runs & w[1].runs);
    if (any_lane(mu > lanes(0))) send_pair(view, from, w, gap, amplitude, mu, out);
  }
  if (!any_lane(mu < lanes(1))) return;
  if (has(conical_rays, view)) take_azimuth(view, m, w, gap, amplitude, sum);
  int ordinary = m->kind == WAVES_UNIAXIAL ? CARRIES_ORDINARY : CARRIES_ONE;
  for (int i = 0; i < 2; ++i) {
    if (!worth_following(view, from, (lanes(1) - mu) * wave_weight(view, amplitude[i]), sum)) continue;
    send_single(view, from, &w[i], amplitude[i], lanes(1) - mu, i == 0 ? ordinary : CARRIES_ONE, out);
  }
}

FUNCTION void send_crystal(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const FaceAxes* f,
                           PRIVATE const WaveMedium* m, PRIVATE const WavePair* waves, cplx amplitude[2][2],
                               PRIVATE Children* out,
                           PRIVATE Gathered* sum) {
  if (!worth_following(view, from, wave_weight(view, amplitude[0]) + wave_weight(view, amplitude[1]), sum)) return;
  Wave w[2];
  for (int i = 0; i < 2; ++i) w[i] = wave_of_mode(f, &waves->mode[i]);
  // k1 - k0 runs along the normal
  vec3 mean = add3(w[0].ray, w[1].ray);
  real length2 = dot3(mean, mean);
  mask together = length2 > lanes(0.01f);
  real gap = waves->gap * dot3(mean, f->n) / sqrt_of(pick(together, length2, lanes(1)));
  send_waves(view, from, m, w, gap, amplitude, out, sum);
}

FUNCTION void send(PRIVATE const SceneView* view, PRIVATE const Path* from, PRIVATE const FaceAxes* f,
                   PRIVATE const WaveMedium* m, PRIVATE const WavePair* waves, cplx amplitude[2][2],
                       PRIVATE Children* out,
                   PRIVATE Gathered* sum) {
  if (m->kind == WAVES_ISOTROPIC) {
    send_isotropic(view, from, f, m, waves, amplitude, out);
  } else {
    send_crystal(view, from, f, m, waves, amplitude, out, sum);
  }
}

#endif
