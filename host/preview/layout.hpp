// Where in the window what lies. Coordinates: logical pixels of the window, from the left, from the top.
#pragma once
#include <array>
#include <optional>

#include "host/preview/controls.hpp"

namespace nicol::preview {

struct Rect {
  double x = 0, y = 0, width = 0, height = 0;
  bool holds(Point p) const { return p.x >= x && p.y >= y && p.x < x + width && p.y < y + height; }
};

inline constexpr double status_height = 24, divider_width = 8, panel_width = 320;

struct Layout {
  std::array<Rect, 2> pane;      // left, right; wiped: both the whole, cut at the divider
  std::array<Rect, 2> picture;   // within: the picture, its shape kept
  Rect divider, panel, status;   // panel: no width when hidden
};
Layout lay_out(double window_width, double window_height, const Controls& controls);

// The pane under a point, 0 or 1.
std::optional<int> pane_at(const Layout& layout, const Controls& controls, Point p);

// The pixel of the picture under a point.
struct PixelPlace {
  int pane = 0, x = 0, y = 0;
};
std::optional<PixelPlace> pixel_at(const Layout& layout, const Controls& controls, Point p);

}  // namespace nicol::preview
