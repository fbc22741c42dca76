// Polarizers: for a ray, the one state that passes and how much of its amplitude.
//
// A polarizer's matrix is M = amplitude * m m^T with a unit vector m across the ray; its own transmission
// axis a and normal N are given in the world, c = N x a lies across a in the plane.
//   ideal            m along the projection of a across the ray (Malus), amplitude 1
//   ideal_absorbing  m along d x c: the projection of the absorption axis c is removed
//                    (Korger et al., Opt. Express 21, 27032 (2013)), amplitude 1
//   calcite          a plate of zero thickness in vacuum, optic axis c in its plane: only the ordinary wave
//                    goes through, with Fresnel's transmission at both faces (Kozlov & Debelov 2014).
// Calcite: boundary problem vacuum -> uniaxial in axes (t, u, N), wave vectors (q, 0, p), optic axis
// (ct, cu, 0): E_o ~ k x c, h_e ~ k x c. Eliminating the reflected waves (E_t + p1 h_u = 2 p1 for unit p
// light, p1 E_u - h_t = 2 p1 for unit s light) leaves two real equations for the ordinary and extraordinary
// amplitudes. Per root of flux the ordinary one answers (s, p) light by tau = (tau_s, tau_p); by reciprocity and the
// plate's symmetry the second face gives the same tau, so M = tau tau^T.
// Source of the wave equations: Yariv & Yeh, Optical Waves in Crystals, ch. 4. Test: tests/kernels.
#ifndef NICOL_POLARIZER_H
#define NICOL_POLARIZER_H
#include "scene_view.h"

typedef struct {
  vec3 axis;       // unit, across the ray
  real amplitude;  // per root of flux
} PassingState;

// (tau_s, tau_p) of a calcite plate: cosine of incidence p1, sine q, optic axis (ct, cu, 0).
FUNCTION cplx calcite_coupling(real p1, real q2, real q_cu2, real ct, real cu, real n_o, real n_e) {
  real eps_o = n_o * n_o, eps_e = n_e * n_e;
  real po = sqrt_of(eps_o - q2);
  real pe = sqrt_of(eps_e - (q2 * eps_e - (eps_e - eps_o) * q_cu2) / eps_o);
  real g = (lanes(1) / eps_e - lanes(1) / eps_o) * (pe * pe + q_cu2);
  // tangential fields (E_t, E_u, h_t, h_u)
  real o_et = -po * cu, o_eu = po * ct, o_ht = -po * po * ct, o_hu = -cu * eps_o;
  real e_et = pe * pe * ct / eps_o + g * ct, e_eu = cu * (pe * pe + q2) / eps_o + g * cu;
  real e_ht = -pe * cu, e_hu = pe * ct;
  real m11 = o_et + p1 * o_hu, m12 = e_et + p1 * e_hu;
  real m21 = p1 * o_eu - o_ht, m22 = p1 * e_eu - e_ht;
  real flux = sqrt_of(p1 * po * (cu * cu * eps_o + po * po * ct * ct));
  real factor = lanes(2) * flux / (m11 * m22 - m12 * m21);
  return complex_of(-m12 * factor, m22 * factor);  // s, p
}

FUNCTION PassingState passing_state(PRIVATE const SceneView* view, int polarizer, vec3 direction) {
  PassingState out;
  int kind = view->polarizers[polarizer * POLARIZER_INTS + POLARIZER_KIND];
  GLOBAL const scalar* reals = view->polarizer_reals + polarizer * POLARIZER_REALS;
  vec3 a = broadcast(reals + POLARIZER_AXIS), n = broadcast(reals + POLARIZER_NORMAL);
  vec3 c = cross3(n, a);
  out.amplitude = lanes(1);
  if (has(calcite_polarizer, view) && kind == POLARIZER_CALCITE) {
    // N forward along the ray; t along the tangential part of the ray
    real p1 = dot3(direction, n);
    mask behind = p1 < lanes(0);
    n = pick3(behind, scale3(lanes(-1), n), n);
    p1 = abs_of(p1);
    real along_a = dot3(direction, a), along_c = dot3(direction, c);
    real q2 = along_a * along_a + along_c * along_c;
    mask tilted = q2 > lanes(0);
    real inverse_q = lanes(1) / sqrt_of(pick(tilted, q2, lanes(1)));
    real ta = pick(tilted, along_a * inverse_q, lanes(1));
    real tc = pick(tilted, along_c * inverse_q, lanes(0));
    vec3 t = add3(scale3(ta, a), scale3(tc, c));
    vec3 u = cross3(n, t);
    real ct = tc, cu = dot3(c, u);
    int row = view->polarizers[polarizer * POLARIZER_INTS + POLARIZER_ROW];
    cplx tau = calcite_coupling(p1, q2, q2 * cu * cu, ct, cu, spectral(view, row + POLARIZER_ROW_N_O),
                                spectral(view, row + POLARIZER_ROW_N_E));
    vec3 p = cross3(u, direction);
    vec3 m = add3(scale3(tau.re, u), scale3(tau.im, p));
    real size2 = norm2(tau);
    mask some = size2 > lanes(0);
    out.axis = pick3(some, scale3(lanes(1) / sqrt_of(pick(some, size2, lanes(1))), m), u);
    out.amplitude = size2;
    return out;
  }
  int absorbing = kind == POLARIZER_IDEAL_ABSORBING;
  vec3 m = absorbing ? cross3(direction, c) : along(-dot3(a, direction), direction, a);
  real size2 = dot3(m, m);
  // the axis along the ray: any state across it may stand for the undefined one; take c (a, when absorbing)
  mask defined = size2 > lanes(1e-12);
  vec3 other = absorbing ? a : c;
  other = along(-dot3(other, direction), direction, other);
  m = pick3(defined, m, other);
  out.axis = scale3(lanes(1) / sqrt_of(dot3(m, m)), m);
  return out;
}

#endif
