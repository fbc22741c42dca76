// t = sqrt(1 - R), r = i sqrt(R): together unitary.
FUNCTION void splitter(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  out->t.ss = out->t.pp = real_number(sqrt_of(lanes(1 - P_share)));
  out->r.ss = times_i(real_number(sqrt_of(lanes(P_share))));
  out->r.pp = out->r.ss;
}
