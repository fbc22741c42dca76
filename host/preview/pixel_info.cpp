// All that is known of one pixel: see pixel_info.hpp. Test: tests/preview/pixel_info_test.cpp.
#include "host/preview/pixel_info.hpp"

#include <cmath>

#include "host/optics/colour.hpp"
#include "host/preview/ellipse.hpp"

namespace nicol::preview {
namespace {

// Side of the block whose corner the pixel shows.
int block_of(const Picture& picture, std::int64_t corner, int x, int y) {
  int block = 1;
  while (std::int64_t{y - y % block} * picture.frame.width + (x - x % block) != corner) block *= 2;
  return block;
}

void weigh_spectrum(const Frame& frame, double exposure, PixelInfo& info) {
  for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i) {
    const auto observer = colour_matching(frame.lambda_nm[i]);
    for (std::size_t k = 0; k < 3; ++k)
      info.xyz[k] += observer[k] * frame.weight_nm[i] * frame.exposure * exposure * info.stokes[0][i];
    for (std::size_t s = 0; s < 4; ++s) info.stokes_y[s] += observer[1] * frame.weight_nm[i] * info.stokes[s][i];
  }
  info.rgb = linear_srgb(info.xyz);
  for (std::size_t k = 0; k < 3; ++k) info.srgb[k] = static_cast<int>(std::lround(255 * srgb_encode(info.rgb[k])));
}

}  // namespace

std::optional<PixelInfo> pixel_info(const Picture& picture, const View& view, int x, int y, double exposure) {
  const Frame& frame = picture.frame;
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return std::nullopt;
  const std::int64_t corner = shown_pixel(picture, x, y);
  if (corner < 0) return std::nullopt;
  const auto p = static_cast<std::size_t>(corner);

  PixelInfo info;
  info.x = x;
  info.y = y;
  info.block = block_of(picture, corner, x, y);
  info.lambda_nm = frame.lambda_nm;
  for (int s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i)
      info.stokes[static_cast<std::size_t>(s)].push_back(static_cast<double>(frame.component(s, i)[p]));
  weigh_spectrum(frame, exposure, info);

  std::array<double, 4> shown = info.stokes_y;
  if (view.wavelength && *view.wavelength < frame.lambda_nm.size())
    for (std::size_t s = 0; s < 4; ++s) shown[s] = info.stokes[s][*view.wavelength];
  info.ellipse = ellipse_of(shown);
  info.ellipse.x = x + 0.5;
  info.ellipse.y = y + 0.5;
  info.samples = static_cast<int>(frame.samples[p]);
  info.cut_off = frame.cut_off.empty() ? 0 : static_cast<double>(frame.cut_off[p]);
  info.cut_off_radiance = info.cut_off * picture.brightest_radiance;
  return info;
}

}  // namespace nicol::preview
