// CIE L*a*b* and the colour difference CIEDE2000.
//   a' = a (1 + G),  G = (1 - sqrt(C^7/(C^7 + 25^7)))/2 with C the mean chroma of both
//   DE = sqrt(l^2 + c^2 + h^2 + R_T c h),  l = DL'/S_L, c = DC'/S_C, h = DH'/S_H
// Source: Sharma, Wu & Dalal 2005, Color Res. Appl. 30, 21, equations 2 to 22.
// Range: differences up to about 5 were judged by eyes; beyond, a number that grows.
// Test: tests/accuracy/colour_difference_test.cpp (the 34 pairs of that paper's table 1).
#include "host/accuracy/colour_difference.hpp"

#include <cmath>

#include "host/optics/colour.hpp"

namespace nicol {
namespace {

constexpr double pi = 3.14159265358979323846;

double radians(double degrees) { return degrees * pi / 180; }
double cos_deg(double degrees) { return std::cos(radians(degrees)); }
double squared(double x) { return x * x; }

// sqrt(C^7/(C^7 + 25^7))
double chroma_share(double chroma) {
  const double ratio = std::pow(chroma / 25, 7);
  return std::sqrt(ratio / (ratio + 1));
}

struct Polar {
  double lightness, chroma, hue_deg;  // hue 0..360, 0 for greys
};

Polar polar(const Lab& lab, double stretch) {
  const double a = lab[1] * stretch, b = lab[2];
  const double hue_deg = a == 0 && b == 0 ? 0 : std::atan2(b, a) * 180 / pi;
  return {lab[0], std::hypot(a, b), hue_deg < 0 ? hue_deg + 360 : hue_deg};
}

// The shorter way around from one hue to the other, eq. 10.
double hue_difference_deg(const Polar& p, const Polar& q) {
  if (p.chroma * q.chroma == 0) return 0;
  const double d = q.hue_deg - p.hue_deg;
  if (std::fabs(d) <= 180) return d;
  return d > 180 ? d - 360 : d + 360;
}

// Eq. 14.
double mean_hue_deg(const Polar& p, const Polar& q) {
  const double sum = p.hue_deg + q.hue_deg;
  if (p.chroma * q.chroma == 0) return sum;
  if (std::fabs(p.hue_deg - q.hue_deg) <= 180) return sum / 2;
  return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

}  // namespace

Lab lab_of_xyz(const std::array<double, 3>& xyz) {
  static const std::array<double, 3> white = xyz_of_linear_srgb({1, 1, 1});
  constexpr double knee = 24.0 / 116;
  std::array<double, 3> f{};
  for (int k = 0; k < 3; ++k) {
    const double t = xyz[k] / white[k];
    f[k] = t > knee * knee * knee ? std::cbrt(t) : 841.0 / 108 * t + 16.0 / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double ciede2000(const Lab& first, const Lab& second) {
  // Both colours with the chroma of near-greys stretched, eqs 2 to 7.
  const double chroma = (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2])) / 2;
  const double stretch = 1 + (1 - chroma_share(chroma)) / 2;
  const Polar p = polar(first, stretch), q = polar(second, stretch);

  // Differences of lightness, chroma and hue, eqs 8 to 11.
  const double d_lightness = q.lightness - p.lightness, d_chroma = q.chroma - p.chroma;
  const double d_hue =
      2 * std::sqrt(p.chroma * q.chroma) * std::sin(radians(hue_difference_deg(p, q)) / 2);

  // Their weights at the mean colour, eqs 12 to 21.
  const double l50 = squared((p.lightness + q.lightness) / 2 - 50);
  const double mean_chroma = (p.chroma + q.chroma) / 2, hue = mean_hue_deg(p, q);
  const double t = 1 - 0.17 * cos_deg(hue - 30) + 0.24 * cos_deg(2 * hue) +
                   0.32 * cos_deg(3 * hue + 6) - 0.20 * cos_deg(4 * hue - 63);
  const double turn_deg = 30 * std::exp(-squared((hue - 275) / 25));
  const double l = d_lightness / (1 + 0.015 * l50 / std::sqrt(20 + l50));
  const double c = d_chroma / (1 + 0.045 * mean_chroma);
  const double h = d_hue / (1 + 0.015 * mean_chroma * t);
  const double r_t = -std::sin(radians(2 * turn_deg)) * 2 * chroma_share(mean_chroma);
  return std::sqrt(l * l + c * c + h * h + r_t * c * h);
}

}  // namespace nicol
