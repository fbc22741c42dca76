#include "host/opencl/samples.hpp"

#include <cmath>

namespace nicol {

std::vector<std::array<double, 2>> pixel_samples(int count) {
  constexpr double g = 1.32471795724474602596;
  std::vector<std::array<double, 2>> samples;
  for (int i = 0; i < count; ++i) {
    const double x = 0.5 + i / g, y = 0.5 + i / (g * g);
    samples.push_back({x - std::floor(x), y - std::floor(y)});
  }
  return samples;
}

}  // namespace nicol
