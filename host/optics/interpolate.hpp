// Interpolation in tables of (wavelength in nm, value), ascending in wavelength.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace nicol {

using Points = std::vector<std::pair<double, double>>;

// Monotone cubic through the points (Fritsch & Carlson, SIAM J. Numer. Anal. 17, 238, 1980): no
// overshoot between neighbours. NaN outside the points.
double monotone_cubic(const Points& points, double lambda_nm);

// Straight lines between the points; `outside` before the first and after the last.
double piecewise_linear(const Points& points, double lambda_nm, double outside);

// "" for two or more finite points of ascending positive wavelength with values >= least, else what
// is wrong.
std::string check_points(const Points& points, double least);

}  // namespace nicol
