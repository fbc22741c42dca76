// The same kernel headers compiled by the C++ compiler: the yardstick for what OpenCL makes of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/pack.hpp"

namespace nicol::bench {

struct NativeResult {
  std::uint64_t segments = 0;
  std::vector<double> out;   // as the trace kernel writes it
};

// One thread, one sample at the centre of each pixel. The scene must be packed for `native_lanes`.
inline constexpr int native_lanes = 8;
NativeResult render_native_lanes(const PackedScene& scene);
// Packed for 1 lane; generic double is the reference of the parity test.
NativeResult render_native_scalar(const PackedScene& scene);
NativeResult render_native_double(const PackedScene& scene);

}  // namespace nicol::bench
