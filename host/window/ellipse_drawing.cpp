// A polarization ellipse as the receiver sees it, x to the right, y up: right-handed light turns clockwise
// (conventions: kernels/README.md).
#include <array>
#include <cmath>

#include "host/window/spectrum_plot.hpp"

namespace nicol::window {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double linear_below_rad = 0.02;

// Point of the ellipse with semi-axes cos, sin of its ellipticity, in the screen's axes (y down).
ImVec2 point_at(ImVec2 middle, double radius, const preview::Ellipse& e, double phase_rad) {
  const double along = std::cos(e.ellipticity_rad) * std::cos(phase_rad);
  const double across = std::abs(std::sin(e.ellipticity_rad)) * std::sin(phase_rad);
  const double x = along * std::cos(e.azimuth_rad) - across * std::sin(e.azimuth_rad);
  const double y = along * std::sin(e.azimuth_rad) + across * std::cos(e.azimuth_rad);
  return {middle.x + static_cast<float>(radius * x), middle.y - static_cast<float>(radius * y)};
}

// Two strokes back from the ellipse's point at that phase.
void arrow_head(ImDrawList& list, ImVec2 middle, double radius, const preview::Ellipse& e, float thickness) {
  const double turn = e.ellipticity_rad > 0 ? -1 : 1, phase = turn * 0.35 * pi;
  const ImVec2 tip = point_at(middle, radius, e, phase), before = point_at(middle, radius, e, phase - turn * 0.12);
  const double dx = before.x - tip.x, dy = before.y - tip.y, length = std::hypot(dx, dy);
  if (length < 1e-3) return;
  for (const double spread : {-0.5, 0.5}) {
    const double c = std::cos(spread) * 7 / length, s = std::sin(spread) * 7 / length;
    list.AddLine(tip, {tip.x + static_cast<float>(c * dx - s * dy), tip.y + static_cast<float>(s * dx + c * dy)},
                 handedness_colour(e), thickness);
  }
}

}  // namespace

ImU32 handedness_colour(const preview::Ellipse& ellipse) {
  if (std::abs(ellipse.ellipticity_rad) < linear_below_rad) return colours::linear;
  return ellipse.ellipticity_rad > 0 ? colours::right_handed : colours::left_handed;
}

void draw_ellipse(ImDrawList& list, ImVec2 middle, float radius, const preview::Ellipse& ellipse, bool arrow,
                  float thickness) {
  const double size = radius * ellipse.degree;
  const ImU32 colour = handedness_colour(ellipse);
  if (std::abs(ellipse.ellipticity_rad) < linear_below_rad) {
    list.AddLine(point_at(middle, size, ellipse, 0), point_at(middle, size, ellipse, pi), colour, thickness);
    return;
  }
  std::array<ImVec2, 48> points;
  const int count = radius > 20 ? 48 : 16;
  for (int i = 0; i < count; ++i)
    points[static_cast<std::size_t>(i)] = point_at(middle, size, ellipse, 2 * pi * i / count);
  list.AddPolyline(points.data(), count, colour, ImDrawFlags_Closed, thickness);
  if (arrow && size > 6) arrow_head(list, middle, size, ellipse, thickness);
}

}  // namespace nicol::window
