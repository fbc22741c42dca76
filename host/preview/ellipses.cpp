// Polarization ellipses on a grid: see view.hpp. Test: tests/preview/view_test.cpp.
//   azimuth = atan2(S2, S1)/2, ellipticity = asin(S3/P)/2, degree = P/S0, P = |(S1, S2, S3)|
// Source: M. Born and E. Wolf, Principles of Optics, 7th ed., 1.4.2, eqs 45 to 48, in the signs of kernels/README.md.
#include <algorithm>
#include <cmath>

#include "host/preview/ellipse.hpp"

namespace nicol::preview {
namespace {

constexpr double dark = 1e-4;           // of the brightest: no ellipse is drawn below
constexpr double unpolarized = 1e-3;    // degree: no ellipse would be seen below

}  // namespace

std::optional<std::array<double, 4>> shown_stokes(const Picture& picture, const View& view, int x, int y) {
  const Frame& frame = picture.frame;
  const bool one = view.wavelength && *view.wavelength < frame.lambda_nm.size();
  std::array<double, 4> s{};
  if (!one) {
    const std::size_t p = static_cast<std::size_t>(y) * frame.width + x;
    std::copy_n(picture.stokes_y.begin() + static_cast<std::ptrdiff_t>(4 * p), 4, s.begin());
    return s;
  }
  const std::int64_t from = shown_pixel(picture, x, y);
  if (from < 0) return std::nullopt;
  for (int i = 0; i < 4; ++i) s[static_cast<std::size_t>(i)] = frame.component(i, *view.wavelength)[from];
  return s;
}

Ellipse ellipse_of(const std::array<double, 4>& s) {
  const double polarized = std::hypot(s[1], s[2], s[3]);
  Ellipse e;
  if (!(s[0] > 0) || !(polarized > 0)) return e;
  e.azimuth_rad = std::atan2(s[2], s[1]) / 2;
  e.ellipticity_rad = std::asin(std::clamp(s[3] / polarized, -1.0, 1.0)) / 2;
  e.degree = polarized / s[0];
  return e;
}

std::vector<Ellipse> ellipses(const Picture& picture, const View& view, int spacing) {
  const Frame& frame = picture.frame;
  const int step = std::max(spacing, 1);
  const bool one = view.wavelength && *view.wavelength < frame.lambda_nm.size();

  // The brightest: of the whole picture, not of the grid.
  double brightest = 0;
  for (std::size_t p = 0; p < frame.plane(); ++p) {
    if (one && frame.samples[p] == 0) continue;
    brightest = std::max<double>(brightest, one ? frame.component(0, *view.wavelength)[p] : picture.stokes_y[4 * p]);
  }

  std::vector<Ellipse> all;
  for (int y = step / 2; y < frame.height; y += step)
    for (int x = step / 2; x < frame.width; x += step) {
      const auto stokes = shown_stokes(picture, view, x, y);
      if (!stokes || !((*stokes)[0] > dark * brightest)) continue;
      Ellipse e = ellipse_of(*stokes);
      if (!(e.degree > unpolarized)) continue;
      e.x = x + 0.5;
      e.y = y + 0.5;
      all.push_back(e);
    }
  return all;
}

}  // namespace nicol::preview
