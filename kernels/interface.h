// What a face does to a path: one reflected and one refracted path.
#ifndef NICOL_INTERFACE_H
#define NICOL_INTERFACE_H
#include "fresnel.h"
#include "path.h"
#include "wave_medium.h"

// A face between media 1 (where the path is) and 2, its normal turned forward (d.normal > 0).
typedef struct {
  vec3 normal;
  int medium1, medium2;
  int from_inside;    // medium 1 is that of the solid whose face it is
  lane_int surface;   // use of a plugin's fragment that it wears, -1: none
} Interface;

FUNCTION int pair_row(PRIVATE const SceneView* view, int medium1, int medium2) {
  return view->header[HEADER_DELTA_ROW] + medium1 * view->header[HEADER_MEDIUM_COUNT] + medium2;
}

// Unit vector across the plane of incidence, (t, u, normal) right-handed, t along the tangential part of d.
FUNCTION vec3 across_incidence(vec3 n, vec3 d) { return axes_of_face(n, d).u; }

// The way through the medium of the path's cell: absorption, and rotation of the plane of polarization
// together with the turn of the axes to (u, u x d): both are rotations about d, so their angles add.
FUNCTION void go_through(PRIVATE const SceneView* view, PRIVATE Path* path, int medium, real depth_mm, vec3 u) {
  if (has(absorption, view) && view->media[medium * MEDIUM_INTS + MEDIUM_ABSORBS]) {
    real per_mm = spectral(view, medium_row(view, medium, MEDIUM_ROW_ABSORB_PER_MM));
    real passed = exp_of(lanes(has(polarization, view) ? -0.5f : -1.0f) * per_mm * depth_mm);
    scale_jones(view, &path->jones, passed);
  }
  if (!has(polarization, view)) return;
  real c = dot3(path->axis, u), s = dot3(second_axis(path), u);
  if (has(rotation, view) && view->media[medium * MEDIUM_INTS + MEDIUM_ROTATES]) {
    cplx active = rotation_of(spectral(view, medium_row(view, medium, MEDIUM_ROW_TURNS_HI)),
                              spectral(view, medium_row(view, medium, MEDIUM_ROW_TURNS_LO)), depth_mm);
    real c0 = c;
    c = c0 * active.re + s * active.im;
    s = s * active.re - c0 * active.im;
  }
  cplx turn = renew_phase(complex_of(c, s));
  turn_axes(view, &path->jones, turn.re, turn.im);
  path->axis = u;
}

// The fragment's input for a face whose bare coefficients are `f`; delta = n2^2 - n1^2.
FUNCTION SurfaceIn surface_input(real lambda_nm, real n1, real k1, real n2, real k2, real delta, real cos_i, mask total,
                                 PRIVATE const SurfaceOut* f) {
  SurfaceIn in;
  in.lambda_nm = lambda_nm;
  in.n1 = n1;
  in.k1 = k1;
  in.n2 = n2;
  in.k2 = k2;
  real p1 = n1 * cos_i;
  p1 = pick(p1 > LEAST_P1, p1, LEAST_P1);
  in.cosine = p1 / n1;
  in.p1 = complex_of(p1, k1 * in.cosine);
  in.eps1 = complex_of(n1 * n1 - k1 * k1, lanes(2) * n1 * k1);
  cplx change = complex_of(delta - (k2 * k2 - k1 * k1), lanes(2) * (n2 * k2 - n1 * k1));
  in.eps2 = cadd(in.eps1, change);
  in.p2 = forward_root(cadd(cmul(in.p1, in.p1), change), total);
  in.r_s = f->r_s;
  in.r_p = f->r_p;
  in.t_s = f->t_s;
  in.t_p = f->t_p;
  in.from_inside = 0;
  return in;
}

// What the surfaces of plugins make of the coefficients, in the lanes whose face wears one. Under total reflection nothing goes through.
FUNCTION void wear_surfaces(PRIVATE const SceneView* view, PRIVATE const Interface* face, real cos_i, mask total,
                            PRIVATE SurfaceOut* f) {
  lane_int left = face->surface;
  if (!any_lane(left >= lane_ints(0))) return;
  SurfaceIn in = surface_input(wavelength_nm(view), spectral(view, medium_row(view, face->medium1, MEDIUM_ROW_N)),
                               spectral(view, medium_row(view, face->medium1, MEDIUM_ROW_K)),
                               spectral(view, medium_row(view, face->medium2, MEDIUM_ROW_N)),
                               spectral(view, medium_row(view, face->medium2, MEDIUM_ROW_K)),
                               spectral(view, pair_row(view, face->medium1, face->medium2)), cos_i, total, f);
  in.from_inside = face->from_inside;
  cplx none = complex_of(lanes(0), lanes(0));
  for (int lead = largest_lane(left); lead >= 0; lead = largest_lane(left)) {
    GLOBAL const int* use = fragment_use(view, lead);
    SurfaceOut out;
    out.r_s = out.r_p = out.t_s = out.t_p = none;
    run_surface(use[FRAGMENT_INDEX], &in, view->fragment_reals + use[FRAGMENT_FIRST], &out);
    mask here = left == lane_ints(lead);
    f->r_s = cpick(here, out.r_s, f->r_s);
    f->r_p = cpick(here, out.r_p, f->r_p);
    f->t_s = cpick(here, cpick(total, none, out.t_s), f->t_s);
    f->t_p = cpick(here, cpick(total, none, out.t_p), f->t_p);
    left = pick(here, lane_ints(-1), left);
  }
}

// Splits the path at the interface: `path` (already standing on the face, axis = u) becomes the reflected
// one, the refracted one is returned; both keep position and cell of `path`, the caller moves them.
FUNCTION Path split(PRIVATE const SceneView* view, PRIVATE Path* path, Interface face, PRIVATE Gathered* sum) {
  vec3 d = path->ray.direction;
  real n1 = spectral(view, medium_row(view, face.medium1, MEDIUM_ROW_N));
  real n2 = spectral(view, medium_row(view, face.medium2, MEDIUM_ROW_N));
  real delta = spectral(view, pair_row(view, face.medium1, face.medium2));
  real cos_i = dot3(d, face.normal);
  Fresnel f = fresnel(n1 * cos_i, delta, n1 * n1);
  cplx t_s = complex_of(f.t_s, lanes(0)), t_p = complex_of(f.t_p, lanes(0));
  int absorbs = has(absorption, view) && (view->media[face.medium1 * MEDIUM_INTS + MEDIUM_ABSORBS] ||
                                          view->media[face.medium2 * MEDIUM_INTS + MEDIUM_ABSORBS]);
  if (absorbs) {
    real k1 = spectral(view, medium_row(view, face.medium1, MEDIUM_ROW_K));
    real k2 = spectral(view, medium_row(view, face.medium2, MEDIUM_ROW_K));
    cplx eps1 = complex_of(n1 * n1 - k1 * k1, lanes(2) * n1 * k1);
    cplx eps2 = complex_of(n2 * n2 - k2 * k2, lanes(2) * n2 * k2);
    cplx change = complex_of(delta - (k2 * k2 - k1 * k1), eps2.im - eps1.im);
    FresnelAbsorbing g = fresnel_absorbing(complex_of(n1 * cos_i, k1 * cos_i), change, eps1, eps2, f.total);
    cplx none = complex_of(lanes(0), lanes(0));
    f.r_s = g.r_s;
    f.r_p = g.r_p;
    t_s = cpick(f.total, none, g.t_s);
    t_p = cpick(f.total, none, g.t_p);
  } else {
    real off_s = norm2(f.r_s) + f.t_s * f.t_s - lanes(1), off_p = norm2(f.r_p) + f.t_p * f.t_p - lanes(1);
    real tolerance = lanes(sizeof(scalar) == 8 ? 1e-12f : 3e-6f);
    sum->energy_off = sum->energy_off | (abs_of(off_s) > tolerance) | (abs_of(off_p) > tolerance);
  }
  if (has_surfaces(view)) {
    SurfaceOut worn;
    worn.r_s = f.r_s;
    worn.r_p = f.r_p;
    worn.t_s = t_s;
    worn.t_p = t_p;
    wear_surfaces(view, &face, cos_i, f.total, &worn);
    f.r_s = worn.r_s;
    f.r_p = worn.r_p;
    t_s = worn.t_s;
    t_p = worn.t_p;
    absorbs = 1;   // amplitudes are complex
  }
  Path refracted = *path;
  refracted.level = ++path->level;
  vec3 tangential = along(-cos_i, face.normal, d);
  real inverse_n2 = lanes(1) / n2;
  refracted.ray.direction = renew_unit(add3(scale3(n1 * inverse_n2, tangential), scale3(f.p2 * inverse_n2, face.normal)));
  refracted.ray.direction = pick3(f.total, face.normal, refracted.ray.direction);
  path->ray.direction = renew_unit(along(lanes(-2) * cos_i, face.normal, d));
  if (!has(polarization, view)) {
    real w = path->jones.e[0].re;
    refracted.jones.e[0].re = lanes(0.5) * (norm2(t_s) + norm2(t_p)) * w;
    path->jones.e[0].re = lanes(0.5) * (norm2(f.r_s) + norm2(f.r_p)) * w;
    return refracted;
  }
  refracted.jones = absorbs ? times_diagonal(view, &path->jones, t_s, t_p)
                            : times_real_diagonal(view, &path->jones, t_s.re, t_p.re);
  path->jones = times_diagonal(view, &path->jones, f.r_s, f.r_p);
  return refracted;
}

#endif
