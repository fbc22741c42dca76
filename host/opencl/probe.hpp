// `nicol probe`: faces, waves in the bulk and fields carried through it, in the oracle's JSON schema, solved on the device by
// the kernel code that renders.
#pragma once
#include <string>

#include "host/opencl/device.hpp"

namespace nicol {

// JSON text in, JSON text out. Throws std::runtime_error naming the case and member for malformed input.
std::string probe(Device& device, const std::string& json, bool real_double);

}  // namespace nicol
