#include <cmath>
#include <cstddef>

#include "tests/bench/native.hpp"

namespace nicol::bench {
#define LANES 8
#define SCENE_FEATURES NICOL_BENCH_FEATURES
namespace kernel {
namespace {
#include "kernels/render.h"
}
}  // namespace kernel
#define FUNCTION_NAME render_native_lanes
#include "tests/bench/native.inc"
}  // namespace nicol::bench
