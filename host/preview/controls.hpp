// All that a person can set in the window: plain data, changed by widgets, keys, mouse and scripts, read once a turn by the session.
#pragma once
#include <array>
#include <optional>
#include <set>
#include <string>

#include "host/preview/navigation.hpp"
#include "host/preview/view.hpp"

namespace nicol::preview {

struct Point {
  double x = 0, y = 0;
};

struct Controls {
  Navigation navigation;                       // of both panes, each counted from its own scene's camera
  Analyzer analyzer = Analyzer::as_scene;
  double analyzer_deg = 0, polarizer_deg = 0;  // counter-clockwise, from where the scene has them
  std::set<std::string> without;               // effects left out (host/effects.hpp) on both sides
  std::set<std::string> without_right;         // on the right side only; not empty: the right pane is a render of its own
  int width = 640, height = 480;               // of the pictures, pixels
  double exposure_stops = 0;                   // powers of 2, beside the scene's exposure
  std::array<View, 2> view{{{}, {Quantity::degree, {}}}};   // what the left and the right pane show
  bool before_analyzer = false;                // one scene: the right pane is a render of the light that arrives at the analyzer
  std::optional<std::size_t> scrubbed;         // wavelength of both panes, in place of the views' own
  bool show_difference = false;                // the right pane shows |left - right|
  double amplification = 10;                   // of the difference
  double divider = 0.5;                        // part of the window's width that is the left pane's
  bool wipe = false;                           // both panes fill the window; the divider cuts
  bool show_panel = true, show_help = false;
  std::optional<std::array<int, 2>> pinned;    // pixel whose values stay while the mouse goes on
};

}  // namespace nicol::preview
