// All that is known of one pixel of a picture.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "host/preview/picture.hpp"
#include "host/preview/view.hpp"

namespace nicol::preview {

struct PixelInfo {
  int x = 0, y = 0;                          // as asked for
  int block = 1;                             // > 1: it shows that of a block of so many pixels
  std::vector<double> lambda_nm;
  std::array<std::vector<double>, 4> stokes; // S0..S3 per nm at each wavelength
  std::array<double, 3> xyz{}, rgb{};        // times the exposure; linear sRGB
  std::array<int, 3> srgb{};                 // 0..255
  std::array<double, 4> stokes_y{};          // weighted by ybar
  Ellipse ellipse;                           // of stokes_y, or of the view's wavelength
  int samples = 0;
  double cut_off = 0;                        // weight of dropped paths relative to a full one
  double cut_off_radiance = 0;               // bound on what they could have brought, per nm, at the brightest wavelength
};

// None outside of the picture, or while nothing is traced there. exposure: a factor beside the frame's own, on the colours.
std::optional<PixelInfo> pixel_info(const Picture& picture, const View& view, int x, int y, double exposure = 1);

}  // namespace nicol::preview
