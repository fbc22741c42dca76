// OpenCL's errors by name.
#pragma once
#include <string>

#include "host/opencl/opencl.hpp"

namespace nicol {

// "CL_OUT_OF_RESOURCES"; "OpenCL error -9999" for a code that has no name.
std::string error_name(cl_int code);

// "clEnqueueNDRangeKernel failed with CL_DEVICE_NOT_AVAILABLE on pthread-haswell: the device is gone ...".
std::string error_message(const cl::Error& error, const std::string& device);

// ": what it means and what can be done", or "".
std::string way_out(cl_int code);

// True for the errors that mean too much memory or work at once.
bool is_shortage(cl_int code);

}  // namespace nicol
