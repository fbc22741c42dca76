// Kernels built in a process of their own. While PoCL compiles a kernel it lets no other one start, for seconds; another process holds
// up nobody, and what it leaves in the binary cache is loaded in a moment.
#pragma once
#include <cstdint>
#include <string>

#include "host/opencl/render.hpp"

namespace nicol {

// Starts this program anew to build this kernel, and waits for it. True if it said that it has; false also where the program does not
// serve as builder (see serve_as_builder in render.hpp).
bool build_in_own_process(const Device& device, std::uint32_t features, const std::string& fragments, const KernelOptions& options);

}  // namespace nicol
