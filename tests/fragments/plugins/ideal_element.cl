// Passes the projection of x on the plane across the ray: m m^T with m along x - (x.d) d.
FUNCTION void ideal_element(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  real size = lanes(1) / sqrt_of(in->s.x * in->s.x + in->p.x * in->p.x);
  real s = size * in->s.x, p = size * in->p.x;
  out->t.ss = real_number(s * s);
  out->t.sp = out->t.ps = real_number(s * p);
  out->t.pp = real_number(p * p);
}
