// Solves face problems on the device.
#include "host/opencl/probe.hpp"

#include <algorithm>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/probe_document.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/scalar_buffer.hpp"
#include "kernels/probe_abi.h"

namespace nicol {
namespace {

void set_arguments(cl::Kernel& kernel, const cl::Buffer& problems, const cl::Buffer& answers, std::size_t count) {
  kernel.setArg(0, problems);
  kernel.setArg(1, answers);
  kernel.setArg(2, static_cast<cl_int>(count));
}

std::shared_ptr<const Kernel> probe_kernel(Device& device, bool real_double) {
  KernelRequest request;
  request.file = "probe.cl";
  request.name = "probe";
  request.real_double = real_double;
  request.set_no_work = [](cl::Kernel& kernel, const cl::Buffer& empty) { set_arguments(kernel, empty, empty, 0); };
  return get_kernel(device, request);
}

template <class Real>
std::vector<double> read_back(cl::CommandQueue& queue, const cl::Buffer& buffer, std::size_t count) {
  std::vector<Real> values(count);
  queue.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(Real), values.data());
  return {values.begin(), values.end()};
}

// ANSWER_SCALARS per problem.
std::vector<double> solve(Device& device, const std::shared_ptr<const Kernel>& built, const std::vector<double>& problems, bool real_double) {
  keep(built);
  const Turn one_at_a_time(device);
  const std::size_t count = problems.size() / PROBE_SCALARS, values = count * ANSWER_SCALARS;
  const cl::Buffer in = scalar_buffer(device.context, problems, real_double);
  const cl::Buffer out(device.context, CL_MEM_WRITE_ONLY, values * (real_double ? sizeof(double) : sizeof(float)));
  set_arguments(built->kernel, in, out, count);
  enqueue(device.queues[0], built->kernel, built->local_size, static_cast<std::int64_t>(count));
  return real_double ? read_back<double>(device.queues[0], out, values)
                     : read_back<float>(device.queues[0], out, values);
}

}  // namespace

std::string probe(Device& device, const std::string& text, bool real_double) {
  try {
    return answer_document(text, device.about.name, real_double ? "double" : "float", [&](const std::vector<double>& problems) {
      const auto kernel = probe_kernel(device, real_double);
      const std::size_t launch = static_cast<std::size_t>(max_work_groups * kernel->local_size) * PROBE_SCALARS;
      std::vector<double> answers;
      for (std::size_t first = 0; first < problems.size(); first += launch) {
        const auto from = problems.begin() + static_cast<std::ptrdiff_t>(first);
        const auto to = from + static_cast<std::ptrdiff_t>(std::min(launch, problems.size() - first));
        const auto some = solve(device, kernel, {from, to}, real_double);
        answers.insert(answers.end(), some.begin(), some.end());
      }
      return answers;
    });
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
}

}  // namespace nicol
