// Light and colour: illuminants, CIE 1931 2 deg observer, linear sRGB.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace nicol {

// A spectral radiance by name or numbers. Scaled so that Y = 1 at scale 1 (a colour of POV-Ray: so that
// the linear sRGB of the rendered light is the colour, with D65 as these wavelengths render it for white: within
// 5e-4 of (1, 1, 1) at steps of 5 nm, but (1.014, 0.995, 1.009) at steps of 20 nm).
struct SpectrumFormula {
  enum class Kind {
    d65, a, e,       // CIE illuminants D65 and A (CIE 15:2018), equal energy
    blackbody,       // {T in K}
    line,            // {lambda_nm}: all in the nearest wavelength of the scene
    table,           // points: nm, relative radiance
    rgb              // {r, g, b}: a smooth spectrum of that linear sRGB colour, D65-like for greys
  };
  Kind kind = Kind::d65;
  std::vector<double> numbers;
  std::vector<std::pair<double, double>> points;
  double scale = 1;
};

// Radiance per nm at the scene's wavelengths; weight_nm is the width each stands for. The sum over
// radiance * ybar * weight is `scale`. Answers the reason in `error` if it cannot be (a line outside
// the range, no power at these wavelengths).
std::vector<double> sample_spectrum(const SpectrumFormula& formula, const std::vector<double>& lambda_nm,
                                    const std::vector<double>& weight_nm, std::string& error);

// Widths for ascending wavelengths: trapezoid rule; a lone wavelength has width 1.
std::vector<double> wavelength_weights(const std::vector<double>& lambda_nm);

// CIE 1931 2 deg colour matching functions, 1 nm table 360..830, linear between (CIE 15:2018, table 1 nm).
std::array<double, 3> colour_matching(double lambda_nm);

// XYZ of a spectrum sampled at lambda_nm.
class Observer {
 public:
  Observer(const std::vector<double>& lambda_nm, const std::vector<double>& weight_nm);
  std::array<double, 3> xyz(const double* radiance) const;       // lambda_nm.size() values
  std::array<double, 3> xyz(const float* radiance, std::size_t stride = 1) const;

 private:
  std::vector<std::array<double, 3>> weights_;
};

std::array<double, 3> linear_srgb(const std::array<double, 3>& xyz);    // IEC 61966-2-1, D65 white
std::array<double, 3> xyz_of_linear_srgb(const std::array<double, 3>& rgb);
double srgb_encode(double linear);                                     // clamps to [0, 1]

}  // namespace nicol
