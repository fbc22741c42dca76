// Reflection and refraction at a face between two isotropic media.
//
// p1 = n1 cos(theta1) is the normal component of the incident wave vector in units of k0, delta = n2^2 - n1^2
// comes from the host in double precision, so that p2^2 = p1^2 + delta keeps its digits at grazing
// incidence, near the critical angle and between nearly equal media (no 1 - sin^2 anywhere).
// Axes: e = s (across the plane of incidence), f = e x d = p (Fresnel's signs: r_p = -r_s at normal incidence).
//   r_s = (p1 - p2)/(p1 + p2)           = -delta/(p1 + p2)^2
//   r_p = (eps2 p1 - eps1 p2)/(eps2 p1 + eps1 p2)
//   t_s = 2 sqrt(p1 p2)/(p1 + p2),  t_p = 2 sqrt(eps1 eps2 p1 p2)/(eps2 p1 + eps1 p2)   (per root of flux)
// Total reflection: p2 = i sqrt(-p2^2), |r| = 1 with the phases of Fresnel's equations.
// Source: Born & Wolf, Principles of Optics, 7th ed., 1.5.2-1.5.4. Time factor exp(-i w t).
// Valid for real indices; absorbing media: see fresnel_absorbing below. Test: tests/kernels.
#ifndef NICOL_FRESNEL_H
#define NICOL_FRESNEL_H
#include "modes.h"

typedef struct {
  cplx r_s, r_p;
  real t_s, t_p;   // per root of flux: T_s = t_s^2
  real p2;         // normal component of the refracted wave vector; 0 under total reflection
  mask total;      // total reflection
} Fresnel;

// Rounding may bring a grazing p1 to 0 or below, and lanes that are dead may point anywhere: both graze.
#define LEAST_P1 lanes(1e-12f)

FUNCTION Fresnel fresnel(real p1, real delta, real eps1) {
  Fresnel out;
  real eps2 = eps1 + delta;  // R + T = 1 holds to rounding only if the three agree
  p1 = pick(p1 > LEAST_P1, p1, LEAST_P1);
  real p2_squared = p1 * p1 + delta;
  out.total = p2_squared <= lanes(0);
  real root = sqrt_of(abs_of(p2_squared));
  real p2 = pick(out.total, lanes(0), root);
  real decay = pick(out.total, root, lanes(0));  // Im p2
  // s: numerator (p1 - p2)(p1 + p2*), free of cancellation
  real sum_s = p1 + p2;
  real inverse_s = lanes(1) / (sum_s * sum_s + decay * decay);
  out.r_s = complex_of(pick(out.total, lanes(2) * p1 * p1 + delta, -delta) * inverse_s,
                       lanes(-2) * p1 * decay * inverse_s);
  // p
  real a = eps2 * p1, b = eps1 * p2, b_decay = eps1 * decay;
  real sum_p = a + b;
  real inverse_p = lanes(1) / (sum_p * sum_p + b_decay * b_decay);
  real total_p = a * a - b_decay * b_decay;
  // (a - b)(a + b): by delta between near media, where a - b cancels; by a - b between others, where the bracket does
  mask near = abs_of(delta) < lanes(0.1f) * eps1;
  real partial_p = pick(near, delta * (p1 * p1 * (eps1 + eps2) - eps1 * eps1), (a - b) * (a + b));
  out.r_p = complex_of(pick(out.total, total_p, partial_p) * inverse_p, lanes(-2) * a * b_decay * inverse_p);
  out.r_s = cpick(out.total, renew_phase(out.r_s), out.r_s);
  out.r_p = cpick(out.total, renew_phase(out.r_p), out.r_p);
  real flux = sqrt_of(p1 * p2);
  out.t_s = lanes(2) * flux * sum_s * inverse_s;
  out.t_p = lanes(2) * flux * sqrt_of(eps1 * eps2) * sum_p * inverse_p;
  out.p2 = p2;
  return out;
}

// The same with complex permittivities and a complex p1 (a wave in an absorbing medium, attenuated along
// its own direction). T by Poynting flux: T_s = |t|^2 Re p2/Re p1, T_p with p/eps for p; the branch
// of p2 continues the one of the transparent case: Im p2 > 0 where `evanescent`, Re p2 >= 0 elsewhere, with
// evanescent = n2^2 <= (Re q)^2, real parts of the indices alone: on the way from Re q to q, p2^2 crosses the real
// axis at (n2^2 - (Re q)^2)(1 + k2^2/(Re q)^2), if at all.
// Source: Born & Wolf, 14.2. t_s, t_p are complex here.
typedef struct {
  cplx r_s, r_p, t_s, t_p;   // t per root of flux
  cplx p2;
} FresnelAbsorbing;

FUNCTION FresnelAbsorbing fresnel_absorbing(cplx p1, cplx delta, cplx eps1, cplx eps2, mask evanescent) {
  FresnelAbsorbing out;
  p1.re = pick(p1.re > LEAST_P1, p1.re, LEAST_P1);
  cplx p2 = forward_root(cadd(cmul(p1, p1), delta), evanescent);
  out.p2 = p2;
  cplx inverse_s = cdiv(complex_of(lanes(1), lanes(0)), cadd(p1, p2));
  out.r_s = cmul(complex_of(-delta.re, -delta.im), cmul(inverse_s, inverse_s));
  cplx a = cmul(eps2, p1), b = cmul(eps1, p2);
  cplx inverse_p = cdiv(complex_of(lanes(1), lanes(0)), cadd(a, b));
  cplx partial = cmul(delta, csub(cmul(cmul(p1, p1), cadd(eps1, eps2)), cmul(eps1, eps1)));
  out.r_p = cmul(partial, cmul(inverse_p, inverse_p));
  // flux of a wave with unit field: s Re(p), p Re(p conj(eps))/|eps| (h = n u, E_t = p/n)
  real flux1_s = p1.re, flux2_s = p2.re;
  real flux1_p = (p1.re * eps1.re + p1.im * eps1.im) / norm2(eps1);
  real flux2_p = (p2.re * eps2.re + p2.im * eps2.im) / norm2(eps2);
  cplx h_s = cscale(lanes(2), cmul(p1, inverse_s));
  cplx h_p = cscale(lanes(2), cmul(a, inverse_p));
  real ratio_s = flux2_s / flux1_s, ratio_p = flux2_p / flux1_p;
  out.t_s = cscale(sqrt_of(pick(ratio_s > lanes(0), ratio_s, lanes(0))), h_s);
  out.t_p = cscale(sqrt_of(pick(ratio_p > lanes(0), ratio_p, lanes(0))), h_p);
  return out;
}

#endif
