// Turns by 30 degrees about z, whichever way light runs.
FUNCTION void faraday(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  real sign = pick(in->direction.z < lanes(0), lanes(-1), lanes(1));
  out->t.ss = out->t.pp = real_number(lanes(0.866025403784438647));
  out->t.ps = real_number(lanes(0.5) * sign);
  out->t.sp = real_number(lanes(-0.5) * sign);
}
