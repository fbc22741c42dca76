// The kernels in double, 8 lane(s).
#define LANES 8
#define REAL_DOUBLE
#define CONFIGURATION double8
#define in_CONFIGURATION in_double8
#define CONFIGURATION_NAME "double8"
#include "tests/kernels/configuration.inc"
