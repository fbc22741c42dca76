// One transparent layer on a face: layer_on_face of kernels/fragment.h has the equations.
FUNCTION void thin_film(PRIVATE const SurfaceIn* in, GLOBAL const scalar* parameter, PRIVATE SurfaceOut* out) {
  layer_on_face(in, real_number(lanes(P_n)), lanes(P_thickness_nm), out);
}
