// Spectra of light sources sampled at the wavelengths of a scene.
#include <algorithm>
#include <cmath>
#include <optional>

#include "host/optics/colour.hpp"
#include "host/optics/interpolate.hpp"

namespace nicol {
namespace {

using Samples = std::vector<double>;
using Triple = std::array<double, 3>;

constexpr int d65_first_nm = 300, d65_last_nm = 830, d65_step_nm = 5;

constexpr double cie_d65[] = {
#include "host/optics/cie_d65.inc"
};
static_assert(std::size(cie_d65) == (d65_last_nm - d65_first_nm) / d65_step_nm + 1);

struct Grid {
  const Samples& lambda_nm;
  const Samples& weight_nm;
};

double d65(double lambda_nm) {
  if (!(lambda_nm >= d65_first_nm && lambda_nm <= d65_last_nm)) return 0;
  const double place = (lambda_nm - d65_first_nm) / d65_step_nm;
  const auto row = std::min(static_cast<std::size_t>(place), std::size(cie_d65) - 2);
  const double t = place - static_cast<double>(row);
  return cie_d65[row] * (1 - t) + cie_d65[row + 1] * t;
}

// CIE 015:2018, equation 4.1: Planck at T = 2848 K with c2 = 1.435e7 nm K, 100 at 560 nm
double illuminant_a(double lambda_nm) {
  const auto bose = [](double l) { return std::expm1(1.435e7 / (2848 * l)); };
  return 100 * std::pow(560 / lambda_nm, 5) * bose(560) / bose(lambda_nm);
}

// Planck's law over its value at 560 nm; c2 = h c / k_B (CODATA 2018)
double planck(double lambda_nm, double temperature_k) {
  const double c2_nm_k = 1.438776877e7;
  const double x = c2_nm_k / (lambda_nm * temperature_k), x_560 = c2_nm_k / (560 * temperature_k);
  const double bose_ratio = std::exp(x_560 - x) * std::expm1(-x_560) / std::expm1(-x);
  return std::pow(560 / lambda_nm, 5) * bose_ratio;
}

template <class Radiance>
Samples sampled(const Grid& grid, Radiance radiance) {
  Samples values;
  for (const double lambda_nm : grid.lambda_nm) values.push_back(radiance(lambda_nm));
  return values;
}

double luminance(const Grid& grid, const Samples& radiance) {
  double sum = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i)
    sum += radiance[i] * colour_matching(grid.lambda_nm[i])[1] * grid.weight_nm[i];
  return sum;
}

// Scales to luminance `wanted`; false if the eye sees nothing of it at these wavelengths.
bool scale_to(const Grid& grid, double wanted, Samples& radiance) {
  const double y = luminance(grid, radiance);
  if (!(y > 0) || !std::isfinite(y)) return false;
  for (double& value : radiance) value *= wanted / y;
  return true;
}

std::string sample_line(const Grid& grid, double line_nm, Samples& radiance) {
  const auto& lambda_nm = grid.lambda_nm;
  const auto distance = [line_nm](double l) { return std::abs(l - line_nm); };
  const auto nearest =
      std::min_element(lambda_nm.begin(), lambda_nm.end(),
                       [&](double a, double b) { return distance(a) < distance(b); });
  const auto i = static_cast<std::size_t>(nearest - lambda_nm.begin());
  const double reach_nm =
      lambda_nm.size() == 1 ? 0.5 : grid.weight_nm[i];  // half a step beyond the ends
  if ((i == 0 || i + 1 == lambda_nm.size()) && distance(*nearest) > reach_nm)
    return "the line lies outside the wavelengths of the scene";
  radiance.assign(lambda_nm.size(), 0);
  radiance[i] = 1;
  return "";
}

// ---- a spectrum for a colour ----
// D65 times a mix of three smooth bands that add up to 1. The crossings, at 488 and 591 nm, and
// their widths were chosen so that every colour of sRGB has positive amounts of the three, at steps
// of 20 nm too.
double smooth_step(double lambda_nm, double centre_nm, double half_width_nm) {
  const double t =
      std::clamp((lambda_nm - centre_nm + half_width_nm) / (2 * half_width_nm), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Triple bands(double lambda_nm) {
  const double above_blue = smooth_step(lambda_nm, 488, 25),
               above_green = smooth_step(lambda_nm, 591, 22);
  return {above_green, above_blue - above_green, 1 - above_blue};
}

// Cramer's rule; nothing where the columns hardly span the space.
std::optional<Triple> solve(const std::array<Triple, 3>& columns, const Triple& right) {
  const auto det = [](const Triple& a, const Triple& b, const Triple& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const auto length = [](const Triple& v) { return std::hypot(v[0], v[1], v[2]); };
  const double volume = det(columns[0], columns[1], columns[2]);
  const double bound = length(columns[0]) * length(columns[1]) * length(columns[2]);
  if (!(std::abs(volume) > 1e-3 * bound)) return std::nullopt;
  return Triple{det(right, columns[1], columns[2]) / volume,
                det(columns[0], right, columns[2]) / volume,
                det(columns[0], columns[1], right) / volume};
}

// Amounts of the three bands whose light has the linear sRGB `rgb` on this grid. White is D65 as
// the grid renders it (at steps of 20 nm that is (1.014, 0.995, 1.009), not (1, 1, 1)), channel by
// channel, so that greys are exactly D65. Nothing if the grid is too coarse to tell three colours
// apart.
std::optional<Triple> band_amounts(const Grid& grid, const Samples& white_radiance,
                                   const Triple& rgb) {
  const Observer observer(grid.lambda_nm, grid.weight_nm);
  std::array<Triple, 3> band_rgb{};
  for (int band = 0; band < 3; ++band) {
    Samples radiance = white_radiance;
    for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] *= bands(grid.lambda_nm[i])[band];
    band_rgb[band] = linear_srgb(observer.xyz(radiance.data()));
  }
  Triple wanted{};
  for (int k = 0; k < 3; ++k)
    wanted[k] = rgb[k] * (band_rgb[0][k] + band_rgb[1][k] + band_rgb[2][k]);
  return solve(band_rgb, wanted);
}

// Radiance of a colour: luminance kept where bands with negative amounts had to be left out, and
// D65 of the colour's luminance where the wavelengths are too few for colours.
bool sample_rgb(const Grid& grid, const Triple& rgb, double scale, Samples& radiance) {
  const double y = xyz_of_linear_srgb(rgb)[1] * scale;
  radiance = sampled(grid, d65);
  if (!scale_to(grid, 1, radiance)) return false;
  const bool grey = rgb[0] == rgb[1] && rgb[1] == rgb[2];
  const auto amounts =
      grid.lambda_nm.size() < 3 || grey ? std::nullopt : band_amounts(grid, radiance, rgb);
  if (!amounts) return scale_to(grid, y, radiance);
  bool clamped = false;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const Triple band = bands(grid.lambda_nm[i]);
    double mix = 0;
    for (int k = 0; k < 3; ++k) {
      clamped = clamped || (*amounts)[k] < 0;
      mix += std::max((*amounts)[k], 0.0) * band[k];
    }
    radiance[i] *= mix * scale;
  }
  return !clamped || scale_to(grid, y, radiance);
}

std::string check_grid(const Grid& grid) {
  if (grid.lambda_nm.empty()) return "the scene has no wavelengths";
  if (grid.lambda_nm.size() != grid.weight_nm.size())
    return "wavelengths and their weights differ in number";
  return "";
}

std::string check_formula(const SpectrumFormula& formula) {
  using Kind = SpectrumFormula::Kind;
  const auto takes = [&](const char* name, std::size_t count) {
    return formula.numbers.size() == count ? std::string()
                                           : std::string(name) + " takes " + std::to_string(count) +
                                                 (count == 1 ? " number, " : " numbers, ") +
                                                 std::to_string(formula.numbers.size()) + " given";
  };
  for (const double number : formula.numbers)
    if (!std::isfinite(number)) return "a number of the spectrum is not finite";
  if (!(formula.scale >= 0) || !std::isfinite(formula.scale))
    return "a light's strength must be 0 or more";
  switch (formula.kind) {
    case Kind::blackbody: {
      const std::string problem = takes("a black body", 1);
      return problem.empty() && formula.numbers[0] <= 0 ? "a temperature must be positive"
                                                        : problem;
    }
    case Kind::line: return takes("a spectral line", 1);
    case Kind::rgb: {
      const std::string problem = takes("a colour", 3);
      if (!problem.empty()) return problem;
      for (const double number : formula.numbers)
        if (number < 0) return "a colour of light must not be negative";
      return "";
    }
    case Kind::table: return check_points(formula.points, 0);
    default: return "";
  }
}

}  // namespace

Samples sample_spectrum(const SpectrumFormula& formula, const Samples& lambda_nm,
                        const Samples& weight_nm, std::string& error) {
  using Kind = SpectrumFormula::Kind;
  const Grid grid{lambda_nm, weight_nm};
  error = check_grid(grid);
  if (error.empty()) error = check_formula(formula);
  if (!error.empty()) return {};
  Samples radiance;
  bool visible = false;
  switch (formula.kind) {
    case Kind::d65: radiance = sampled(grid, d65); break;
    case Kind::a: radiance = sampled(grid, illuminant_a); break;
    case Kind::e: radiance = sampled(grid, [](double) { return 1.0; }); break;
    case Kind::blackbody:
      radiance = sampled(grid, [&](double l) { return planck(l, formula.numbers[0]); });
      break;
    case Kind::table:
      radiance = sampled(grid, [&](double l) { return piecewise_linear(formula.points, l, 0); });
      break;
    case Kind::line: error = sample_line(grid, formula.numbers[0], radiance); break;
    case Kind::rgb:
      visible = sample_rgb(grid, {formula.numbers[0], formula.numbers[1], formula.numbers[2]},
                           formula.scale, radiance);
      break;
  }
  if (!error.empty()) return {};
  if (formula.kind != Kind::rgb) visible = scale_to(grid, formula.scale, radiance);
  if (visible) return radiance;
  error = "the light has no visible power at the wavelengths of the scene";
  return {};
}

}  // namespace nicol
