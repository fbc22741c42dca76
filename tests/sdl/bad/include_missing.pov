#include "nosuch.inc"
sphere { Unknown*2, 1 }
