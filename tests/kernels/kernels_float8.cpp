// The kernels in float, 8 lane(s).
#define LANES 8
#define CONFIGURATION float8
#define in_CONFIGURATION in_float8
#define CONFIGURATION_NAME "float8"
#include "tests/kernels/configuration.inc"
