// The finished picture and the guests that take it: EXR, PNG, the preview.
#pragma once
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/output/zeroed.hpp"

namespace nicol {

// Stokes radiance per nm as the receiver sees it, in the conventions of kernels/README.md.
struct Frame {
  int width = 0, height = 0;
  std::vector<double> lambda_nm;
  std::vector<double> weight_nm;
  ZeroedFloats stokes;          // [component 0..3][wavelength][row from the top][column]
  std::vector<float> cut_off;   // [row][column]: weight of the paths cut off, relative to a full path
  // [wavelength][row][column]: of each wavelength alone, cut_off being their mean; only where it was asked for and each is traced by itself
  std::vector<float> channel_cut_off;
  std::vector<std::uint32_t> samples;  // [row][column]: that each pixel got; empty: all alike
  // [row][column]: estimated error of pixel sampling, RMS over wavelengths of the Stokes vector's, in units of radiance; empty: not known
  std::vector<float> sample_error;
  double exposure = 1;          // factor on R, G, B
  std::vector<float> rgb;               // linear sRGB, 3 a pixel, in place of what the spectra give; empty: that
  std::vector<std::pair<std::string, std::vector<float>>> planes;  // further channels of an EXR: name, [row][column]
  std::vector<std::pair<std::string, std::string>> how;  // scene, settings, device, error budget: for the header
  int rows_done = 0;            // an interrupted picture has its first rows only in no special order: see row_done
  std::vector<unsigned char> row_done;  // per row; rows not done are zero

  std::size_t plane() const { return static_cast<std::size_t>(width) * height; }
  float* component(int s, std::size_t lambda) { return stokes.data() + (s * lambda_nm.size() + lambda) * plane(); }
  const float* component(int s, std::size_t lambda) const {
    return stokes.data() + (s * lambda_nm.size() + lambda) * plane();
  }
};

// What the user must hear: the message is complete ("cannot write out.exr: No space left on device").
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Likewise of a picture that is read ("cannot read a.exr: ...").
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Takes a frame. Files appear whole or not at all: written under a temporary name beside the target, then renamed.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void write(const Frame& frame) = 0;   // throws OutputError
};

// By the suffix: .exr or .png. Throws OutputError for another suffix, a missing or read-only folder, a
// target that is a folder: before anything is rendered.
std::unique_ptr<FrameSink> make_sink(const std::string& path);

// Linear sRGB of the frame times its exposure: 3 floats a pixel, rows from the top.
std::vector<float> linear_rgb(const Frame& frame);

// How many pixels a PNG cannot show: a channel outside [0, 1] by more than half a step of 8 bit, or NaN.
std::size_t clipped_pixels(const Frame& frame);

}  // namespace nicol
