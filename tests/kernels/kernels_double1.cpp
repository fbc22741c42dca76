// The kernels in double, 1 lane(s).
#define LANES 1
#define REAL_DOUBLE
#define CONFIGURATION double1
#define in_CONFIGURATION in_double1
#define CONFIGURATION_NAME "double1"
#include "tests/kernels/configuration.inc"
