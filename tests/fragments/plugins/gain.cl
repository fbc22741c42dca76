FUNCTION void gain(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  out->t.ss = out->t.pp = real_number(lanes(P_factor < 0 ? sqrt(P_factor) : P_factor));
}
