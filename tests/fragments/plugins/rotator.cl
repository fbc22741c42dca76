FUNCTION void rotator(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  real sign = pick((in->direction.z < lanes(0)) & (lanes(P_faraday) > lanes(0.5)), lanes(-1), lanes(1));
  out->t.ss = out->t.pp = real_number(lanes(0.866025403784438647));
  out->t.ps = real_number(lanes(0.5) * sign);
  out->t.sp = real_number(lanes(-0.5) * sign);
}
