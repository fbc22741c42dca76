#include "host/opencl/fragment_probe.hpp"

#include <algorithm>

#include "host/fragments/scene_fragments.hpp"
#include "host/opencl/scalar_buffer.hpp"

namespace nicol {
namespace {

template <class Real>
std::vector<double> read_back(cl::CommandQueue& queue, const cl::Buffer& buffer, std::size_t count) {
  std::vector<Real> values(count);
  queue.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(Real), values.data());
  return {values.begin(), values.end()};
}

}  // namespace

FragmentProbe::FragmentProbe(Device& device, std::shared_ptr<const Fragment> fragment, std::vector<double> parameters,
                             const KernelOptions& options)
    : device_(device), fragment_(std::move(fragment)), parameters_(std::move(parameters)), real_double_(options.real_double),
      lanes_(static_cast<std::size_t>(lanes_on(device, options))) {
  if (parameters_.empty()) parameters_.push_back(0);   // a buffer holds something
  KernelRequest request;
  request.file = "fragment_probe.cl";
  request.name = "probe_fragment";
  request.fragments = kernel_text({fragment_});
  request.lanes = static_cast<int>(lanes_);
  request.real_double = real_double_;
  request.binary_cache = options.binary_cache;
  request.set_no_work = [this](cl::Kernel& kernel, const cl::Buffer& empty) { set_arguments(kernel, empty, empty, empty, 0, 0); };
  kernel_ = get_kernel(device_, request);
}

void FragmentProbe::set_arguments(cl::Kernel& kernel, const cl::Buffer& in, const cl::Buffer& out, const cl::Buffer& parameters,
                                  std::size_t items, int from_inside) const {
  kernel.setArg(0, in);
  kernel.setArg(1, out);
  kernel.setArg(2, parameters);
  kernel.setArg(3, static_cast<cl_int>(items));
  kernel.setArg(4, cl_int{fragment_->kind == Fragment::Kind::surface});
  kernel.setArg(5, cl_int{from_inside});
}

std::vector<std::complex<double>> FragmentProbe::ask(const std::vector<double>& problems, std::size_t values, std::size_t answers,
                                                     int from_inside) {
  const std::size_t launch = lanes_ * static_cast<std::size_t>(max_work_groups * kernel_->local_size) * values;
  std::vector<std::complex<double>> result;
  result.reserve(problems.size() / values * answers);
  for (std::size_t first = 0; first < problems.size(); first += launch) {
    const auto from = problems.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = from + static_cast<std::ptrdiff_t>(std::min(launch, problems.size() - first));
    ask_at_once({from, to}, values, answers, from_inside, result);
  }
  return result;
}

void FragmentProbe::ask_at_once(const std::vector<double>& problems, std::size_t values, std::size_t answers, int from_inside,
                                std::vector<std::complex<double>>& result) {
  const std::size_t count = problems.size() / values, items = (count + lanes_ - 1) / lanes_, row = items * lanes_;
  std::vector<double> in(values * row);   // [value][problem], the last problem again in lanes that are left
  for (std::size_t v = 0; v < values; ++v)
    for (std::size_t i = 0; i < row; ++i) in[v * row + i] = problems[std::min(i, count - 1) * values + v];
  keep(kernel_);
  const Turn one_at_a_time(device_);
  const cl::Buffer in_buffer = scalar_buffer(device_.context, in, real_double_);
  const cl::Buffer parameter_buffer = scalar_buffer(device_.context, parameters_, real_double_);
  const std::size_t size = 2 * answers * row;
  const cl::Buffer out(device_.context, CL_MEM_WRITE_ONLY, size * (real_double_ ? sizeof(double) : sizeof(float)));
  set_arguments(kernel_->kernel, in_buffer, out, parameter_buffer, items, from_inside);
  enqueue(device_.queues[0], kernel_->kernel, kernel_->local_size, static_cast<std::int64_t>(items));
  const std::vector<double> numbers =
      real_double_ ? read_back<double>(device_.queues[0], out, size) : read_back<float>(device_.queues[0], out, size);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t a = 0; a < answers; ++a) result.emplace_back(numbers[2 * a * row + i], numbers[(2 * a + 1) * row + i]);
}

}  // namespace nicol
