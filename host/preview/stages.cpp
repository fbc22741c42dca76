#include "host/preview/stages.hpp"

#include <algorithm>

namespace nicol::preview {

std::vector<Stage> stages(int first_step, int most_samples, bool adaptive) {
  std::vector<Stage> list;
  for (int step = first_step; step >= 1; step /= 2) list.push_back({step, 0, 1, false});
  if (adaptive) {
    list.push_back({1, 0, 1, true});
    return list;
  }
  for (int from = 1, to = 3; from < most_samples; from = to, to = from == 3 ? 5 : 2 * from + 1)
    list.push_back({1, from, to, false});
  return list;
}

std::vector<std::int32_t> pixels_of(const Stage& stage, bool first, int width, int height) {
  std::vector<std::int32_t> pixels;
  const bool further_samples = stage.sample_begin > 0;
  const int coarser = 2 * stage.step;
  for (int y = 0; y < height; y += stage.step)
    for (int x = 0; x < width; x += stage.step)
      if (first || further_samples || x % coarser != 0 || y % coarser != 0) pixels.push_back(y * width + x);
  return pixels;
}

int first_step(int width, int height, double pixel_seconds) {
  constexpr double glance_seconds = 0.03;
  constexpr int unknown = 16;
  if (pixel_seconds <= 0) return unknown;
  int step = 1;
  while (step < coarsest_step && pixel_seconds * width * height / (step * step) > glance_seconds) step *= 2;
  return step;
}

}  // namespace nicol::preview
