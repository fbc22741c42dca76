// Splines as POV-Ray interpolates them: linear, quadratic and cubic through neighbours, natural.
#include <algorithm>
#include <cmath>

#include "function.hpp"

namespace nicol::sdl {
namespace {

using Point = std::array<double, 5>;

template <typename Each>
Point each(Each f) {
  Point p{};
  for (std::size_t k = 0; k < 5; ++k) p[k] = f(k);
  return p;
}

// Lagrange's parabola through three knots.
Point parabola(const Knot& a, const Knot& b, const Knot& c, double t) {
  const double wa = (t - b.at) * (t - c.at) / ((a.at - b.at) * (a.at - c.at));
  const double wb = (t - a.at) * (t - c.at) / ((b.at - a.at) * (b.at - c.at));
  const double wc = (t - a.at) * (t - b.at) / ((c.at - a.at) * (c.at - b.at));
  return each([&](std::size_t k) { return wa * a.value[k] + wb * b.value[k] + wc * c.value[k]; });
}

// Hermite's cubic; the slope at a knot is the mean of the slopes of its two chords.
Point hermite(const Knot* k0, double t) {
  const Knot &a = k0[0], &b = k0[1], &c = k0[2], &d = k0[3];
  const double h = c.at - b.at, s = (t - b.at) / h;
  return each([&](std::size_t k) {
    const double chord = (c.value[k] - b.value[k]) / h;
    const double mb = 0.5 * (chord + (b.value[k] - a.value[k]) / (b.at - a.at));
    const double mc = 0.5 * (chord + (d.value[k] - c.value[k]) / (d.at - c.at));
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * b.value[k] + (s3 - 2 * s2 + s) * h * mb +
           (3 * s2 - 2 * s3) * c.value[k] + (s3 - s2) * h * mc;
  });
}

// A cubic by its second derivatives at both ends (`slope`).
Point natural(const Knot& a, const Knot& b, double t) {
  const double h = b.at - a.at, p = (b.at - t) / h, q = (t - a.at) / h;
  return each([&](std::size_t k) {
    return p * a.value[k] + q * b.value[k] +
           ((p * p * p - p) * a.slope[k] + (q * q * q - q) * b.slope[k]) * h * h / 6;
  });
}

Point straight(const Knot& a, const Knot& b, double t) {
  const double q = (t - a.at) / (b.at - a.at);
  return each([&](std::size_t k) { return a.value[k] + q * (b.value[k] - a.value[k]); });
}

// The tridiagonal system of a natural spline, by Thomas's algorithm, for one component.
void solve_natural(std::vector<Knot>& knots, std::size_t k) {
  const std::size_t n = knots.size();
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = knots[i].at - knots[i - 1].at, right = knots[i + 1].at - knots[i].at;
    const double bend = (knots[i + 1].value[k] - knots[i].value[k]) / right -
                        (knots[i].value[k] - knots[i - 1].value[k]) / left;
    const double pivot = 2 * (left + right) - left * upper[i - 1];
    upper[i] = right / pivot;
    knots[i].slope[k] = (6 * bend - left * knots[i - 1].slope[k]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) knots[i].slope[k] -= upper[i] * knots[i + 1].slope[k];
}

}  // namespace

void prepare_spline(Function& spline) {
  auto& knots = spline.knots;
  const auto earlier = [](const Knot& a, const Knot& b) { return a.at < b.at; };
  std::stable_sort(knots.begin(), knots.end(), earlier);
  const auto same = [](const Knot& a, const Knot& b) { return a.at == b.at; };
  knots.erase(std::unique(knots.begin(), knots.end(), same), knots.end());
  if (spline.spline != Function::Spline::natural || knots.size() < 3) return;
  for (std::size_t k = 0; k < 5; ++k) solve_natural(knots, k);
}

Numbers spline_at(const Function& spline, double t) {
  const auto& knots = spline.knots;
  const std::size_t n = knots.size();
  Numbers result;
  result.size = spline.knot_size;
  const bool cubic = spline.spline == Function::Spline::cubic && n >= 4;
  const std::size_t first = cubic ? 1 : 0, last = cubic ? n - 2 : n - 1;
  if (!(t > knots[first].at)) {
    result.v = knots[first].value;
    return result;
  }
  if (t >= knots[last].at) {
    result.v = knots[last].value;
    return result;
  }
  std::size_t i = first;
  while (knots[i + 1].at <= t) ++i;
  using Shape = Function::Spline;
  if (cubic) result.v = hermite(&knots[i - 1], t);
  else if (spline.spline == Shape::natural) result.v = natural(knots[i], knots[i + 1], t);
  else if (spline.spline == Shape::quadratic && n >= 3)
    result.v = i == 0 ? parabola(knots[0], knots[1], knots[2], t)
                      : parabola(knots[i - 1], knots[i], knots[i + 1], t);
  else result.v = straight(knots[i], knots[i + 1], t);
  return result;
}

}  // namespace nicol::sdl
