// Entry point that asks a fragment for its amplitudes: host/opencl/fragment_check.hpp. One item is LANES problems; value `field` of an item
// stands at (field * item_count + item) * LANES.
//   elements  in: lambda_nm, n, direction of light x y z (element's axes); out: ss sp ps pp of t, then of r, re im each
//   surfaces  in: lambda_nm, n1, k1, n2, k2, cosine of incidence; out: r_s r_p t_s t_p, re im each
#include "interface.h"

#ifndef LOCAL_SIZE
#define LOCAL_SIZE 1
#endif

FUNCTION void store_numbers(__global scalar* out, int first, int item_count, int item, __private const cplx* numbers, int count) {
  for (int i = 0; i < count; ++i) {
    store_lanes(numbers[i].re, out + ((size_t)(first + 2 * i) * item_count + item) * LANES);
    store_lanes(numbers[i].im, out + ((size_t)(first + 2 * i + 1) * item_count + item) * LANES);
  }
}

FUNCTION void ask_element(__private const real* v, __global const scalar* parameters, __global scalar* out, int item_count, int item) {
  ElementIn in = element_input(v[0], v[1], vec(v[2], v[3], v[4]));
  ElementOut m;
  m.t = m.r = no_light();
  run_element(0, &in, parameters, &m);
  cplx numbers[8] = {m.t.ss, m.t.sp, m.t.ps, m.t.pp, m.r.ss, m.r.sp, m.r.ps, m.r.pp};
  store_numbers(out, 0, item_count, item, numbers, 8);
}

FUNCTION void ask_surface(__private const real* v, __global const scalar* parameters, __global scalar* out, int item_count, int item,
                          int from_inside) {
  real n1 = v[1], k1 = v[2], n2 = v[3], k2 = v[4], cosine = v[5];
  real delta = (n2 - n1) * (n2 + n1);
  mask total = n1 * n1 * cosine * cosine + delta <= lanes(0);
  SurfaceOut bare;
  bare.r_s = bare.r_p = bare.t_s = bare.t_p = complex_of(lanes(0), lanes(0));
  SurfaceIn in = surface_input(v[0], n1, k1, n2, k2, delta, cosine, total, &bare);
  FresnelAbsorbing f = fresnel_absorbing(in.p1, csub(in.eps2, in.eps1), in.eps1, in.eps2, total);
  in.r_s = f.r_s;
  in.r_p = f.r_p;
  in.t_s = f.t_s;
  in.t_p = f.t_p;
  in.from_inside = from_inside;
  run_surface(0, &in, parameters, &bare);
  cplx none = complex_of(lanes(0), lanes(0));
  cplx numbers[4] = {bare.r_s, bare.r_p, cpick(total, none, bare.t_s), cpick(total, none, bare.t_p)};
  store_numbers(out, 0, item_count, item, numbers, 4);
}

__kernel __attribute__((reqd_work_group_size(LOCAL_SIZE, 1, 1)))
void probe_fragment(__global const scalar* in, __global scalar* out, __global const scalar* parameters, int item_count, int is_surface,
                    int from_inside) {
  int item = (int)get_global_id(0);
  if (item >= item_count) return;
  real v[6];
  for (int i = 0; i < (is_surface ? 6 : 5); ++i) v[i] = load_lanes(in + ((size_t)i * item_count + item) * LANES);
  if (is_surface)
    ask_surface(v, parameters, out, item_count, item, from_inside);
  else
    ask_element(v, parameters, out, item_count, item);
}
