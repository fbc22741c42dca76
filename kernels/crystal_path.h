// Waves of crystals along a path: what a path's eigenwave is made of, how it goes through the crystal, and the
// paths that a face sends into a medium.
//
// Two waves of one wave normal are told apart where they leave: by then their rays are |r1 - r0| d apart and their
// phases have drifted by 2 pi gap d/lambda. Where the rays stay within a pixel and the phases within a bin of
// wavelengths, they are one path with two amplitudes along their mean ray (interference, rotation along the axis
// of quartz); elsewhere two paths whose intensities add. Between the two, both: with
//   mu = overlap of two pixels that far apart  x  sinc(pi gap d/lambda (bin width/lambda))  x  sinc(pi dq pixel/lambda)
// where dq is the difference of their wave vectors along the face where they leave (fringes of a wedge, washed out
// within a pixel), less where dq comes near 2 % of p^2 (rays that leave more than about a degree apart are two rays):
// the pair carries the share mu, the two single waves 1 - mu, so nothing jumps. Shares under 0.1 or over 0.9 are
// rounded to 0 and 1 (the rest stretched between), so that few paths have both.
// Sources: Born & Wolf, Principles of Optics, 7th ed., 15.3-15.4 (waves of crystals), 10.3 (partial coherence);
// Berry & Jeffrey, Prog. Opt. 50, 13 (2007) (conical refraction: the two waves of every azimuth around a binormal).
// Test: tests/kernels/crystal_*_test.cpp.
#ifndef NICOL_CRYSTAL_PATH_H
#define NICOL_CRYSTAL_PATH_H
#include "path.h"
#include "waves.h"

// The kind of waves of a medium in terms of constants, so that what a scene does not have is left out of its kernel.
FUNCTION int kind_of_waves(PRIVATE const SceneView* view, int medium) {
  int kind = view->media[medium * MEDIUM_INTS + MEDIUM_WAVES];
  if (!has(birefringence, view)) return WAVES_ISOTROPIC;
  if (!has(polarization, view)) return WAVES_ISOTROPIC;
  if (has(general_waves, view) && kind == WAVES_GENERAL) return WAVES_GENERAL;
  if (has(gyration, view) && kind == WAVES_CHIRAL) return WAVES_CHIRAL;
  return kind == WAVES_UNIAXIAL ? WAVES_UNIAXIAL : WAVES_ISOTROPIC;
}

#define is_crystal(view, medium) (kind_of_waves(view, medium) != WAVES_ISOTROPIC)

FUNCTION WaveMedium wave_medium(PRIVATE const SceneView* view, int medium) {
  GLOBAL const int* record = view->media + medium * MEDIUM_INTS;
  int row = record[MEDIUM_ROW];
  WaveMedium m;
  m.kind = kind_of_waves(view, medium);
  m.active = has(gyration, view) && record[MEDIUM_ACTIVE];
  m.n = spectral(view, row + MEDIUM_ROW_N);
  m.eps = m.n * m.n;
  m.kappa = m.kind == WAVES_CHIRAL ? spectral(view, row + CHIRAL_ROW_KAPPA) : lanes(0);
  if (m.kind == WAVES_UNIAXIAL) {
    m.axis = vec(spectral(view, row + UNIAXIAL_ROW_AXIS), spectral(view, row + UNIAXIAL_ROW_AXIS + 1),
                 spectral(view, row + UNIAXIAL_ROW_AXIS + 2));
    m.eps_e = spectral(view, row + UNIAXIAL_ROW_EPS_E);
    m.d_eps = spectral(view, row + UNIAXIAL_ROW_D_EPS);
    m.d_eta = spectral(view, row + UNIAXIAL_ROW_D_ETA);
  }
  if (m.kind == WAVES_GENERAL) {
    for (int i = 0; i < 6; ++i) m.atil[i] = spectral(view, row + GENERAL_ROW_ATIL + i);
    for (int i = 0; i < 6 && m.active; ++i) {
      m.gq[i] = spectral(view, row + GENERAL_ROW_GQ + i);
      m.zeta[i] = spectral(view, row + GENERAL_ROW_ZETA + i);
    }
  }
  return m;
}

// ---- polarization of a wave ----

// Unit D of a wave as (re, im): wave 0 is c e + i s f, wave 1 is i s e + c f.
FUNCTION cvec3 unit_d(vec3 e, vec3 f, real s, int wave) {
  real c = sqrt_of(lanes(1) - s * s);
  cvec3 d;
  d.re = wave == 0 ? scale3(c, e) : scale3(c, f);
  d.im = wave == 0 ? scale3(s, f) : scale3(s, e);
  return d;
}

FUNCTION vec3 wave_normal(vec3 k) { return unit3(k); }

// <a, b> = a* . b
FUNCTION cplx inner(cvec3 a, cvec3 b) {
  return complex_of(dot3(a.re, b.re) + dot3(a.im, b.im), dot3(a.re, b.im) - dot3(a.im, b.re));
}

FUNCTION cplx unit_phase(cplx a) {
  real length2 = norm2(a);
  mask some = length2 > lanes(1e-30f);
  real inverse = lanes(1) / sqrt_of(pick(some, length2, lanes(1)));
  return complex_of(pick(some, a.re * inverse, lanes(1)), pick(some, a.im * inverse, lanes(0)));
}

FUNCTION cvec3 unit_complex(cvec3 a) {
  real length2 = dot3(a.re, a.re) + dot3(a.im, a.im);
  real inverse = lanes(1) / sqrt_of(pick(length2 > lanes(1e-30f), length2, lanes(1)));
  a.re = scale3(inverse, a.re);
  a.im = scale3(inverse, a.im);
  return a;
}

// a - b (b* . a)/2: the first of two unit vectors, each moved half the way to be perpendicular (Lowdin, J. Chem. Phys.
// 18, 365 (1950)).
FUNCTION cvec3 half_across(cvec3 a, cvec3 b) {
  cplx overlap = inner(b, a);
  real re = lanes(0.5f) * overlap.re, im = lanes(0.5f) * overlap.im;
  a.re = sub3(a.re, sub3(scale3(re, b.re), scale3(im, b.im)));
  a.im = sub3(a.im, add3(scale3(re, b.im), scale3(im, b.re)));
  return a;
}

// Writes D (any phase and length) as w |D| (c e + i s f); returns the phase w.
FUNCTION cplx polarization_axes(cvec3 d, vec3 normal, PRIVATE vec3* e, PRIVATE real* s) {
  cplx square = complex_of(dot3(d.re, d.re) - dot3(d.im, d.im), lanes(2) * dot3(d.re, d.im));
  real length2 = dot3(d.re, d.re) + dot3(d.im, d.im);
  // circular waves have no axes: any will do
  mask round = norm2(square) < lanes(1e-10f) * length2 * length2;
  square = cpick(round, complex_of(lanes(1), lanes(0)), square);
  cplx w = unit_phase(csqrt_of(unit_phase(square)));
  vec3 major = add3(scale3(w.re, d.re), scale3(w.im, d.im));
  vec3 minor = sub3(scale3(w.re, d.im), scale3(w.im, d.re));
  major = along(-dot3(major, normal), normal, major);
  real major2 = dot3(major, major);
  mask some = major2 > lanes(1e-30f);
  *e = pick3(some, scale3(lanes(1) / sqrt_of(pick(some, major2, lanes(1))), major), *e);
  real sine = dot3(minor, cross3(*e, normal)) / sqrt_of(pick(length2 > lanes(1e-30f), length2, lanes(1)));
  *s = pick(sine > lanes(0.70710678118654752), lanes(0.70710678118654752),
            pick(sine < lanes(-0.70710678118654752), lanes(-0.70710678118654752), sine));
  return w;
}

// ---- through the crystal ----

// Im eps of a crystal along E: power absorbed per mm of ray, 2 pi/lambda E* . Im eps . E / |Re E x h*| (first order in
// k; Born & Wolf 15.6).
FUNCTION real absorbed_per_mm(PRIVATE const SceneView* view, PRIVATE const WaveMedium* m, int medium, vec3 k, cvec3 d) {
  cvec3 e, h;
  fields_of_wave(m, k, d.re, d.im, &e, &h);
  int row = medium_row(view, medium, CRYSTAL_ROW_IM_EPS);
  real t[6];
  for (int i = 0; i < 6; ++i) t[i] = spectral(view, row + i);
  real lost = lanes(0);
  for (int part = 0; part < 2; ++part) {
    vec3 v = part ? e.im : e.re;
    lost += t[0] * v.x * v.x + t[1] * v.y * v.y + t[2] * v.z * v.z +
            lanes(2) * (t[3] * v.y * v.z + t[4] * v.z * v.x + t[5] * v.x * v.y);
  }
  vec3 flow = add3(cross3(e.re, h.re), cross3(e.im, h.im));
  real per_mm = spectral(view, view->header[HEADER_WAVELENGTH_ROW]);
  return lanes(6.283185307179586477) * per_mm * lost / sqrt_of(dot3(flow, flow));
}

// The way of a crystal's waves over depth_mm of ray: absorption, and the phase of wave 1 against wave 0.
FUNCTION void go_through_crystal(PRIVATE const SceneView* view, PRIVATE Path* path, int medium, real depth_mm) {
  cplx gain[2];
  gain[0] = gain[1] = complex_of(lanes(1), lanes(0));
  int pair = has(coherent_waves, view) && path->carries == CARRIES_PAIR;
  if (pair) {
    real turns_per_mm = path->gap * spectral(view, view->header[HEADER_WAVELENGTH_ROW]);
    gain[1] = rotation_of(turns_per_mm, lanes(0), depth_mm);
  }
  if (has(pleochroism, view) && view->media[medium * MEDIUM_INTS + MEDIUM_ABSORBS]) {
    WaveMedium m = wave_medium(view, medium);
    vec3 f = cross3(path->axis, wave_normal(path->k));
    real half_gap = pair ? lanes(0.5f) * path->gap / sqrt_of(dot3(path->k, path->k)) : lanes(0);
    for (int wave = 0; wave < (pair ? 2 : 1); ++wave) {
      // the wave's own k: a pair's is the mean, off by half the birefringence
      vec3 k = scale3(wave ? lanes(1) + half_gap : lanes(1) - half_gap, path->k);
      real lost = absorbed_per_mm(view, &m, medium, k, unit_d(path->axis, f, path->ellipse, wave));
      gain[wave] = cscale(exp_of(lanes(-0.5f) * lost * depth_mm), gain[wave]);
    }
  }
  path->jones = times_diagonal(view, &path->jones, gain[0], gain[1]);
}

// ---- the waves that meet a face ----

typedef struct {
  Mode mode[2];
  int count;
} Incident;

FUNCTION vec3 to_local(PRIVATE const FaceAxes* f, vec3 v) { return vec(dot3(v, f->t), dot3(v, f->u), dot3(v, f->n)); }
FUNCTION vec3 to_world(PRIVATE const FaceAxes* f, vec3 v) {
  return add3(add3(scale3(v.x, f->t), scale3(v.y, f->u)), scale3(v.z, f->n));
}

// D = -k x h of a mode, in the world. Its wave vector is real.
FUNCTION cvec3 displacement(PRIVATE const FaceAxes* f, PRIVATE const Mode* m) {
  real p = m->p.re;
  cvec3 d;
  d.re = to_world(f, vec(p * m->h[1].re, f->q * m->h[2].re - p * m->h[0].re, -f->q * m->h[1].re));
  d.im = to_world(f, vec(p * m->h[1].im, f->q * m->h[2].im - p * m->h[0].im, -f->q * m->h[1].im));
  return d;
}

FUNCTION Mode mode_of_fields(PRIVATE const FaceAxes* f, vec3 k, cvec3 e, cvec3 h) {
  Mode m;
  m.p = complex_of(dot3(k, f->n), lanes(0));
  vec3 er = to_local(f, e.re), ei = to_local(f, e.im), hr = to_local(f, h.re), hi = to_local(f, h.im);
  m.e[0] = complex_of(er.x, ei.x);
  m.e[1] = complex_of(er.y, ei.y);
  m.e[2] = complex_of(er.z, ei.z);
  m.h[0] = complex_of(hr.x, hi.x);
  m.h[1] = complex_of(hr.y, hi.y);
  m.h[2] = complex_of(hr.z, hi.z);
  return m;
}

// The amplitudes of a pair on the face's own two waves: the nearest unitary change between the two sets of D (polar
// decomposition of their overlaps), which belong to wave vectors a little apart. What falls on a wave that does not run
// along the mean tangential wave vector (two waves within a degree of grazing) is cut off, and counted so.
FUNCTION void pair_on_face(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const FaceAxes* f,
                           PRIVATE const Mode* modes,
                           PRIVATE Gathered* sum) {
  vec3 axis_f = cross3(path->axis, wave_normal(path->k));
  cplx m[2][2];
  for (int i = 0; i < 2; ++i) {
    cvec3 d = unit_complex(displacement(f, &modes[i]));
    for (int j = 0; j < 2; ++j) m[i][j] = inner(d, unit_d(path->axis, axis_f, path->ellipse, j));
  }
  cplx turn = unit_phase(csub(cmul(m[0][0], m[1][1]), cmul(m[0][1], m[1][0])));
  cplx a = cadd(m[0][0], cmul(turn, conj_of(m[1][1]))), b = csub(m[1][0], cmul(turn, conj_of(m[0][1])));
  real length2 = norm2(a) + norm2(b);
  mask some = length2 > lanes(1e-30f);
  real scale = lanes(1) / sqrt_of(pick(some, length2, lanes(1)));
  a = cpick(some, cscale(scale, a), complex_of(lanes(1), lanes(0)));
  b = cpick(some, cscale(scale, b), complex_of(lanes(0), lanes(0)));
  for (int r = 0; r < jones_rows(view); ++r) {
    cplx e = path->jones.e[r], g = path->jones.f[r];
    path->jones.e[r] = csub(cmul(a, e), cmul(cmul(turn, conj_of(b)), g));
    path->jones.f[r] = cadd(cmul(b, e), cmul(cmul(turn, conj_of(a)), g));
  }
  mask runs0 = modes[0].p.im == lanes(0), runs1 = modes[1].p.im == lanes(0);
  cplx none = complex_of(lanes(0), lanes(0));
  for (int r = 0; r < jones_rows(view); ++r) {
    real lost = pick(runs0, lanes(0), norm2(path->jones.e[r])) + pick(runs1, lanes(0), norm2(path->jones.f[r]));
    add_cut_off(sum, lanes(0.5f) * lost);
    path->jones.e[r] = cpick(runs0, path->jones.e[r], none);
    path->jones.f[r] = cpick(runs1, path->jones.f[r], none);
  }
}

#endif
