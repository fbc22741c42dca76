// Drags, clicks and the wheel: see input.hpp. Test: tests/preview/input_test.cpp.
#include "host/preview/input.hpp"

#include <algorithm>
#include <cmath>

namespace nicol::preview {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double click_radius = 3;            // logical pixels: what moves less is a click
constexpr double wheel_steps_per_doubling = 4;

// The picture under the point; it has an extent.
const Rect* picture_at(const Layout& layout, const Controls& controls, Point p) {
  const auto place = pixel_at(layout, controls, p);
  return place ? &layout.picture[static_cast<std::size_t>(place->pane)] : nullptr;
}

double divider_at(const Layout& layout, double x, double otherwise) {
  const double left = layout.pane[0].x, right = layout.pane[1].x + layout.pane[1].width;
  return right > left ? std::clamp((x - left) / (right - left), 0.0, 1.0) : otherwise;
}

}  // namespace

void Mouse::move(const Layout& layout, Point to) {
  const Point from = moved_ ? at_ : pressed_at_;
  at_ = to;
  if (drag_ == Drag::none) return;
  if (!moved_ && std::hypot(to.x - from.x, to.y - from.y) <= click_radius) return;
  moved_ = true;
  if (drag_ == Drag::divider) {
    controls_.divider = divider_at(layout, to.x, controls_.divider);
    return;
  }
  const Rect* picture = picture_at(layout, controls_, pressed_at_);
  if (!picture) return;
  Navigation& navigation = controls_.navigation;
  const double right = (to.x - from.x) / picture->width, up = (from.y - to.y) / picture->height;
  if (drag_ == Drag::pan) {
    navigation.pan_right += right;
    navigation.pan_up += up;
  } else {
    navigation.yaw_rad += pi * right;
    navigation.pitch_rad += pi * up * (picture->height / picture->width);
  }
}

void Mouse::press(const Layout& layout, Button button, bool shift) {
  if (drag_ != Drag::none) return;
  if (button == Button::left && layout.divider.holds(at_)) drag_ = Drag::divider;
  else if (!picture_at(layout, controls_, at_)) return;
  else drag_ = button == Button::left && !shift ? Drag::orbit : Drag::pan;
  button_ = button;
  pressed_at_ = at_;
  moved_ = false;
}

void Mouse::release(const Layout& layout, Button button) {
  if (drag_ == Drag::none || button != button_) return;
  const bool clicked = drag_ == Drag::orbit && !moved_;
  drag_ = Drag::none;
  if (!clicked) return;
  const auto place = pixel_at(layout, controls_, pressed_at_);
  if (!place) return;
  const std::array<int, 2> pixel{place->x, place->y};
  if (controls_.pinned == pixel) controls_.pinned.reset();
  else controls_.pinned = pixel;
}

// With u the place of the mouse and c the pan, both in widths from the middle of the picture, what is seen at u keeps
// its place if (u - c) 2^dz + c' = u.
void Mouse::scroll(const Layout& layout, double steps) {
  const Rect* picture = picture_at(layout, controls_, at_);
  if (!picture) return;
  const double right = (at_.x - picture->x) / picture->width - 0.5, up = 0.5 - (at_.y - picture->y) / picture->height;
  Navigation& navigation = controls_.navigation;
  const double before = navigation.zoom;
  navigation.zoom = std::clamp(before + steps / wheel_steps_per_doubling, least_zoom, most_zoom);
  const double grown = std::exp2(navigation.zoom - before);
  navigation.pan_right = right - (right - navigation.pan_right) * grown;
  navigation.pan_up = up - (up - navigation.pan_up) * grown;
}

}  // namespace nicol::preview
