// See picture_error.hpp. Test: tests/accuracy/picture_error_test.cpp.
#include "host/accuracy/picture_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host/accuracy/colour_difference.hpp"
#include "host/optics/colour.hpp"

namespace nicol {
namespace {

using Triple = std::array<double, 3>;

bool row_done(const Frame& frame, int row) {
  return frame.row_done.empty() || frame.row_done[static_cast<std::size_t>(row)] != 0;
}

// Indices of the pixels whose rows are done in both.
std::vector<std::size_t> pixels_done(const Frame& a, const Frame& b) {
  std::vector<std::size_t> pixels;
  const auto width = static_cast<std::size_t>(a.width);
  for (int row = 0; row < a.height; ++row)
    if (row_done(a, row) && row_done(b, row))
      for (std::size_t x = 0; x < width; ++x) pixels.push_back(static_cast<std::size_t>(row) * width + x);
  return pixels;
}

// XYZ of each pixel by the wavelengths whose places are given, with weights of their own.
std::vector<Triple> xyz_of(const Frame& frame, const std::vector<std::size_t>& places,
                           const std::vector<double>& weight_nm) {
  std::vector<Triple> xyz(frame.plane(), Triple{});
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Triple observer = colour_matching(frame.lambda_nm[places[i]]);
    const float* radiance = frame.component(0, places[i]);
    for (std::size_t p = 0; p < xyz.size(); ++p)
      for (int k = 0; k < 3; ++k) xyz[p][k] += observer[k] * weight_nm[i] * static_cast<double>(radiance[p]);
  }
  return xyz;
}

std::vector<std::size_t> all_places(const Frame& frame) {
  std::vector<std::size_t> places(frame.lambda_nm.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  return places;
}

double relative(double error, double mean) { return error == 0 ? 0 : error / mean; }

struct SquareSum {
  double sum = 0, largest = 0;
  std::size_t count = 0;
  void add(double square) {
    sum += square;
    largest = largest >= square ? largest : square;  // NaN stays
    ++count;
  }
  double rms() const { return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count)); }
  double max() const { return std::sqrt(largest); }
};

// Places of the same wavelength in both.
std::vector<std::pair<std::size_t, std::size_t>> common_wavelengths(const Frame& a, const Frame& b) {
  constexpr double same_nm = 1e-6;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t i = 0; i < a.lambda_nm.size(); ++i)
    for (std::size_t j = 0; j < b.lambda_nm.size(); ++j)
      if (std::fabs(a.lambda_nm[i] - b.lambda_nm[j]) < same_nm) places.emplace_back(i, j);
  return places;
}

void compare_stokes(const Frame& picture, const Frame& reference, const std::vector<std::size_t>& pixels,
                    PictureError& error) {
  SquareSum squares;
  double light = 0;
  for (const auto& [i, j] : common_wavelengths(picture, reference)) {
    for (const std::size_t p : pixels) {
      double square = 0;
      for (int s = 0; s < 4; ++s) {
        const double d = static_cast<double>(picture.component(s, i)[p]) - reference.component(s, j)[p];
        square += d * d;
      }
      squares.add(square);
      light += reference.component(0, j)[p];
    }
    ++error.wavelengths;
  }
  const double mean = squares.count == 0 ? 0 : light / static_cast<double>(squares.count);
  error.stokes_rms = relative(squares.rms(), mean);
  error.stokes_max = relative(squares.max(), mean);
}

// What two sets of colours differ by; Error has xyz_* and ciede_*.
template <class Error>
void compare_colours(const std::vector<Triple>& picture, const std::vector<Triple>& reference, double exposure,
                     const std::vector<std::size_t>& pixels, Error& error) {
  SquareSum squares;
  double luminance = 0, sum = 0;
  std::vector<double> differences;
  const auto exposed = [&](const Triple& xyz) {
    return Triple{xyz[0] * exposure, xyz[1] * exposure, xyz[2] * exposure};
  };
  for (const std::size_t p : pixels) {
    double square = 0;
    for (int k = 0; k < 3; ++k) square += (picture[p][k] - reference[p][k]) * (picture[p][k] - reference[p][k]);
    squares.add(square);
    luminance += reference[p][1];
    differences.push_back(ciede2000(lab_of_xyz(exposed(picture[p])), lab_of_xyz(exposed(reference[p]))));
    sum += differences.back();
  }
  if (pixels.empty()) return;
  const auto count = static_cast<double>(pixels.size());
  error.xyz_rms = relative(squares.rms(), luminance / count);
  error.xyz_max = relative(squares.max(), luminance / count);
  error.ciede_mean = sum / count;
  if (std::isnan(sum)) {
    error.ciede_95 = error.ciede_worst = sum;
    return;
  }
  const auto at_95 = static_cast<std::ptrdiff_t>(std::ceil(0.95 * count)) - 1;
  std::nth_element(differences.begin(), differences.begin() + at_95, differences.end());
  error.ciede_95 = differences[static_cast<std::size_t>(at_95)];
  error.ciede_worst = *std::max_element(differences.begin() + at_95, differences.end());
}

// "" or why every second wavelength says nothing about all of them.
std::string why_no_estimate(const std::vector<double>& lambda_nm) {
  const std::size_t count = lambda_nm.size();
  if (count < 3) return std::to_string(count) + (count == 1 ? " wavelength" : " wavelengths");
  const double step_nm = (lambda_nm.back() - lambda_nm.front()) / static_cast<double>(count - 1);
  constexpr double same_step = 1e-6;
  for (std::size_t i = 1; i < count; ++i)
    if (std::fabs(lambda_nm[i] - lambda_nm[i - 1] - step_nm) > same_step * step_nm)
      return "the wavelengths are not equally spaced";
  return "";
}

// XYZ of each pixel by every `stride`th wavelength and the last one.
std::vector<Triple> xyz_at(const Frame& picture, std::size_t stride) {
  std::vector<std::size_t> places;
  std::vector<double> lambda_nm;
  const std::size_t count = picture.lambda_nm.size();
  for (std::size_t i = 0; i < count; ++i)
    if (i % stride == 0 || i + 1 == count) places.push_back(i);
  for (const std::size_t i : places) lambda_nm.push_back(picture.lambda_nm[i]);
  return xyz_of(picture, places, wavelength_weights(lambda_nm));
}

// log2 of how much less the last halving of the step changed than the one before, within 1 (spectra with jumps, as
// where an edge of a lamp passes by) and 2 (smooth ones). What falls faster than 2^3 has not converged but cancels: 1.
double observed_order(const std::vector<Triple>& all, const std::vector<Triple>& half,
                      const std::vector<Triple>& quarter, const std::vector<std::size_t>& pixels) {
  double fine = 0, coarse = 0;
  for (const std::size_t p : pixels)
    for (int k = 0; k < 3; ++k) {
      fine += (all[p][k] - half[p][k]) * (all[p][k] - half[p][k]);
      coarse += (half[p][k] - quarter[p][k]) * (half[p][k] - quarter[p][k]);
    }
  if (!(fine > 0)) return 2;
  const double order = std::log2(coarse / fine) / 2;
  return order > 3 ? 1 : std::min(std::max(order, 1.0), 2.0);
}

}  // namespace

double PictureError::rms() const {
  if (std::isnan(stokes_rms) || std::isnan(xyz_rms)) return NAN;
  return std::max(stokes_rms, xyz_rms);
}

PictureError picture_error(const Frame& picture, const Frame& reference) {
  if (picture.width != reference.width || picture.height != reference.height)
    throw std::invalid_argument("pictures of " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                                " and " + std::to_string(reference.width) + "x" + std::to_string(reference.height) +
                                " pixels cannot be compared");
  PictureError error;
  const auto pixels = pixels_done(picture, reference);
  error.pixels = pixels.size();
  compare_stokes(picture, reference, pixels, error);
  compare_colours(xyz_of(picture, all_places(picture), picture.weight_nm),
                  xyz_of(reference, all_places(reference), reference.weight_nm), reference.exposure, pixels, error);
  return error;
}

SpectralStep spectral_step(const Frame& picture) {
  SpectralStep step;
  step.reason = why_no_estimate(picture.lambda_nm);
  step.known = step.reason.empty();
  if (!step.known) return step;
  const auto pixels = pixels_done(picture, picture);
  const auto all = xyz_of(picture, all_places(picture), picture.weight_nm), half = xyz_at(picture, 2);
  step.order = observed_order(all, half, xyz_at(picture, 4), pixels);

  // The integral, extrapolated: all + (all - half)/(2^order - 1).
  auto integral = half;
  const double share = 1 / (std::pow(2, step.order) - 1);
  for (std::size_t p = 0; p < all.size(); ++p)
    for (int k = 0; k < 3; ++k) integral[p][k] = all[p][k] + (all[p][k] - half[p][k]) * share;
  compare_colours(all, integral, picture.exposure, pixels, step);
  return step;
}

}  // namespace nicol
