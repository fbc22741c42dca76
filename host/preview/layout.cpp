// Rectangles of the window: see layout.hpp. Test: tests/preview/layout_test.cpp.
#include "host/preview/layout.hpp"

#include <algorithm>
#include <cmath>

namespace nicol::preview {
namespace {

constexpr double narrowest_pane = 40;

// Where the divider's middle lies in an area of that width.
double divider_middle(double width, double part) {
  const double least = narrowest_pane + divider_width / 2;
  if (width < 2 * least) return width / 2;
  return std::clamp(part * width, least, width - least);
}

// The largest rectangle of this shape in the middle of the pane.
Rect fitted(const Rect& pane, int width, int height) {
  if (width <= 0 || height <= 0) return {pane.x, pane.y, 0, 0};
  const double scale = std::min(pane.width / width, pane.height / height);
  const double w = scale * width, h = scale * height;
  return {pane.x + (pane.width - w) / 2, pane.y + (pane.height - h) / 2, w, h};
}

}  // namespace

Layout lay_out(double window_width, double window_height, const Controls& controls) {
  const double width = std::max(window_width, 0.0), height = std::max(window_height, 0.0);
  Layout layout;
  const double status = std::min(status_height, height);
  layout.status = {0, height - status, width, status};

  const double panel = controls.show_panel ? std::min(panel_width, width / 2) : 0;
  const Rect area{0, 0, width - panel, height - status};
  layout.panel = {area.width, 0, panel, area.height};

  const double middle = divider_middle(area.width, controls.divider), half = std::min(divider_width, area.width) / 2;
  layout.divider = {middle - half, 0, 2 * half, area.height};
  layout.pane[0] = controls.wipe ? area : Rect{0, 0, middle - half, area.height};
  layout.pane[1] = controls.wipe ? area : Rect{middle + half, 0, area.width - middle - half, area.height};
  for (std::size_t i = 0; i < 2; ++i) layout.picture[i] = fitted(layout.pane[i], controls.width, controls.height);
  return layout;
}

std::optional<int> pane_at(const Layout& layout, const Controls& controls, Point p) {
  if (controls.wipe) {
    if (!layout.pane[0].holds(p)) return std::nullopt;
    return p.x < layout.divider.x + layout.divider.width / 2 ? 0 : 1;
  }
  for (int i = 0; i < 2; ++i)
    if (layout.pane[static_cast<std::size_t>(i)].holds(p)) return i;
  return std::nullopt;
}

std::optional<PixelPlace> pixel_at(const Layout& layout, const Controls& controls, Point p) {
  const auto pane = pane_at(layout, controls, p);
  if (!pane) return std::nullopt;
  const Rect& picture = layout.picture[static_cast<std::size_t>(*pane)];
  if (!picture.holds(p)) return std::nullopt;
  const auto place = [](double part, int count) {
    return std::clamp(static_cast<int>(std::floor(part * count)), 0, count - 1);
  };
  return PixelPlace{*pane, place((p.x - picture.x) / picture.width, controls.width),
                    place((p.y - picture.y) / picture.height, controls.height)};
}

}  // namespace nicol::preview
