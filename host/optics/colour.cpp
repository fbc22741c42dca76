// CIE 1931 2 deg observer and linear sRGB.
#include "host/optics/colour.hpp"

#include <algorithm>
#include <cmath>

namespace nicol {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr int first_nm = 360, last_nm = 830;

constexpr double cie_1931[last_nm - first_nm + 1][3] = {
#include "host/optics/cie_1931.inc"
};

Triple times(const Matrix& m, const Triple& v) {
  Triple product{};
  for (int row = 0; row < 3; ++row)
    product[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return product;
}

Matrix inverse(const Matrix& m) {
  const auto minor = [&m](int r, int c) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) result[c][r] = minor(r, c) / det;
  return result;
}

Triple xyz_of_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// XYZ of linear sRGB: columns are the primaries, scaled so that (1, 1, 1) is the white (SMPTE RP
// 177-1993, with the chromaticities of IEC 61966-2-1:1999, table 1).
Matrix make_xyz_matrix() {
  const Triple red = xyz_of_chromaticity(0.64, 0.33), green = xyz_of_chromaticity(0.30, 0.60),
               blue = xyz_of_chromaticity(0.15, 0.06), white = xyz_of_chromaticity(0.3127, 0.3290);
  Matrix m{};
  for (int row = 0; row < 3; ++row) m[row] = {red[row], green[row], blue[row]};
  const Triple luminance = times(inverse(m), white);
  for (auto& row : m)
    for (int column = 0; column < 3; ++column) row[column] *= luminance[column];
  return m;
}

const Matrix& xyz_matrix() {
  static const Matrix matrix = make_xyz_matrix();
  return matrix;
}

const Matrix& srgb_matrix() {
  static const Matrix matrix = inverse(xyz_matrix());
  return matrix;
}

template <class Real>
Triple weighted_sum(const std::vector<Triple>& weights, const Real* radiance, std::size_t stride) {
  Triple sum{};
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (int k = 0; k < 3; ++k) sum[k] += weights[i][k] * static_cast<double>(radiance[i * stride]);
  return sum;
}

}  // namespace

std::vector<double> wavelength_weights(const std::vector<double>& lambda_nm) {
  const std::size_t count = lambda_nm.size();
  if (count < 2) return std::vector<double>(count, 1);
  std::vector<double> weight_nm(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double below = lambda_nm[i == 0 ? 0 : i - 1],
                 above = lambda_nm[std::min(i + 1, count - 1)];
    weight_nm[i] = (above - below) / 2;
  }
  return weight_nm;
}

Triple colour_matching(double lambda_nm) {
  if (!(lambda_nm >= first_nm && lambda_nm <= last_nm)) return {};
  const int row = std::min(static_cast<int>(lambda_nm) - first_nm, last_nm - first_nm - 1);
  const double t = lambda_nm - (first_nm + row);
  Triple value{};
  for (int k = 0; k < 3; ++k) value[k] = cie_1931[row][k] * (1 - t) + cie_1931[row + 1][k] * t;
  return value;
}

Observer::Observer(const std::vector<double>& lambda_nm, const std::vector<double>& weight_nm) {
  for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
    Triple weight = colour_matching(lambda_nm[i]);
    for (double& component : weight) component *= weight_nm[i];
    weights_.push_back(weight);
  }
}

Triple Observer::xyz(const double* radiance) const { return weighted_sum(weights_, radiance, 1); }

Triple Observer::xyz(const float* radiance, std::size_t stride) const {
  return weighted_sum(weights_, radiance, stride);
}

Triple linear_srgb(const Triple& xyz) { return times(srgb_matrix(), xyz); }

Triple xyz_of_linear_srgb(const Triple& rgb) { return times(xyz_matrix(), rgb); }

// IEC 61966-2-1:1999, equations 8 and 9
double srgb_encode(double linear) {
  const double v = std::min(std::max(linear, 0.0), 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

}  // namespace nicol
