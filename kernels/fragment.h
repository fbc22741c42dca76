// Fragments: optics of surfaces and polarizing elements that plugins bring as OpenCL C. What their functions are given, what
// they give, and helpers for them. A fragment is the pair NAME.json (host/fragments/manifest.hpp) and NAME.cl with the function
//   FUNCTION void NAME(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out)   (kind element)
//   FUNCTION void NAME(PRIVATE const SurfaceIn* in, GLOBAL const scalar* parameter, PRIVATE SurfaceOut* out)   (kind surface)
// Its parameters are parameter[0], ..., in the manifest's order and units, also called P_name. Everything of type `real` holds one
// value per lane (neighbouring wavelengths, or pixels): no branches on them, pick(mask, a, b) instead (portable.h); lanes(0.5)
// makes a real of a number. Arithmetic: vec3.h (cadd, cmul, cdiv, cscale, csqrt_of, ...). Names of its own begin with NAME.
// It must be a pure function of its input: the host probes it before any picture (host/opencl/fragment_check.hpp).
//
// Element: a sheet without thickness, in a medium of index n on both sides. Its own axes: x the transmission axis, z the normal, y =
//   z cross x. Light runs along `direction`; N is z, turned along the light. t is the tangential part of direction, made unit (at normal
//   incidence t = x), s = N x t, p = s x direction of the light at hand: (s, p, direction) is right-handed. Matrices act on (E_s, E_p) of
//   the incident light and give (E_s, E_p) of the transmitted or reflected light, which has a p of its own, p_reflected: Fresnel's
//   signs, r_p = -r_s at normal incidence. There light along z has s = y and p = x; light along -z has s = -y and p = x.
//   A field vector F across the light has E_s = F.s, E_p = F.p. Amplitudes per root of flux: T of passivity is |t|^2.
// Surface: a face between isotropic media 1 (of the incident light) and 2, the same in all azimuths, so s and p stay what they are. p1 and
//   p2 are normal components of the wave vectors in units of k0 (complex: decaying or absorbed waves have Im p > 0); r of light that comes
//   in medium 1; t per root of flux, the same both ways, 0 where p2 has no real part. r_s = (p1 - p2)/(p1 + p2) without a coating,
//   r_p = (eps2 p1 - eps1 p2)/(eps2 p1 + eps1 p2). `from_inside`: medium 1 is the solid's.
// Waves: time factor exp(-i w t), so a wave gains exp(+i phase) on its way, and n + i k absorbs (kernels/README.md).
#ifndef NICOL_FRAGMENT_H
#define NICOL_FRAGMENT_H
#include "modes.h"

// E_s out = ss E_s + sp E_p, E_p out = ps E_s + pp E_p.
typedef struct { cplx ss, sp, ps, pp; } JonesMatrix;

typedef struct {
  real lambda_nm;
  real n;                     // around
  vec3 direction;             // of the light, unit, in the element's axes; z < 0: it comes from the normal's side
  real cosine;                // of incidence, > 0
  vec3 s, p, p_reflected;     // unit, in the element's axes; p of incident and transmitted light
} ElementIn;

typedef struct {
  JonesMatrix t, r;   // transmitted; reflected: counts where the manifest needs "reflection"
} ElementOut;

typedef struct {
  real lambda_nm;
  real n1, k1, n2, k2;
  real cosine;                    // of incidence
  cplx p1, p2, eps1, eps2;
  cplx r_s, r_p, t_s, t_p;        // of the bare face
  int from_inside;
} SurfaceIn;

typedef struct { cplx r_s, r_p, t_s, t_p; } SurfaceOut;

FUNCTION cplx real_number(real x) { return complex_of(x, lanes(0)); }
FUNCTION cplx times_i(cplx a) { return complex_of(-a.im, a.re); }
FUNCTION cplx cexp_of(cplx a) {   // exp(i a)
  real size = exp_of(-a.im);
  return complex_of(size * cos_of(a.re), size * sin_of(a.re));
}

FUNCTION JonesMatrix no_light(void) {
  cplx none = complex_of(lanes(0), lanes(0));
  JonesMatrix m;
  m.ss = m.sp = m.ps = m.pp = none;
  return m;
}

// A homogeneous layer on a face: index n_film (Im > 0 absorbs) and thickness. With y = p for s and p/eps for p, and beta = k0 p_film d,
//   B = cos(beta) - i sin(beta)/y_film y2,  C = cos(beta) y2 - i sin(beta) y_film,
//   r = (y1 B - C)/(y1 B + C),  t = 2 y1/(y1 B + C) sqrt(Re y2/Re y1).
// cos and sin go with exp(i beta), which decays, so that thick metal does not overflow; sin(beta)/beta is a series near 0.
// Source: Abeles 1950; Macleod, Thin-Film Optical Filters, 4th ed., 2.5. Test: tests/fragments/thin_film_test.cpp.
FUNCTION void film_amplitudes(cplx y1, cplx y2, cplx y_of_p, cplx c, cplx s_by_p, cplx p2_film, cplx decay, PRIVATE cplx* r,
                              PRIVATE cplx* t) {
  cplx b = csub(c, times_i(cmul(cdiv(s_by_p, y_of_p), y2)));
  cplx d = csub(cmul(c, y2), times_i(cmul(cmul(s_by_p, y_of_p), p2_film)));
  cplx inverse = cdiv(real_number(lanes(1)), cadd(cmul(y1, b), d));
  real ratio = y2.re / y1.re;
  *r = cmul(csub(cmul(y1, b), d), inverse);
  *t = cscale(lanes(2) * sqrt_of(pick(ratio > lanes(0), ratio, lanes(0))), cmul(cmul(y1, decay), inverse));
}

FUNCTION void layer_on_face(PRIVATE const SurfaceIn* in, cplx n_film, real thickness_nm, PRIVATE SurfaceOut* out) {
  cplx eps = cmul(n_film, n_film), one = real_number(lanes(1));
  cplx p_squared = cadd(cmul(in->p1, in->p1), csub(eps, in->eps1));
  cplx p = csqrt_of(p_squared);
  p = cpick(p.im < lanes(0), cscale(lanes(-1), p), p);   // either root gives the same: take the one that decays
  real k0_thickness = lanes(6.283185307179586477) * thickness_nm / in->lambda_nm;
  cplx beta = cscale(k0_thickness, p);
  cplx decay = cexp_of(beta), w = cmul(decay, decay);
  cplx c = cscale(lanes(0.5), cadd(one, w));
  cplx s = times_i(cscale(lanes(0.5), csub(one, w)));
  mask small = norm2(beta) < lanes(1e-4f);
  cplx series = cmul(decay, cscale(k0_thickness, csub(one, cscale(lanes(1.0 / 6), cmul(beta, beta)))));
  cplx s_by_p = cpick(small, series, cdiv(s, cpick(small, one, p)));
  film_amplitudes(in->p1, in->p2, one, c, s_by_p, p_squared, decay, &out->r_s, &out->t_s);
  film_amplitudes(cdiv(in->p1, in->eps1), cdiv(in->p2, in->eps2), cdiv(one, eps), c, s_by_p, p_squared, decay, &out->r_p,
                  &out->t_p);
}

#endif
