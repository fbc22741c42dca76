// What is shown of a picture: see view.hpp. Tests: tests/preview/view_test.cpp.
// Where nothing is traced, and where S0 is 0 for what is relative to it, stands a neutral dark grey.
#include "host/preview/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/optics/colour.hpp"
#include "host/preview/view_colours.hpp"

namespace nicol::preview {
namespace {

constexpr float dimmed = 0.4f;  // colours under ellipses

const std::vector<std::pair<Quantity, const char*>>& names() {
  static const std::vector<std::pair<Quantity, const char*>> all{
      {Quantity::colour, "colour"},           {Quantity::degree, "degree"},     {Quantity::angle, "angle"},
      {Quantity::ellipticity, "ellipticity"}, {Quantity::ellipses, "ellipses"}, {Quantity::s1, "s1"},
      {Quantity::s2, "s2"},                   {Quantity::s3, "s3"}};
  return all;
}

bool is_false_colour(Quantity quantity) {
  return quantity != Quantity::colour && quantity != Quantity::ellipses;
}

// The pixels that those of a row show, as shown_pixel() has them: larger blocks first, smaller ones over them.
void find_shown(const Picture& picture, int y, std::vector<std::int64_t>& from) {
  const Frame& frame = picture.frame;
  const int largest = picture.step > 0 ? std::min(picture.step, largest_block) : largest_block;
  std::fill(from.begin(), from.end(), -1);
  for (int block = largest; block >= 1; block /= 2) {
    const std::int64_t row = std::int64_t{y - y % block} * frame.width;
    for (int x = 0; x < frame.width; x += block)
      if (frame.samples[static_cast<std::size_t>(row + x)] > 0)
        std::fill(from.begin() + x, from.begin() + std::min(x + block, frame.width), row + x);
  }
}

// Calls write(pixel, s) for every pixel with the Stokes vector that it shows, or with null.
template <typename Write>
void for_stokes(const Picture& picture, const View& view, Write write) {
  const Frame& frame = picture.frame;
  if (!view.wavelength) {
    for (std::size_t p = 0; p < frame.plane(); ++p) write(p, picture.stokes_y.data() + 4 * p);
    return;
  }
  std::array<const float*, 4> plane{};
  for (int s = 0; s < 4; ++s) plane[static_cast<std::size_t>(s)] = frame.component(s, *view.wavelength);
  std::vector<std::int64_t> from(static_cast<std::size_t>(frame.width));
  for (int y = 0; y < frame.height; ++y) {
    find_shown(picture, y, from);
    const std::size_t row = static_cast<std::size_t>(y) * from.size();
    for (std::size_t x = 0; x < from.size(); ++x) {
      std::array<float, 4> s{};
      if (from[x] >= 0)
        for (std::size_t k = 0; k < 4; ++k) s[k] = plane[k][from[x]];
      write(row + x, from[x] < 0 ? nullptr : s.data());
    }
  }
}

void develop_colours(const Picture& picture, const View& view, std::vector<float>& rgb) {
  const float factor = view.quantity == Quantity::ellipses ? dimmed : 1;
  if (!view.wavelength) {
    std::transform(picture.rgb.begin(), picture.rgb.end(), rgb.begin(), [=](float c) { return c * factor; });
    return;
  }
  const float grey = factor * static_cast<float>(grey_per_radiance(picture.frame));
  for_stokes(picture, view, [&](std::size_t p, const float* s) {
    const float value = s ? s[0] * grey : nothing_there()[0];
    rgb[3 * p] = rgb[3 * p + 1] = rgb[3 * p + 2] = value;
  });
}

// colour_of(s) for every pixel with light.
template <typename ColourOf>
void develop_false_colours(const Picture& picture, const View& view, std::vector<float>& rgb, ColourOf colour_of) {
  for_stokes(picture, view, [&](std::size_t p, const float* s) {
    const Rgb colour = s && s[0] > 0 ? colour_of(s) : nothing_there();
    std::copy(colour.begin(), colour.end(), rgb.begin() + static_cast<std::ptrdiff_t>(3 * p));
  });
}

float norm(const float* s) { return std::sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]); }

}  // namespace

double grey_per_radiance(const Frame& frame) {
  double sum = 0;
  for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i)
    sum += colour_matching(frame.lambda_nm[i])[1] * frame.weight_nm[i];
  return sum;
}

const std::vector<Quantity>& all_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> list;
    for (const auto& named : names()) list.push_back(named.first);
    return list;
  }();
  return all;
}

const char* name_of(Quantity quantity) {
  for (const auto& named : names())
    if (named.first == quantity) return named.second;
  return "";
}

std::optional<Quantity> quantity_named(const std::string& name) {
  for (const auto& named : names())
    if (named.second == name) return named.first;
  return std::nullopt;
}

Developed develop(const Picture& picture, const View& asked) {
  View view = asked;
  if (view.wavelength && *view.wavelength >= picture.frame.lambda_nm.size()) view.wavelength.reset();
  Developed developed;
  developed.width = picture.frame.width;
  developed.height = picture.frame.height;
  developed.exposed = !is_false_colour(view.quantity);
  developed.rgb.resize(3 * picture.frame.plane());
  std::vector<float>& rgb = developed.rgb;
  const auto component = [&](int i) {
    develop_false_colours(picture, view, rgb, [i](const float* s) { return diverging_colour(s[i] / s[0]); });
  };
  switch (view.quantity) {
    case Quantity::colour:
    case Quantity::ellipses: develop_colours(picture, view, rgb); break;
    case Quantity::degree:
      develop_false_colours(picture, view, rgb, [](const float* s) { return sequential_colour(norm(s) / s[0]); });
      break;
    case Quantity::angle:
      develop_false_colours(picture, view, rgb, [](const float* s) { return angle_colour(s[1] / s[0], s[2] / s[0]); });
      break;
    case Quantity::ellipticity:
      develop_false_colours(picture, view, rgb, [](const float* s) {
        const float polarized = norm(s);
        return polarized > 0 ? ellipticity_colour(s[3] / polarized) : nothing_there();
      });
      break;
    case Quantity::s1: component(1); break;
    case Quantity::s2: component(2); break;
    case Quantity::s3: component(3); break;
  }
  return developed;
}

Scale scale_of(const View& view) {
  constexpr int colours = 91;
  Scale scale;
  if (!is_false_colour(view.quantity)) return scale;
  const bool degrees = view.quantity == Quantity::angle || view.quantity == Quantity::ellipticity;
  scale.unit = degrees ? "deg" : "";
  scale.low = view.quantity == Quantity::ellipticity ? -45 : degrees || view.quantity == Quantity::degree ? 0 : -1;
  scale.high = view.quantity == Quantity::ellipticity ? 45 : degrees ? 180 : 1;
  constexpr float rad_per_deg = 3.14159265f / 180;
  for (int i = 0; i < colours; ++i) {
    const auto value = static_cast<float>(scale.low + (scale.high - scale.low) * i / (colours - 1));
    const float twice_rad = 2 * value * rad_per_deg;
    switch (view.quantity) {
      case Quantity::degree: scale.rgb.push_back(sequential_colour(value)); break;
      case Quantity::angle:
        scale.rgb.push_back(angle_colour(std::cos(twice_rad), std::sin(twice_rad)));
        break;
      case Quantity::ellipticity: scale.rgb.push_back(ellipticity_colour(std::sin(twice_rad))); break;
      default: scale.rgb.push_back(diverging_colour(value));
    }
  }
  return scale;
}

std::size_t nearest_wavelength(const std::vector<double>& lambda_nm, double wanted_nm) {
  const auto nearer = [=](double a, double b) { return std::fabs(a - wanted_nm) < std::fabs(b - wanted_nm); };
  return static_cast<std::size_t>(std::min_element(lambda_nm.begin(), lambda_nm.end(), nearer) - lambda_nm.begin());
}

}  // namespace nicol::preview
