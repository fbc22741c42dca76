#include "host/output/error_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nicol {
namespace {

constexpr int decades = 7;

std::array<float, 3> colour_of(double relative) {
  if (std::isnan(relative)) return {0, 1, 0};
  const double at = std::clamp(1 + std::log10(std::max(relative, 1e-30)) / decades, 0.0, 1.0);
  const std::array<std::array<double, 3>, 6> stops{{{0, 0, 0}, {0, 0, 0.6}, {0.5, 0, 0.6}, {0.9, 0, 0}, {1, 0.8, 0}, {1, 1, 1}}};
  const double place = at * (stops.size() - 1);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(below);
  std::array<float, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] = static_cast<float>(stops[below][k] * (1 - part) + stops[below + 1][k] * part);
  return rgb;
}

}  // namespace

Frame error_map(const Frame& picture, const std::vector<float>& sampling, double brightest, double rounding,
                double mean_radiance) {
  Frame map;
  map.width = picture.width;
  map.height = picture.height;
  map.row_done = picture.row_done;
  map.rows_done = picture.rows_done;
  map.how = picture.how;
  map.how.emplace_back("errorMap", "colours: total over the mean radiance, black 1e-7, white 1, logarithmic");
  std::vector<float> cut_off(picture.plane()), of_sampling(picture.plane()), total(picture.plane());
  for (std::size_t i = 0; i < picture.plane(); ++i) {
    cut_off[i] = static_cast<float>(static_cast<double>(picture.cut_off[i]) * brightest);
    of_sampling[i] = sampling.size() == 1 ? sampling[0] : sampling[i];
    const double sum = static_cast<double>(cut_off[i]) + static_cast<double>(of_sampling[i]) + rounding;
    total[i] = static_cast<float>(sum);
    for (const float c : colour_of(mean_radiance > 0 ? sum / mean_radiance : sum)) map.rgb.push_back(c);
  }
  map.planes = {{"error.cutoff", std::move(cut_off)},
                {"error.sampling", std::move(of_sampling)},
                {"error.rounding", std::vector<float>(picture.plane(), static_cast<float>(rounding))},
                {"error.total", std::move(total)}};
  return map;
}

}  // namespace nicol
