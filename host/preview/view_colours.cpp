// See view_colours.hpp.
#include "host/preview/view_colours.hpp"

#include <algorithm>
#include <cmath>

namespace nicol::preview {
namespace {

struct Oklab {
  float lightness = 0, a = 0, b = 0;
};

constexpr Oklab dark_blue{0.30f, -0.010f, -0.110f}, yellow{0.92f, -0.025f, 0.140f};
constexpr Oklab blue{0.50f, -0.025f, -0.150f}, light_grey{0.88f, 0, 0}, red{0.50f, 0.165f, 0.080f};
constexpr float angle_lightness = 0.74f, angle_chroma = 0.115f;

// Ottosson (2020): Oklab to linear sRGB.
Rgb linear_srgb_of(Oklab c) {
  const float l = c.lightness + 0.3963377774f * c.a + 0.2158037573f * c.b;
  const float m = c.lightness - 0.1055613458f * c.a - 0.0638541728f * c.b;
  const float s = c.lightness - 0.0894841775f * c.a - 1.2914855480f * c.b;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
          -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
          -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
}

Oklab between(Oklab from, Oklab to, float part) {
  return {from.lightness + (to.lightness - from.lightness) * part, from.a + (to.a - from.a) * part,
          from.b + (to.b - from.b) * part};
}

}  // namespace

Rgb sequential_colour(float value) {
  return linear_srgb_of(between(dark_blue, yellow, std::clamp(value, 0.0f, 1.0f)));
}

Rgb diverging_colour(float value) {
  return linear_srgb_of(between(light_grey, value < 0 ? blue : red, std::min(std::fabs(value), 1.0f)));
}

Rgb angle_colour(float s1, float s2) {
  const float squared = s1 * s1 + s2 * s2;
  const float chroma = squared > 1 ? angle_chroma / std::sqrt(squared) : angle_chroma;
  return linear_srgb_of({angle_lightness, chroma * s1, chroma * s2});
}

Rgb ellipticity_colour(float sine) {
  constexpr float half_pi = 1.57079633f;
  return diverging_colour(std::asin(std::clamp(sine, -1.0f, 1.0f)) / half_pi);
}

Rgb nothing_there() { return {0.02f, 0.02f, 0.02f}; }

}  // namespace nicol::preview
