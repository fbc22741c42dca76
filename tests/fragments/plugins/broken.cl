// The next line but one is wrong.
FUNCTION void broken(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {
  out->t.ss = no_such_thing(in);
}
