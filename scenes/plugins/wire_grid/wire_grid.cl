// A wire-grid polarizer: parallel aluminium wires in the medium around, closer than half a wavelength. x (transmission axis) runs across
// the wires, y along them. The grid acts as a uniaxial layer with its optic axis along x (Yeh 1978):
//   eps_x = N^2 of the grid's mode with E across the wires, eps_y = eps_z = N^2 of that with E along them.
// N solves the exact equation of a laminated medium, even about the wires, of Bloch phase 0 (Rytov 1956), for light along the grooves:
//   along:   a_d tan(a_d g/2) = -a_m tan(a_m w/2)
//   across: (a_d/eps_d) tan(a_d g/2) = -(a_m/eps_m) tan(a_m w/2)        a = k0 sqrt(eps - N^2), groove g = period - width w.
// The layer between equal media: its fields are even or odd about its middle plane; each half is a boundary problem of its own, with
// reflection r_even and r_odd, and t = (r_even - r_odd)/2, r = (r_even + r_odd)/2. Inside: the ordinary wave E ~ k cross x with
// kz^2 = eps_y - kx^2 - ky^2, the extraordinary one H ~ k cross x with kz^2 = eps_x - (eps_x/eps_y) kx^2 - ky^2 (units of k0).
// Aluminium: eps = 1 - f0 Wp^2/(E (E + i G0)) + sum fj Wp^2/(Ej^2 - E^2 - i E Gj), eV (Rakic et al. 1998, table 2).
// Valid for period < lambda/(1 + sin(theta))/n (no diffracted order), light near the plane across the wires or along them. One mode of each
// polarization, no evanescent orders at the ends of the wires, no substrate, no oxide: how far that is off has not been measured.
// Figures: README.md. Test: tests/fragments/wire_grid_test.cpp.

#define WIRE_GRID_STEPS 7

// tan, for Im z >= 0: i (1 - w)/(1 + w), w = exp(2 i z), which does not overflow.
FUNCTION cplx wire_grid_tan(cplx z) {
  cplx w = cexp_of(cscale(lanes(2), z)), one = real_number(lanes(1));
  return times_i(cdiv(csub(one, w), cadd(one, w)));
}

FUNCTION cplx wire_grid_decaying_root(cplx square) {
  cplx root = csqrt_of(square);
  return cpick(root.im < lanes(0), cscale(lanes(-1), root), root);
}

FUNCTION cplx wire_grid_pole(real strength, real resonance_ev, real width_ev, real energy_ev) {
  cplx below = complex_of(resonance_ev * resonance_ev - energy_ev * energy_ev, -energy_ev * width_ev);
  return cdiv(real_number(strength), below);
}

FUNCTION cplx wire_grid_aluminium(real lambda_nm) {
  real energy_ev = lanes(1239.841984) / lambda_nm;   // h c/e, CODATA 2018
  real plasma2 = lanes(14.98 * 14.98);
  cplx sum = wire_grid_pole(lanes(0.523), lanes(0), lanes(0.047), energy_ev);
  sum = cadd(sum, wire_grid_pole(lanes(0.227), lanes(0.162), lanes(0.333), energy_ev));
  sum = cadd(sum, wire_grid_pole(lanes(0.050), lanes(1.544), lanes(0.312), energy_ev));
  sum = cadd(sum, wire_grid_pole(lanes(0.166), lanes(1.808), lanes(1.351), energy_ev));
  sum = cadd(sum, wire_grid_pole(lanes(0.030), lanes(3.473), lanes(3.382), energy_ev));
  return cadd(real_number(lanes(1)), cscale(plasma2, sum));
}

// N^2 of the grid's mode. With x = a_d g/2: x tan x = c, c = -(g/2) q a_m tan(a_m w/2), q = 1 along the wires, eps_d/eps_m across. a_m hardly
// depends on N; x^2 goes by Newton's steps, from c/(1 + 4 c/pi^2), which is right for small and for large c.
FUNCTION cplx wire_grid_mode(real k0, real eps_d, cplx eps_m, real gap, real width, cplx q) {
  cplx one = real_number(lanes(1)), square = one;
  cplx mode = real_number(eps_d);
  for (int step = 0; step < WIRE_GRID_STEPS; ++step) {
    cplx a_m = cscale(k0, wire_grid_decaying_root(csub(eps_m, mode)));
    cplx c = cmul(q, cmul(a_m, wire_grid_tan(cscale(lanes(0.5) * width, a_m))));
    c = cscale(lanes(-0.5) * gap, c);
    if (step == 0) {
      square = cdiv(c, cadd(one, cscale(lanes(0.405284734569), c)));
    } else {
      cplx x = wire_grid_decaying_root(square), tan_x = wire_grid_tan(x);
      // f = x tan x - c by x^2: (tan x/x + 1 + tan^2 x)/2
      cplx slope = cscale(lanes(0.5), cadd(cdiv(tan_x, x), cadd(one, cmul(tan_x, tan_x))));
      square = csub(square, cdiv(csub(cmul(x, tan_x), c), slope));
    }
    real unit = lanes(2) / (gap * k0);
    mode = csub(real_number(eps_d), cscale(unit * unit, square));
  }
  return mode;
}

// 2x2 matrices {xx, xy, yx, yy}.
typedef struct { cplx xx, xy, yx, yy; } wire_grid_matrix;

FUNCTION wire_grid_matrix wire_grid_product(wire_grid_matrix a, wire_grid_matrix b) {
  wire_grid_matrix m;
  m.xx = cadd(cmul(a.xx, b.xx), cmul(a.xy, b.yx));
  m.xy = cadd(cmul(a.xx, b.xy), cmul(a.xy, b.yy));
  m.yx = cadd(cmul(a.yx, b.xx), cmul(a.yy, b.yx));
  m.yy = cadd(cmul(a.yx, b.xy), cmul(a.yy, b.yy));
  return m;
}

FUNCTION wire_grid_matrix wire_grid_inverse(wire_grid_matrix a) {
  cplx inverse = cdiv(real_number(lanes(1)), csub(cmul(a.xx, a.yy), cmul(a.xy, a.yx)));
  wire_grid_matrix m;
  m.xx = cmul(a.yy, inverse);
  m.yy = cmul(a.xx, inverse);
  m.xy = cscale(lanes(-1), cmul(a.xy, inverse));
  m.yx = cscale(lanes(-1), cmul(a.yx, inverse));
  return m;
}

// Columns (first, second) times the factors a, b.
FUNCTION wire_grid_matrix wire_grid_columns(wire_grid_matrix m, cplx a, cplx b) {
  m.xx = cmul(m.xx, a);
  m.yx = cmul(m.yx, a);
  m.xy = cmul(m.xy, b);
  m.yy = cmul(m.yy, b);
  return m;
}

// Reflection by fields E = A a and H = B a inside, in amplitudes of which a forward wave outside has as much H as E:
// in + r = A a, in - r = B a, so r = (2 A (A + B)^-1 - 1) in.
FUNCTION wire_grid_matrix wire_grid_reflection(wire_grid_matrix a, wire_grid_matrix b) {
  wire_grid_matrix sum;
  sum.xx = cadd(a.xx, b.xx);
  sum.xy = cadd(a.xy, b.xy);
  sum.yx = cadd(a.yx, b.yx);
  sum.yy = cadd(a.yy, b.yy);
  wire_grid_matrix m = wire_grid_product(a, wire_grid_inverse(sum));
  cplx one = real_number(lanes(1)), two = real_number(lanes(2));
  m = wire_grid_columns(m, two, two);
  m.xx = csub(m.xx, one);
  m.yy = csub(m.yy, one);
  return m;
}

// Rows (x, y) of m in the axes u = (-ty, tx) and t = (tx, ty), times the factors of s and p.
FUNCTION wire_grid_matrix wire_grid_in_plane(wire_grid_matrix m, real tx, real ty, real factor_u, real factor_t) {
  wire_grid_matrix out;
  out.xx = cscale(factor_u, csub(cscale(tx, m.yx), cscale(ty, m.xx)));
  out.xy = cscale(factor_u, csub(cscale(tx, m.yy), cscale(ty, m.xy)));
  out.yx = cscale(factor_t, cadd(cscale(tx, m.xx), cscale(ty, m.yx)));
  out.yy = cscale(factor_t, cadd(cscale(tx, m.xy), cscale(ty, m.yy)));
  return out;
}

FUNCTION JonesMatrix wire_grid_jones(wire_grid_matrix a, wire_grid_matrix b, real sign_b, real side, real sign_p) {
  JonesMatrix j;
  j.ss = cscale(lanes(0.5), cadd(a.xx, cscale(sign_b, b.xx)));
  j.sp = cscale(lanes(0.5) * side, cadd(a.xy, cscale(sign_b, b.xy)));
  j.ps = cscale(lanes(0.5) * side * sign_p, cadd(a.yx, cscale(sign_b, b.yx)));
  j.pp = cscale(lanes(0.5) * sign_p, cadd(a.yy, cscale(sign_b, b.yy)));
  return j;
}

FUNCTION void wire_grid(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  real k0 = lanes(6.283185307179586477) / in->lambda_nm, eps_d = in->n * in->n;
  cplx one = real_number(lanes(1)), eps_m = wire_grid_aluminium(in->lambda_nm);
  real width = lanes(P_width < P_period ? P_width : (scalar)0.99 * P_period), gap = lanes(P_period) - width;
  cplx eps_y = wire_grid_mode(k0, eps_d, eps_m, gap, width, one);
  cplx eps_x = wire_grid_mode(k0, eps_d, eps_m, gap, width, cdiv(real_number(eps_d), eps_m));

  // wave vectors in units of k0; light towards +z, for the grid looks alike from both sides
  real kx = in->n * in->direction.x, ky = in->n * in->direction.y, kz = in->n * in->cosine;
  cplx o2 = csub(eps_y, real_number(kx * kx + ky * ky));
  cplx e2 = csub(csub(eps_x, real_number(ky * ky)), cscale(kx * kx, cdiv(eps_x, eps_y)));
  cplx ko = wire_grid_decaying_root(o2), ke = wire_grid_decaying_root(e2);

  // columns: ordinary, extraordinary; rows x, y: tangential E and H. E of the ordinary and H of the extraordinary wave turn with kz
  wire_grid_matrix e, h;
  e.xx = real_number(lanes(0));
  e.yx = ko;
  h.xx = csub(real_number(kx * kx), eps_y);
  h.yx = real_number(kx * ky);
  e.xy = cdiv(cadd(real_number(ky * ky), e2), eps_x);
  e.yy = cscale(-kx * ky, cdiv(one, eps_y));
  h.xy = real_number(lanes(0));
  h.yy = ke;

  // Amplitudes per root of flux outside, k along (t, z), u = z cross t: a forward wave has H_t = -kz E_u, H_u = n^2/kz E_t. So
  // s: E_u sqrt(kz) = -H_t/sqrt(kz),  p: E_t n/sqrt(kz) = H_u sqrt(kz)/n
  real q2 = in->direction.x * in->direction.x + in->direction.y * in->direction.y;
  mask tilted = q2 > lanes(0);
  real inverse = lanes(1) / sqrt_of(pick(tilted, q2, lanes(1)));
  real tx = pick(tilted, in->direction.x * inverse, lanes(1)), ty = pick(tilted, in->direction.y * inverse, lanes(0));
  real root = sqrt_of(kz);
  wire_grid_matrix e_out = wire_grid_in_plane(e, tx, ty, root, in->n / root);
  wire_grid_matrix h_turned = wire_grid_in_plane(h, tx, ty, root / in->n, lanes(-1) / root), h_out;
  h_out.xx = h_turned.yx;
  h_out.xy = h_turned.yy;
  h_out.yx = h_turned.xx;
  h_out.yy = h_turned.xy;

  // at the front, half the height before the middle: even E_t goes with cos, H_t with -i sin; odd ones the other way round
  real half_height = lanes(0.5) * lanes(P_height) * k0;
  cplx tan_o = wire_grid_tan(cscale(half_height, ko)), tan_e = wire_grid_tan(cscale(half_height, ke));
  cplx sin_o = cscale(lanes(-1), times_i(tan_o)), sin_e = cscale(lanes(-1), times_i(tan_e));
  wire_grid_matrix even = wire_grid_reflection(e_out, wire_grid_columns(h_out, sin_o, sin_e));
  wire_grid_matrix odd = wire_grid_reflection(wire_grid_columns(e_out, sin_o, sin_e), h_out);
  // s is u for light along z and -u for light against it; p has the tangential part t cos, p of reflected light -t cos
  real side = pick(in->direction.z < lanes(0), lanes(-1), lanes(1));
  out->t = wire_grid_jones(even, odd, lanes(-1), side, lanes(1));
  out->r = wire_grid_jones(even, odd, lanes(1), side, lanes(-1));
}
