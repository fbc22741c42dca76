#include <cmath>
#include <cstddef>

#include "tests/bench/native.hpp"

// Generic, double, one lane: the plainest compilation of the kernels.
namespace nicol::bench {
#define LANES 1
#define REAL_DOUBLE
namespace kernel {
namespace {
#include "kernels/render.h"
}
}  // namespace kernel
#define FUNCTION_NAME render_native_double
#include "tests/bench/native.inc"
}  // namespace nicol::bench
