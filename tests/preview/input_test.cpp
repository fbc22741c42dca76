// What the mouse does to the controls, and with them to the picture.
#include <doctest/doctest.h>

#include <cmath>

#include "camera_view.hpp"
#include "host/preview/input.hpp"

namespace nicol::preview {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Window {
  Controls controls;
  Mouse mouse{controls};
  Layout layout() const { return lay_out(1400, 800, controls); }
  Rect picture(std::size_t pane = 0) const { return layout().picture[pane]; }
  Point in_picture(double right, double down, std::size_t pane = 0) const {
    const Rect r = picture(pane);
    return {r.x + right * r.width, r.y + down * r.height};
  }
  void move(Point to) { mouse.move(layout(), to); }
  void drag(Point from, Point to, Button button, bool shift = false) {
    move(from);
    mouse.press(layout(), button, shift);
    move({(from.x + to.x) / 2, (from.y + to.y) / 2});
    move(to);
    mouse.release(layout(), button);
  }
};

}  // namespace

TEST_CASE("input: a drag over the width of the picture is half a turn") {
  for (const std::size_t pane : {0u, 1u}) {
    Window w;
    w.drag(w.in_picture(0.001, 0.5, pane), w.in_picture(1.001, 0.5, pane), Button::left);
    CHECK(w.controls.navigation.yaw_rad == doctest::Approx(pi));
    CHECK(w.controls.navigation.pitch_rad == doctest::Approx(0));
    CHECK_FALSE(w.controls.pinned);
    CHECK_FALSE(w.mouse.dragging());
  }
  Window w;
  w.drag(w.in_picture(0.5, 0.75), w.in_picture(0.5, 0.25), Button::left);
  CHECK(w.controls.navigation.pitch_rad == doctest::Approx(pi / 2 * 480 / 640));
}

TEST_CASE("input: panned content follows the mouse") {
  for (const int way : {0, 1, 2}) {
    Window w;
    const Button button = way == 0 ? Button::left : way == 1 ? Button::middle : Button::right;
    w.drag(w.in_picture(0.2, 0.2), w.in_picture(0.7, 0.1), button, way == 0);
    CHECK(w.controls.navigation.pan_right == doctest::Approx(0.5));
    CHECK(w.controls.navigation.pan_up == doctest::Approx(0.1));
    CHECK(w.controls.navigation.yaw_rad == 0);
  }
}

TEST_CASE("input: what is under the mouse stays there when the wheel turns and when it is panned") {
  Camera base;
  base.location = {1, 2, 30};
  base.direction = {0, 0, -1};
  base.right = {4.0 / 3, 0, 0};
  base.up = {0, 1, 0};
  const Vec3 pivot{1, 2, 4};
  for (const bool orthographic : {false, true}) {
    base.orthographic = orthographic;
    Window w;
    w.controls.navigation.pan_right = 0.1;
    const double right = 0.8, down = 0.3;
    const auto under = [&] {  // the point of the plane through the pivot that is under the mouse
      const Camera c = moved(base, w.controls.navigation, pivot);
      const double scale = orthographic ? 1 : (c.location.z - pivot.z);
      return c.location + (c.right * (right - 0.5) + c.up * (0.5 - down)) * scale + c.direction * (c.location.z - pivot.z);
    };
    const Vec3 before = under();
    w.move(w.in_picture(right, down));
    w.mouse.scroll(w.layout(), 3);
    CHECK(w.controls.navigation.zoom == 0.75);
    CHECK(length(under() - before) < 1e-12 * 30);
    w.mouse.scroll(w.layout(), -7);
    CHECK(w.controls.navigation.zoom == -1);
    CHECK(length(under() - before) < 1e-12 * 30);

    w.drag(w.in_picture(right, down), w.in_picture(right - 0.25, down + 0.5), Button::right);
    const auto place = place_in_picture(moved(base, w.controls.navigation, pivot), before);
    CHECK(place[0] == doctest::Approx(right - 0.25 - 0.5));
    CHECK(place[1] == doctest::Approx(0.5 - down - 0.5));
  }
}

TEST_CASE("input: the divider follows the mouse, wiped or not") {
  for (const bool wipe : {false, true}) {
    Window w;
    w.controls.wipe = wipe;
    const Rect d = w.layout().divider;
    w.move({d.x + d.width / 2, 300});
    CHECK(w.mouse.over_divider(w.layout()));
    w.drag({d.x + d.width / 2, 300}, {324, 320}, Button::left);
    CHECK(w.controls.divider == doctest::Approx(324.0 / (1400 - panel_width)));
    CHECK(w.layout().divider.x + divider_width / 2 == doctest::Approx(324));
    CHECK(w.controls.navigation == Navigation{});
    w.drag({324, 320}, {-500, 320}, Button::left);
    CHECK(w.controls.divider == 0);
  }
}

TEST_CASE("input: a click pins the pixel, another lets go, a drag does neither") {
  Window w;
  const auto click = [&](Point p) { w.drag(p, {p.x + 1, p.y + 1}, Button::left); };
  click(w.in_picture(0.5, 0.25));
  REQUIRE(w.controls.pinned);
  CHECK((*w.controls.pinned)[0] == 320);
  CHECK((*w.controls.pinned)[1] == 120);
  CHECK(w.controls.navigation == Navigation{});
  w.drag(w.in_picture(0.5, 0.25), w.in_picture(0.6, 0.25), Button::left);
  CHECK(w.controls.pinned);
  click(w.in_picture(0.1, 0.1, 1));
  CHECK((*w.controls.pinned)[0] == 64);
  click(w.in_picture(0.1, 0.1));
  CHECK_FALSE(w.controls.pinned);
  w.drag(w.in_picture(0.5, 0.5), w.in_picture(0.5, 0.5), Button::right);
  CHECK_FALSE(w.controls.pinned);
}

TEST_CASE("input: outside of the pictures nothing happens") {
  Window w;
  const Layout l = w.layout();
  for (const Point p : {Point{l.panel.x + 20, 100}, Point{100, l.status.y + 5}, Point{-5, -5}}) {
    w.drag(p, {400, 300}, Button::left);
    w.move(p);
    w.mouse.scroll(l, 4);
    CHECK(w.controls.navigation == Navigation{});
    CHECK_FALSE(w.controls.pinned);
  }
}

TEST_CASE("input: a second button does not end a drag") {
  Window w;
  w.move(w.in_picture(0.25, 0.5));
  w.mouse.press(w.layout(), Button::left, false);
  w.mouse.press(w.layout(), Button::right, false);
  w.mouse.release(w.layout(), Button::right);
  CHECK(w.mouse.dragging());
  w.move(w.in_picture(0.75, 0.5));
  CHECK(w.controls.navigation.yaw_rad == doctest::Approx(pi / 2));
  CHECK(w.controls.navigation.pan_right == 0);
}

}  // namespace nicol::preview
