// A picture that gets finer while it is looked at: coarse blocks first, then every pixel, then further samples.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "host/output/frame.hpp"

namespace nicol::preview {

// Spectra are in `frame`, of the pixels traced so far (frame.samples > 0: how many samples their mean is of); what is
// shown of every pixel is in `rgb` and `stokes_y`. Until a pixel is traced it shows the one at the corner of the smallest
// block that has been.
struct Picture {
  Frame frame;                    // stokes, cut_off: means over samples; samples is never empty
  int step = 0;                   // every pixel whose row and column are multiples of it is traced; 0: nothing is
  std::vector<float> rgb;         // [row][column][3]: linear sRGB, exposure 1
  std::vector<float> stokes_y;    // [row][column][4]: Stokes radiance weighted by CIE 1931 ybar (S0: luminance Y)
  double mean_radiance = 0;       // S0 per nm, over the traced pixels and wavelengths
  double brightest_radiance = 0;  // per nm, of the scene's lights: times cut_off the bound of what is missing
  std::uint64_t version = 0;      // counts changes
};

// Sized, nothing traced.
Picture make_picture(int width, int height, const std::vector<double>& lambda_nm, const std::vector<double>& weight_nm);

// Nothing of it holds any longer; what it shows stays until it is traced anew.
void forget(Picture& picture);

inline constexpr int largest_block = 64;

// The traced pixel (row * width + column) that pixel (x, y) shows: the corner of the
// smallest traced block of 1, 2, 4, ... largest_block pixels; -1: none yet.
std::int64_t shown_pixel(const Picture& picture, int x, int y);

}  // namespace nicol::preview
