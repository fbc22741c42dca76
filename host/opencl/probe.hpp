// `nicol probe`: face problems in the oracle's JSON schema, solved on the device by the kernel code that renders.
#pragma once
#include <string>

#include "host/opencl/device.hpp"

namespace nicol {

// JSON text in, JSON text out. Cases of a class that the kernels do not trace answer
// {"id", "unsupported": reason}. Throws std::runtime_error naming the case and member for malformed input.
std::string probe(Device& device, const std::string& json, bool real_double);

}  // namespace nicol
