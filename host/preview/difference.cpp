// Two pictures of the same size compared: see difference.hpp. Test: tests/preview/difference_test.cpp.
#include "host/preview/difference.hpp"

#include <algorithm>
#include <cmath>

#include "host/accuracy/colour_difference.hpp"
#include "host/optics/colour.hpp"

namespace nicol::preview {
namespace {

// Indices of the pixels that both have traced.
std::vector<std::size_t> pixels_of_both(const Picture& left, const Picture& right) {
  std::vector<std::size_t> pixels;
  for (std::size_t p = 0; p < left.frame.plane(); ++p)
    if (left.frame.samples[p] > 0 && right.frame.samples[p] > 0) pixels.push_back(p);
  return pixels;
}

Developed developed_difference(const Picture& left, const Picture& right, const View& view) {
  View colours = view;
  colours.quantity = Quantity::colour;
  Developed developed = develop(left, colours);
  const Developed other = develop(right, colours);
  std::transform(developed.rgb.begin(), developed.rgb.end(), other.rgb.begin(), developed.rgb.begin(),
                 [](float a, float b) { return std::fabs(a - b); });
  return developed;
}

void compare_stokes(const Picture& left, const Picture& right, const std::vector<std::size_t>& pixels,
                    Difference& difference) {
  const std::size_t wavelengths = left.frame.lambda_nm.size();
  std::vector<float> squares(left.frame.plane(), 0);
  for (int s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < wavelengths; ++i) {
      const float *a = left.frame.component(s, i), *b = right.frame.component(s, i);
      for (std::size_t p = 0; p < squares.size(); ++p) squares[p] += (a[p] - b[p]) * (a[p] - b[p]);
    }

  double sum = 0, largest = -1;
  std::size_t place = 0;
  for (const std::size_t p : pixels) {
    const auto square = static_cast<double>(squares[p]);
    sum += square;
    if (square > largest) {
      largest = square;
      place = p;
    }
  }
  const auto count = static_cast<double>(wavelengths);
  const auto relative = [&](double square) {
    return square > 0 ? std::sqrt(square / count) / left.mean_radiance : 0;
  };
  difference.rms = relative(sum / static_cast<double>(pixels.size()));
  difference.largest = relative(largest);
  difference.x = static_cast<int>(place % static_cast<std::size_t>(left.frame.width));
  difference.y = static_cast<int>(place / static_cast<std::size_t>(left.frame.width));
}

Lab lab_of(const Picture& picture, std::size_t pixel, double exposure) {
  const float* rgb = picture.rgb.data() + 3 * pixel;
  return lab_of_xyz(xyz_of_linear_srgb({rgb[0] * exposure, rgb[1] * exposure, rgb[2] * exposure}));
}

// CIEDE2000 is at most this, as its S_L, S_C, S_H are at least 1, a' at most 1.5 a, and |R_T| at most 2, so that
// the mixed term is at most the sum of the squares of chroma and hue.
double most_ciede2000(const Lab& a, const Lab& b) {
  const double l = a[0] - b[0], across = 1.5 * (a[1] - b[1]), along = a[2] - b[2];
  return std::sqrt(l * l + 2 * (across * across + along * along));
}

double largest_delta_e(const Picture& left, const Picture& right, const std::vector<std::size_t>& pixels) {
  const double exposure = left.frame.exposure;
  double largest = 0;
  for (const std::size_t p : pixels) {
    if (std::equal(left.rgb.begin() + 3 * p, left.rgb.begin() + 3 * p + 3, right.rgb.begin() + 3 * p)) continue;
    const Lab a = lab_of(left, p, exposure), b = lab_of(right, p, exposure);
    if (most_ciede2000(a, b) > largest) largest = std::max(largest, ciede2000(a, b));
  }
  return largest;
}

}  // namespace

Difference difference(const Picture& left, const Picture& right, const View& view) {
  Difference difference;
  const Frame &a = left.frame, &b = right.frame;
  if (a.width != b.width || a.height != b.height || a.lambda_nm != b.lambda_nm) return difference;
  const auto pixels = pixels_of_both(left, right);
  if (pixels.empty() || a.lambda_nm.empty()) return difference;
  difference.comparable = true;
  difference.developed = developed_difference(left, right, view);
  compare_stokes(left, right, pixels, difference);
  difference.delta_e_largest = largest_delta_e(left, right, pixels);
  return difference;
}

}  // namespace nicol::preview
