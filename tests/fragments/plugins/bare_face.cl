FUNCTION void bare_face(PRIVATE const SurfaceIn* in, GLOBAL const scalar* parameter, PRIVATE SurfaceOut* out) {
  out->r_s = in->r_s;
  out->r_p = in->r_p;
  out->t_s = in->t_s;
  out->t_p = in->t_p;
}
