// What every part of the window gets to draw with.
#pragma once
#include <imgui.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/preview/session.hpp"
#include "host/window/style.hpp"
#include "host/window/surface.hpp"

namespace nicol::window {

using Widgets = std::vector<std::pair<std::string, preview::Rect>>;

struct Ui {
  preview::Session& session;
  Surface& surface;
  preview::Layout layout;
  Fonts fonts;
  Widgets& widgets;
  std::optional<preview::PixelPlace> pixel;   // the values of which are shown

  // Notes the widget just made under a name that scripts find it by, if it can be seen.
  void mark(const std::string& name) const;
};

inline ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
inline ImVec2 corner(const preview::Rect& r) { return vec(r.x, r.y); }
inline ImVec2 far_corner(const preview::Rect& r) { return vec(r.x + r.width, r.y + r.height); }

// The part of the window in which a pane can be seen: wiped, its side of the divider.
preview::Rect visible_pane(const Ui& ui, int pane);

// Begins a window without any decoration that stays at its place.
bool begin_fixed(const char* name, const preview::Rect& place);

// A label in the column of labels; what follows is on the same line and fills it.
void label(const char* text);

// Text where `width` ends with "..." if it does not fit.
std::string shortened(const std::string& text, float width);

}  // namespace nicol::window
