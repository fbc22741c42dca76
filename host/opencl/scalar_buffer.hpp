// Read-only buffers of the device's real from the host's doubles.
#pragma once
#include <vector>

#include "host/opencl/opencl.hpp"

namespace nicol {

// OpenCL has no empty buffers: an empty vector becomes one element.
template <class T>
cl::Buffer constant_buffer(const cl::Context& context, std::vector<T> values) {
  if (values.empty()) values.resize(1);
  return cl::Buffer(context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(T), values.data());
}

inline cl::Buffer int_buffer(const cl::Context& context, const std::vector<std::int32_t>& values) {
  return constant_buffer<cl_int>(context, {values.begin(), values.end()});
}

inline cl::Buffer scalar_buffer(const cl::Context& context, const std::vector<double>& values, bool real_double) {
  if (real_double) return constant_buffer<cl_double>(context, values);
  std::vector<cl_float> narrow(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) narrow[i] = static_cast<cl_float>(values[i]);
  return constant_buffer<cl_float>(context, std::move(narrow));
}

}  // namespace nicol
