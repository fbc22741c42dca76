// Pictures with given Stokes vectors, as if they had been traced.
#pragma once
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "host/optics/colour.hpp"
#include "host/preview/picture.hpp"

namespace nicol::preview {

using Stokes = std::array<float, 4>;

// Puts a vector, the same at all wavelengths, into a pixel and what it shows.
inline void trace(Picture& picture, int x, int y, const Stokes& stokes) {
  Frame& frame = picture.frame;
  const std::size_t p = static_cast<std::size_t>(y) * frame.width + x;
  std::array<double, 3> xyz{};
  for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i) {
    const auto observer = colour_matching(frame.lambda_nm[i]);
    for (std::size_t k = 0; k < 3; ++k) xyz[k] += observer[k] * frame.weight_nm[i] * stokes[0];
    for (int s = 0; s < 4; ++s) frame.component(s, i)[p] = stokes[static_cast<std::size_t>(s)];
  }
  frame.samples[p] = 1;
  const auto rgb = linear_srgb(xyz);
  for (std::size_t k = 0; k < 3; ++k) picture.rgb[3 * p + k] = static_cast<float>(rgb[k]);
  for (std::size_t s = 0; s < 4; ++s)
    picture.stokes_y[4 * p + s] = stokes[0] > 0 ? static_cast<float>(xyz[1]) * stokes[s] / stokes[0] : 0;
}

inline Picture uniform(int width, int height, const Stokes& stokes, std::vector<double> lambda_nm = {450, 550, 650}) {
  Picture picture = make_picture(width, height, lambda_nm, wavelength_weights(lambda_nm));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) trace(picture, x, y, stokes);
  picture.step = 1;
  picture.mean_radiance = static_cast<double>(stokes[0]);
  return picture;
}

inline std::array<float, 3> colour_at(const std::vector<float>& rgb, int width, int x, int y) {
  const std::size_t p = 3 * (static_cast<std::size_t>(y) * width + x);
  return {rgb[p], rgb[p + 1], rgb[p + 2]};
}

}  // namespace nicol::preview
