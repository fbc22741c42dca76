// Pictures that get finer: see picture.hpp. Test: tests/preview/picture_test.cpp.
#include "host/preview/picture.hpp"

#include <algorithm>

namespace nicol::preview {
namespace {

constexpr float untraced_grey = 0.02f;  // linear: told apart from black

}  // namespace

Picture make_picture(int width, int height, const std::vector<double>& lambda_nm,
                     const std::vector<double>& weight_nm) {
  Picture picture;
  Frame& frame = picture.frame;
  frame.width = width;
  frame.height = height;
  frame.lambda_nm = lambda_nm;
  frame.weight_nm = weight_nm;
  frame.stokes.resize(4 * lambda_nm.size() * frame.plane());
  frame.cut_off.assign(frame.plane(), 0);
  frame.samples.assign(frame.plane(), 0);
  picture.rgb.assign(3 * frame.plane(), untraced_grey);
  picture.stokes_y.assign(4 * frame.plane(), 0);
  return picture;
}

void forget(Picture& picture) {
  std::fill(picture.frame.samples.begin(), picture.frame.samples.end(), 0);
  picture.step = 0;
  ++picture.version;
}

std::int64_t shown_pixel(const Picture& picture, int x, int y) {
  const std::uint32_t* samples = picture.frame.samples.data();
  for (int step = 1; step <= largest_block; step *= 2) {
    const std::int64_t corner = std::int64_t{y - y % step} * picture.frame.width + (x - x % step);
    if (samples[corner] > 0) return corner;
  }
  return -1;
}

}  // namespace nicol::preview
