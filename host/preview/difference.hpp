// Two pictures of the same size compared.
#pragma once
#include <vector>

#include "host/preview/picture.hpp"
#include "host/preview/view.hpp"

namespace nicol::preview {

struct Difference {
  bool comparable = false;       // same size, and something traced in both
  Developed developed;           // |left - right| of linear sRGB (at one wavelength: of its grey), not yet amplified
  // Of the Stokes vector's, relative to the mean radiance of the left picture, RMS over the wavelengths that both have: over the
  // pixels that both have traced, and the largest of a pixel with its place. Without a common wavelength: of the Stokes vector
  // weighted by ybar, relative to the mean luminance.
  double rms = 0, largest = 0;
  int x = 0, y = 0;
  double delta_e_largest = 0;    // CIEDE2000 of the colours, white Y = 1/exposure
};
Difference difference(const Picture& left, const Picture& right, const View& view);

}  // namespace nicol::preview
