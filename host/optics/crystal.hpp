// Optical activity and the optic axes of crystals, as functions of their principal values.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace nicol {

// g11, g22, g33, g23, g13, g12 on the principal axes: D = eps E + i g(s) s x E, g(s) = g_ij s_i s_j.
using GyrationTensor = std::array<double, 6>;

struct GyrationFormula {
  enum class Kind {
    none,
    constant,  // `tensor` at all wavelengths
    scaled,    // `tensor` at at_nm, elsewhere times at_nm/lambda
    table      // points
  };
  Kind kind = Kind::none;
  GyrationTensor tensor{};
  double at_nm = 0;
  std::array<std::vector<std::pair<double, double>>, 6> points;  // nm, component; ascending
  double scale = 1;
};

// NaN where the formula has no value.
GyrationTensor gyration(const GyrationFormula& formula, double lambda_nm);
std::string check(const GyrationFormula& formula);  // "" or what is wrong

// g(s) along the unit vector s, on the axes of the tensor.
double gyration_along(const GyrationTensor& tensor, const std::array<double, 3>& s);

// Light of mean index n along a direction of gyration g where it is not split: rotation of the plane of
// polarization in deg/mm, > 0 dextro, and back.
double rotation_of_gyration(double g, double n, double lambda_nm);
double gyration_of_rotation(double rotation_deg_per_mm, double n, double lambda_nm);

// Angle V in degrees of the two optic axes from the axis of the largest of three principal indices, in
// the plane of the smallest and the largest. > 45: optically negative. 0 for equal smaller ones.
double optic_axis_from_gamma_deg(double n_alpha, double n_beta, double n_gamma);

}  // namespace nicol
