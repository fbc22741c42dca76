FUNCTION void inner_gain(PRIVATE const SurfaceIn* in, GLOBAL const scalar* parameter, PRIVATE SurfaceOut* out) {
  real factor = in->from_inside ? lanes(P_factor) : lanes(1);
  out->r_s = cscale(factor, in->r_s);
  out->r_p = in->r_p;
  out->t_s = in->t_s;
  out->t_p = in->t_p;
}
