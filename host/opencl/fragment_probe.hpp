// A fragment alone on a device, asked for its amplitudes (kernels/fragment_probe.cl).
#pragma once
#include <complex>
#include <memory>
#include <vector>

#include "host/fragments/fragment.hpp"
#include "host/opencl/program.hpp"

namespace nicol {

class FragmentProbe {
 public:
  // Builds it with as many lanes and in the precision of a picture with these options. Throws DeviceError with the compiler's log.
  FragmentProbe(Device& device, std::shared_ptr<const Fragment> fragment, std::vector<double> parameters, const KernelOptions& options);

  // problems: `values` numbers each, one problem after the other, as fragment_probe.cl takes them; answers: `answers` numbers each.
  std::vector<std::complex<double>> ask(const std::vector<double>& problems, std::size_t values, std::size_t answers, int from_inside);

  static constexpr std::size_t element_values = 5, element_answers = 8, surface_values = 6, surface_answers = 4;

 private:
  void set_arguments(cl::Kernel& kernel, const cl::Buffer& in, const cl::Buffer& out, const cl::Buffer& parameters, std::size_t items,
                     int from_inside) const;
  // One launch; its answers go to the end of `result`.
  void ask_at_once(const std::vector<double>& problems, std::size_t values, std::size_t answers, int from_inside,
                   std::vector<std::complex<double>>& result);

  Device& device_;
  const std::shared_ptr<const Fragment> fragment_;
  std::vector<double> parameters_;
  const bool real_double_;
  const std::size_t lanes_;
  std::shared_ptr<const Kernel> kernel_;
};

}  // namespace nicol
