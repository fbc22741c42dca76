// The kernels in float, 1 lane(s).
#define LANES 1
#define CONFIGURATION float1
#define in_CONFIGURATION in_float1
#define CONFIGURATION_NAME "float1"
#include "tests/kernels/configuration.inc"
