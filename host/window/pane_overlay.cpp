// What is written and drawn over a picture: see panels.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/optics/colour.hpp"
#include "host/window/panels.hpp"
#include "host/window/spectrum_plot.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

using preview::Quantity;
using preview::Rect;

constexpr float margin = 8;

bool shows_difference(const Ui& ui, int pane) {
  return pane == 1 && ui.session.difference();
}

std::string kind_of_picture(const Ui& ui, int pane) {
  if (shows_difference(ui, pane)) return "difference |left - right|";
  const bool before = pane == 1 && ui.session.two_renders() && !ui.session.compares();
  return before ? "before the analyzer" : "";
}

// Text on a shade; answers where it ends below.
float shaded_text(ImDrawList& list, ImVec2 at, ImU32 colour, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + size.x + 4, at.y + size.y + 2}, colours::shade, 2);
  list.AddText(at, colour, text.c_str());
  return at.y + size.y + 6;
}

float title(const Ui& ui, ImDrawList& list, int pane, const Rect& place) {
  const preview::PaneStatus& status = ui.session.status(pane);
  const float width = static_cast<float>(place.width) - 2 * margin;
  const ImVec2 at = vec(place.x + margin, place.y + margin);
  const preview::View view = ui.session.shown_view(shows_difference(ui, pane) ? 0 : pane);
  const std::string text = pane_title(status, view, kind_of_picture(ui, pane));
  float below = shaded_text(list, at, colours::text, shortened(text, width));
  if (!status.chosen.empty()) below = shaded_text(list, {at.x, below}, colours::dim, shortened(status.chosen, width));
  if (status.stale)
    below = shaded_text(list, {at.x, below}, colours::warning, shortened("picture of an earlier reading", width));
  return below;
}

ImU32 shown_colour(const std::array<float, 3>& linear) {
  const auto level = [](float v) { return static_cast<int>(std::lround(255 * srgb_encode(v))); };
  return IM_COL32(level(linear[0]), level(linear[1]), level(linear[2]), 255);
}

// A bar of false colours with its ends' values.
void scale(const Ui& ui, ImDrawList& list, int pane, ImVec2 at) {
  if (shows_difference(ui, pane)) {
    const std::string amplification = short_number(ui.session.controls.amplification);
    shaded_text(list, at, colours::dim, fmt::format("amplified {} times", amplification));
    return;
  }
  const preview::Scale scale = preview::scale_of(ui.session.shown_view(pane));
  if (scale.rgb.empty()) return;
  constexpr float bar_width = 150, bar_height = 10;
  const std::string unit = scale.unit.empty() ? "" : " " + scale.unit;
  const std::string low = fmt::format("{:g}{}", scale.low, unit), high = fmt::format("{:g}{}", scale.high, unit);
  const float left_text = ImGui::CalcTextSize(low.c_str()).x, line = ImGui::GetTextLineHeight();
  const float bar = at.x + left_text + 6, width = left_text + bar_width + 12 + ImGui::CalcTextSize(high.c_str()).x;
  list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + width + 4, at.y + line + 2}, colours::shade, 2);
  list.AddText(at, colours::text, low.c_str());
  list.AddText({bar + bar_width + 6, at.y}, colours::text, high.c_str());
  const float step = bar_width / static_cast<float>(scale.rgb.size()), top = at.y + (line - bar_height) / 2;
  for (std::size_t i = 0; i < scale.rgb.size(); ++i) {
    const float x = bar + step * static_cast<float>(i);
    list.AddRectFilled({x, top}, {x + step, top + bar_height}, shown_colour(scale.rgb[i]));
  }
}

// Not denser than can be seen, and not more than can be drawn in no time.
int ellipse_spacing(const preview::Controls& controls, const Rect& picture) {
  constexpr double closest = 18, most = 2000;
  const double pixels = static_cast<double>(controls.width) * controls.height;
  const double by_place = closest * controls.width / std::max(1.0, picture.width);
  return std::max(1, static_cast<int>(std::ceil(std::max(by_place, std::sqrt(pixels / most)))));
}

void ellipses(const Ui& ui, ImDrawList& list, int pane, ImVec2 note_at) {
  const preview::Controls& controls = ui.session.controls;
  const Rect& picture = ui.layout.picture[static_cast<std::size_t>(pane)];
  const int spacing = ellipse_spacing(controls, picture);
  const double per_pixel = picture.width / std::max(1, controls.width);
  const float radius = static_cast<float>(0.46 * spacing * per_pixel);
  list.PushClipRect(corner(picture), far_corner(picture), true);
  for (const preview::Ellipse& ellipse : ui.session.ellipses(pane, spacing))
    draw_ellipse(list, vec(picture.x + per_pixel * ellipse.x, picture.y + per_pixel * ellipse.y), radius, ellipse,
                 false, 1.2F);
  list.PopClipRect();
  float x = note_at.x;
  for (const auto& [text, colour] : {std::pair{"right-handed", colours::right_handed},
                                     std::pair{"left-handed", colours::left_handed},
                                     std::pair{"linear", colours::linear}}) {
    shaded_text(list, {x, note_at.y}, colour, text);
    x += ImGui::CalcTextSize(text).x + 10;
  }
}

// A ring around the pixel whose values are shown, where the mouse itself does not mark it.
void mark_pixel(const Ui& ui, ImDrawList& list, int pane) {
  const preview::Controls& controls = ui.session.controls;
  if (!ui.pixel || (!controls.pinned && ui.pixel->pane == pane)) return;
  const Rect& picture = ui.layout.picture[static_cast<std::size_t>(pane)];
  const ImVec2 at = vec(picture.x + (ui.pixel->x + 0.5) * picture.width / std::max(1, controls.width),
                        picture.y + (ui.pixel->y + 0.5) * picture.height / std::max(1, controls.height));
  list.AddCircle(at, 6, IM_COL32(0, 0, 0, 200), 24, 3);
  list.AddCircle(at, 6, IM_COL32(255, 255, 255, 230), 24, 1.2F);
}

void waiting(const Ui& ui, ImDrawList& list, int pane, const Rect& place) {
  const preview::PaneStatus& status = ui.session.status(pane);
  if (status.step > 0 || !status.failure.empty() || !(status.reading || status.working)) return;
  const char* text = status.reading ? "reading the scene ..." : "tracing ...";
  const ImVec2 size = ImGui::CalcTextSize(text);
  const ImVec2 at = vec(place.x + (place.width - size.x) / 2, place.y + (place.height - size.y) / 2);
  shaded_text(list, at, colours::dim, text);
}

}  // namespace

void pane_overlay(Ui& ui, int pane) {
  const Rect place = visible_pane(ui, pane);
  if (place.width <= 0 || place.height <= 0) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(corner(place), far_corner(place), true);
  const bool draws_ellipses = ui.session.shown_view(pane).quantity == Quantity::ellipses && !shows_difference(ui, pane);
  // The title is written over the ellipses, and tells where the note begins: so it is measured first.
  const ImVec2 note_at = vec(place.x + margin, title(ui, list, pane, place));
  if (draws_ellipses) {
    ellipses(ui, list, pane, note_at);
    title(ui, list, pane, place);
  }
  scale(ui, list, pane, note_at);
  mark_pixel(ui, list, pane);
  waiting(ui, list, pane, place);
  list.PopClipRect();
}

}  // namespace nicol::window
