// What is shown of a picture: its colours, or its polarization in false colour.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/preview/picture.hpp"

namespace nicol::preview {

enum class Quantity {
  colour,       // as the eye sees it; at one wavelength: its radiance in grey
  degree,       // of polarization, sqrt(S1^2 + S2^2 + S3^2)/S0: 0..1
  angle,        // azimuth of the ellipse, atan2(S2, S1)/2: 0..180 deg, hue; saturation: degree of linear polarization
  ellipticity,  // asin(S3/|S1 S2 S3|)/2: -45..45 deg
  ellipses,     // the colours, dimmed; ellipses are drawn over them
  s1, s2, s3    // over S0: -1..1
};

struct View {
  Quantity quantity = Quantity::colour;
  std::optional<std::size_t> wavelength;  // index; none: the whole spectrum, weighted by ybar
};

// All quantities in the order of a list to choose from, each by one word ("colour", "degree", ...).
const std::vector<Quantity>& all_quantities();
const char* name_of(Quantity quantity);
std::optional<Quantity> quantity_named(const std::string& name);

// A shown picture. `rgb` is linear sRGB, 3 floats a pixel, rows from the top; `exposed`: the exposure applies to it
// (colours), else not (false colours). Where nothing is traced yet, and where S0 is 0 for what is relative to S0: a
// neutral dark grey. Grey at one wavelength is as bright as equal-energy light of its radiance.
struct Developed {
  int width = 0, height = 0;
  std::vector<float> rgb;
  bool exposed = true;
};
Developed develop(const Picture& picture, const View& view);

// At one wavelength: grey as bright as an equal-energy light of that radiance at all of the picture's wavelengths would be.
double grey_per_radiance(const Frame& frame);

// Index of the wavelength nearest to one; there is at least one.
std::size_t nearest_wavelength(const std::vector<double>& lambda_nm, double wanted_nm);

// The scale beside it: colours at equal steps from `low` to `high`, and their unit. Empty: no false colours.
struct Scale {
  std::vector<std::array<float, 3>> rgb;  // linear
  double low = 0, high = 0;
  std::string unit;                       // "deg", ""
};
Scale scale_of(const View& view);

// The polarization ellipse at a place, as the receiver sees it. Unit: semi-major axis 1 for full polarization.
struct Ellipse {
  double x = 0, y = 0;               // pixels from the left, from the top
  double azimuth_rad = 0;            // of the major axis, counter-clockwise from the right of the picture
  double ellipticity_rad = 0;        // > 0: right-handed
  double degree = 0;                 // of polarization
};

// On a grid of `spacing` pixels, where there is light (more than 1e-4 of the brightest Y of the picture) that is
// polarized by more than 1e-3.
std::vector<Ellipse> ellipses(const Picture& picture, const View& view, int spacing);

}  // namespace nicol::preview
