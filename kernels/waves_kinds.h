// What kinds of waves a medium has: which solver of waves.h answers for it.
#ifndef NICOL_WAVES_KINDS_H
#define NICOL_WAVES_KINDS_H

enum {
  WAVES_ISOTROPIC = 0,  // one index
  WAVES_UNIAXIAL,       // ordinary and extraordinary wave
  WAVES_GENERAL,        // biaxial, or anisotropic and optically active
  WAVES_CHIRAL          // isotropic and optically active: two circular waves
};

#endif
