// Rectangles of the window, and the pixel under a point.
#include <doctest/doctest.h>

#include <cmath>

#include "host/preview/layout.hpp"

namespace nicol::preview {
namespace {

bool within(const Rect& inner, const Rect& outer) {
  const double slack = 1e-9;
  return inner.x >= outer.x - slack && inner.x + inner.width <= outer.x + outer.width + slack &&
         inner.y >= outer.y - slack && inner.y + inner.height <= outer.y + outer.height + slack;
}

Controls controls_of(int width, int height) {
  Controls controls;
  controls.width = width;
  controls.height = height;
  return controls;
}

}  // namespace

TEST_CASE("layout: panes, divider, panel and status fill the window without overlap") {
  const Layout l = lay_out(1600, 900, controls_of(640, 480));
  CHECK(l.status.y + l.status.height == 900);
  CHECK(l.panel.x + l.panel.width == 1600);
  CHECK(l.panel.width == panel_width);
  CHECK(l.pane[0].x == 0);
  CHECK(l.pane[0].x + l.pane[0].width == l.divider.x);
  CHECK(l.divider.x + l.divider.width == l.pane[1].x);
  CHECK(l.pane[1].x + l.pane[1].width == l.panel.x);
  CHECK(l.pane[0].height == l.status.y);
  CHECK(l.pane[0].width == l.pane[1].width);
}

TEST_CASE("layout: a picture keeps its shape, as large as its pane lets it, in the middle") {
  for (const auto& size : {std::array<int, 2>{640, 480}, {100, 900}, {3, 1}}) {
    const Controls controls = controls_of(size[0], size[1]);
    const Layout l = lay_out(1300, 700, controls);
    for (std::size_t i = 0; i < 2; ++i) {
      const Rect &pane = l.pane[i], &picture = l.picture[i];
      CHECK(picture.width / picture.height == doctest::Approx(static_cast<double>(size[0]) / size[1]));
      CHECK(within(picture, pane));
      CHECK(std::min(pane.width - picture.width, pane.height - picture.height) == doctest::Approx(0));
      CHECK(picture.x + picture.width / 2 == doctest::Approx(pane.x + pane.width / 2));
      CHECK(picture.y + picture.height / 2 == doctest::Approx(pane.y + pane.height / 2));
    }
  }
}

TEST_CASE("layout: the divider leaves both panes some room") {
  Controls controls = controls_of(640, 480);
  controls.divider = 0;
  CHECK(lay_out(1000, 500, controls).pane[0].width == doctest::Approx(40));
  controls.divider = 1;
  CHECK(lay_out(1000, 500, controls).pane[1].width == doctest::Approx(40));
  controls.divider = 0.25;
  controls.show_panel = false;
  const Layout l = lay_out(1000, 500, controls);
  CHECK(l.divider.x + divider_width / 2 == 250);
  CHECK(l.panel.width == 0);
}

TEST_CASE("layout: windows of any size have no negative rectangles") {
  for (const double width : {0.0, 1.0, 7.0, 90.0, 400.0})
    for (const double height : {0.0, 1.0, 24.0, 30.0})
      for (const bool wipe : {false, true}) {
        Controls controls = controls_of(640, 480);
        controls.wipe = wipe;
        const Layout l = lay_out(width, height, controls);
        const Rect window{0, 0, width, height};
        for (const Rect& r : {l.pane[0], l.pane[1], l.picture[0], l.picture[1], l.divider, l.panel, l.status}) {
          CHECK((r.width >= 0 && r.height >= 0));
          CHECK(within(r, window));
        }
        for (double x = -1; x <= width + 1; x += 1) pixel_at(l, controls, {x, height / 2});
      }
  CHECK(lay_out(400, 300, controls_of(0, 0)).picture[0].width == 0);
  CHECK(lay_out(500, 300, controls_of(4, 3)).panel.width == 250);
}

TEST_CASE("layout: the pixel under a point") {
  const Controls controls = controls_of(64, 48);
  const Layout l = lay_out(1400, 800, controls);
  for (int pane = 0; pane < 2; ++pane) {
    const Rect& r = l.picture[static_cast<std::size_t>(pane)];
    for (const auto& pixel : {std::array<int, 2>{0, 0}, {63, 47}, {10, 31}}) {
      const auto place =
          pixel_at(l, controls, {r.x + (pixel[0] + 0.5) / 64 * r.width, r.y + (pixel[1] + 0.5) / 48 * r.height});
      REQUIRE(place);
      CHECK(place->pane == pane);
      CHECK(place->x == pixel[0]);
      CHECK(place->y == pixel[1]);
    }
  }
  CHECK_FALSE(pixel_at(l, controls, {l.divider.x + 1, 100}));
  CHECK_FALSE(pixel_at(l, controls, {l.panel.x + 1, 100}));
  CHECK_FALSE(pixel_at(l, controls, {100, l.status.y + 1}));
}

TEST_CASE("layout: wiped, both pictures lie in one place and the divider cuts") {
  Controls controls = controls_of(64, 48);
  controls.wipe = true;
  const Layout l = lay_out(1400, 800, controls);
  CHECK(l.picture[0].x == l.picture[1].x);
  CHECK(l.picture[0].width == l.picture[1].width);
  const double cut = l.divider.x + l.divider.width / 2;
  CHECK(pane_at(l, controls, {cut - 1, 300}) == 0);
  CHECK(pane_at(l, controls, {cut + 1, 300}) == 1);
  CHECK_FALSE(pane_at(l, controls, {l.panel.x + 1, 300}));
}

}  // namespace nicol::preview
