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
inline Rgb linear_srgb_of(float lightness, float a, float b) {
  const float l = lightness + 0.3963377774f * a + 0.2158037573f * b;
  const float m = lightness - 0.1055613458f * a - 0.0638541728f * b;
  const float s = lightness - 0.0894841775f * a - 1.2914855480f * b;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
          -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
          -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
}

Rgb between(Oklab from, Oklab to, float part) {
  return linear_srgb_of(from.lightness + (to.lightness - from.lightness) * part, from.a + (to.a - from.a) * part,
                        from.b + (to.b - from.b) * part);
}

// Finer than 8 bit, as a picture has many pixels.
constexpr int steps = 1024;
using Table = std::array<Rgb, 2 * steps + 1>;

// Of -1..1.
Rgb looked_up(const Table& table, float value) {
  const float place = (std::min(std::max(value, -1.0f), 1.0f) + 1) * steps + 0.5f;  // NaN: -1
  return table[static_cast<std::size_t>(place)];
}

}  // namespace

Rgb sequential_colour(float value) {
  static const Table table = [] {
    Table t;
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = between(dark_blue, yellow, static_cast<float>(i) / (2 * steps));
    return t;
  }();
  return looked_up(table, 2 * value - 1);
}

Rgb diverging_colour(float value) {
  static const Table table = [] {
    Table t;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const float at = static_cast<float>(i) / steps - 1;
      t[i] = between(light_grey, at < 0 ? blue : red, std::fabs(at));
    }
    return t;
  }();
  return looked_up(table, value);
}

Rgb angle_colour(float s1, float s2) {
  const float squared = s1 * s1 + s2 * s2;
  const float chroma = squared > 1 ? angle_chroma / std::sqrt(squared) : angle_chroma;
  return linear_srgb_of(angle_lightness, chroma * s1, chroma * s2);
}

// Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 4.4.45: asin within 6.8e-5, a twentieth of a step.
Rgb ellipticity_colour(float sine) {
  constexpr float half_pi = 1.57079633f;
  const float x = std::min(std::fabs(sine), 1.0f);
  const float acos = std::sqrt(1 - x) * (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
  return diverging_colour(std::copysign(1 - acos / half_pi, sine));
}

Rgb nothing_there() { return {0.02f, 0.02f, 0.02f}; }

}  // namespace nicol::preview
