#include "host/opencl/samples.hpp"

#include <cmath>

namespace nicol {

std::vector<std::array<double, 2>> pixel_samples(int count) {
  constexpr double g = 1.32471795724474602596;
  std::vector<std::array<double, 2>> samples;
  for (int i = 0; i < count; ++i) {
    const int pair = (i + 1) / 2;
    double x = 0.5 + pair / g, y = 0.5 + pair / (g * g);
    x -= std::floor(x);
    y -= std::floor(y);
    const bool mirrored = i > 0 && i % 2 == 0;
    samples.push_back({mirrored ? 1 - x : x, mirrored ? 1 - y : y});
  }
  return samples;
}

}  // namespace nicol
