// Two pictures of the same size compared: see difference.hpp. Test: tests/preview/difference_test.cpp.
#include "host/preview/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <thread>

#include "host/accuracy/colour_difference.hpp"
#include "host/optics/colour.hpp"

namespace nicol::preview {
namespace {

// Indices of a wavelength in the left and in the right picture.
using Pair = std::array<std::size_t, 2>;

std::vector<Pair> common_wavelengths(const Frame& a, const Frame& b) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0, j = 0; i < a.lambda_nm.size() && j < b.lambda_nm.size();) {
    if (a.lambda_nm[i] == b.lambda_nm[j]) pairs.push_back({i++, j++});
    else if (a.lambda_nm[i] < b.lambda_nm[j]) ++i;
    else ++j;
  }
  return pairs;
}

// At a wavelength that the right picture has not: the colours.
Developed developed_difference(const Picture& left, const Picture& right, const std::vector<Pair>& common, const View& view) {
  View colours{Quantity::colour, {}}, others = colours;
  for (const Pair& pair : common)
    if (view.wavelength == pair[0]) {
      colours.wavelength = pair[0];
      others.wavelength = pair[1];
    }
  Developed developed = develop(left, colours);
  Developed other = develop(right, others);
  if (colours.wavelength) {   // the greys of both on the left one's scale
    const auto scale = static_cast<float>(grey_per_radiance(left.frame) / grey_per_radiance(right.frame));
    for (float& value : other.rgb) value *= scale;
  }
  std::transform(developed.rgb.begin(), developed.rgb.end(), other.rgb.begin(), developed.rgb.begin(),
                 [](float a, float b) { return std::fabs(a - b); });
  return developed;
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

// What pixels [first, last) differ by.
struct Band {
  std::size_t count = 0;                // of those that both have traced
  double sum = 0, largest = -1;         // of the squares, summed over components and wavelengths
  std::size_t place = 0;
  double delta_e = 0;
};

void compare_stokes(const Picture& left, const Picture& right, const std::vector<Pair>& common, std::size_t first, std::size_t last,
                    Band& band) {
  std::vector<float> squares(last - first, 0);
  for (int s = 0; s < 4; ++s)
    for (const auto& [i, j] : common) {
      const float *a = left.frame.component(s, i) + first, *b = right.frame.component(s, j) + first;
      for (std::size_t p = 0; p < squares.size(); ++p) squares[p] += (a[p] - b[p]) * (a[p] - b[p]);
    }
  if (common.empty())
    for (std::size_t i = 0; i < 4 * squares.size(); ++i) {
      const float change = left.stokes_y[4 * first + i] - right.stokes_y[4 * first + i];
      squares[i / 4] += change * change;
    }
  for (std::size_t p = first; p < last; ++p) {
    if (left.frame.samples[p] == 0 || right.frame.samples[p] == 0) continue;
    const auto square = static_cast<double>(squares[p - first]);
    ++band.count;
    band.sum += square;
    if (square > band.largest) {
      band.largest = square;
      band.place = p;
    }
  }
}

void compare_colours(const Picture& left, const Picture& right, std::size_t first, std::size_t last, Band& band) {
  const double exposure = left.frame.exposure;
  for (std::size_t p = first; p < last; ++p) {
    if (left.frame.samples[p] == 0 || right.frame.samples[p] == 0) continue;
    const float *a = left.rgb.data() + 3 * p, *b = right.rgb.data() + 3 * p;
    if (std::equal(a, a + 3, b)) continue;
    const Lab one = lab_of(left, p, exposure), other = lab_of(right, p, exposure);
    if (most_ciede2000(one, other) > band.delta_e) band.delta_e = std::max(band.delta_e, ciede2000(one, other));
  }
}

// All pixels, in bands on as many cores as there are.
Band compare(const Picture& left, const Picture& right, const std::vector<Pair>& common) {
  const std::size_t plane = left.frame.plane();
  const std::size_t bands = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
  std::vector<std::future<Band>> parts;
  for (std::size_t i = 0; i < bands; ++i)
    parts.push_back(std::async(std::launch::async, [&, first = plane * i / bands, last = plane * (i + 1) / bands] {
      Band band;
      compare_stokes(left, right, common, first, last, band);
      compare_colours(left, right, first, last, band);
      return band;
    }));
  Band all;
  for (auto& part : parts) {
    const Band band = part.get();
    all.count += band.count;
    all.sum += band.sum;
    all.delta_e = std::max(all.delta_e, band.delta_e);
    if (band.largest > all.largest) {
      all.largest = band.largest;
      all.place = band.place;
    }
  }
  return all;
}

double mean_luminance(const Picture& picture) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t p = 0; p < picture.frame.plane(); ++p) {
    if (picture.frame.samples[p] == 0) continue;
    sum += static_cast<double>(picture.stokes_y[4 * p]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

Difference difference(const Picture& left, const Picture& right, const View& view) {
  Difference difference;
  const Frame &a = left.frame, &b = right.frame;
  if (a.width != b.width || a.height != b.height || a.lambda_nm.empty() || b.lambda_nm.empty()) return difference;
  const std::vector<Pair> common = common_wavelengths(a, b);
  const Band all = compare(left, right, common);
  if (all.count == 0) return difference;

  difference.comparable = true;
  difference.developed = developed_difference(left, right, common, view);
  const double wavelengths = common.empty() ? 1 : static_cast<double>(common.size());
  const double mean = common.empty() ? mean_luminance(left) : left.mean_radiance;
  const auto relative = [&](double square) { return square > 0 ? std::sqrt(square / wavelengths) / mean : 0; };
  difference.rms = relative(all.sum / static_cast<double>(all.count));
  difference.largest = relative(all.largest);
  difference.x = static_cast<int>(all.place % static_cast<std::size_t>(a.width));
  difference.y = static_cast<int>(all.place / static_cast<std::size_t>(a.width));
  difference.delta_e_largest = all.delta_e;
  return difference;
}

}  // namespace nicol::preview
