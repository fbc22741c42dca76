#include "host/engine/spot_check.hpp"

#include <algorithm>

#include "host/opencl/samples.hpp"
#include "host/pack.hpp"

namespace nicol::engine {

std::vector<std::int32_t> spread_pixels(int width, int height, int count) {
  const std::int64_t plane = static_cast<std::int64_t>(width) * height;
  std::vector<std::int32_t> pixels;
  if (count >= plane) {
    for (std::int32_t p = 0; p < plane; ++p) pixels.push_back(p);
    return pixels;
  }
  for (const auto& [x, y] : pixel_samples(count)) {
    const int column = std::min(width - 1, static_cast<int>(x * width)), row = std::min(height - 1, static_cast<int>(y * height));
    pixels.push_back(row * width + column);
  }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

SpotCheck::SpotCheck(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height,
                     Device& device, const KernelOptions& kernel, int pixels)
    : scene_(scene), geometry_(geometry), features_(features), width_(width), height_(height), device_(device),
      kernel_(kernel), pixels_(spread_pixels(width, height, pixels)) {}

SpotPicture SpotCheck::render(const Variant& variant) const {
  Scene scene = scene_;
  if (variant.adc_bailout > 0) scene.settings.adc_bailout = variant.adc_bailout;
  if (variant.max_trace_level > 0) scene.settings.max_trace_level = variant.max_trace_level;
  RenderOptions options;
  options.kernel = kernel_;
  // one kernel in double serves all scenes: it is built once
  if (variant.real_double && !kernel_.real_double) options.kernel.real_double = options.kernel.generic = true;
  options.samples = variant.samples;
  options.pixels = pixels_;
  options.cancel = cancel;
  SpotPicture picture;
  const PackedScene packed = pack(scene, geometry_, features_, width_, height_, lanes_on(device_, options.kernel));
  picture.frame = nicol::render(device_, packed, scene.lambda_nm, scene.weight_nm, options, picture.report);
  picture.frame.exposure = scene.settings.exposure;
  return picture;
}

}  // namespace nicol::engine
