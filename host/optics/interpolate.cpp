// Interpolation in tables of (wavelength in nm, value).
#include "host/optics/interpolate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nicol {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// Index i of the interval [i, i + 1] that holds lambda_nm; the table covers it.
std::size_t interval_of(const Points& points, double lambda_nm) {
  const auto above = std::upper_bound(points.begin(), points.end(), lambda_nm,
                                      [](double x, const auto& point) { return x < point.first; });
  const auto i = static_cast<std::size_t>(above - points.begin());
  return std::min(std::max<std::size_t>(i, 1), points.size() - 1) - 1;
}

std::vector<double> secants(const Points& points) {
  std::vector<double> slope(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    slope[i] = (points[i + 1].second - points[i].second) / (points[i + 1].first - points[i].first);
  return slope;
}

// Slopes at the points: means of the neighbouring secants, 0 at an extremum, then drawn back into
// the circle of radius 3 in which the cubic is monotone (Fritsch & Carlson 1980, section 4, region
// S2).
std::vector<double> monotone_tangents(const std::vector<double>& secant) {
  const std::size_t last = secant.size();
  std::vector<double> tangent(last + 1);
  tangent[0] = secant[0];
  tangent[last] = secant[last - 1];
  for (std::size_t i = 1; i < last; ++i)
    tangent[i] = secant[i - 1] * secant[i] > 0 ? (secant[i - 1] + secant[i]) / 2 : 0;
  for (std::size_t i = 0; i < last; ++i) {
    if (secant[i] == 0) {
      tangent[i] = tangent[i + 1] = 0;
      continue;
    }
    const double radius = std::hypot(tangent[i] / secant[i], tangent[i + 1] / secant[i]);
    if (radius <= 3) continue;
    tangent[i] *= 3 / radius;
    tangent[i + 1] *= 3 / radius;
  }
  return tangent;
}

}  // namespace

double monotone_cubic(const Points& points, double lambda_nm) {
  if (points.size() < 2 || !(lambda_nm >= points.front().first && lambda_nm <= points.back().first))
    return nan_value;
  const auto tangent = monotone_tangents(secants(points));
  const std::size_t i = interval_of(points, lambda_nm);
  const double width = points[i + 1].first - points[i].first;
  const double t = (lambda_nm - points[i].first) / width;
  const double u = 1 - t;
  return points[i].second * (1 + 2 * t) * u * u + points[i + 1].second * (3 - 2 * t) * t * t +
         width * t * u * (tangent[i] * u - tangent[i + 1] * t);
}

double piecewise_linear(const Points& points, double lambda_nm, double outside) {
  if (points.size() < 2 || !(lambda_nm >= points.front().first && lambda_nm <= points.back().first))
    return outside;
  const std::size_t i = interval_of(points, lambda_nm);
  const double t = (lambda_nm - points[i].first) / (points[i + 1].first - points[i].first);
  return points[i].second * (1 - t) + points[i + 1].second * t;
}

std::string check_points(const Points& points, double least) {
  if (points.size() < 2)
    return "a table takes 2 or more points, " + std::to_string(points.size()) + " given";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string which = "point " + std::to_string(i + 1) + " of the table ";
    const auto& [lambda_nm, value] = points[i];
    if (!std::isfinite(lambda_nm) || !std::isfinite(value)) return which + "is not finite";
    if (lambda_nm <= 0) return which + "has no positive wavelength";
    if (value < least) return which + (least == 0 ? "is negative" : "is too small");
    if (i > 0 && lambda_nm <= points[i - 1].first)
      return which + "is not at a longer wavelength than the one before";
  }
  return "";
}

}  // namespace nicol
