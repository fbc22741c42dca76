// What the window says, as text: no window needed.
#pragma once
#include <string>
#include <vector>

#include "host/preview/session.hpp"

namespace nicol::window {

// Three significant digits: "0.0123", "12.3", "1.23e-07".
std::string short_number(double value);

// "block 8x8" while it gets finer, "3.2 samples" afterwards; "-" while nothing is traced.
std::string progress_text(const preview::PaneStatus& status);

// For the line at the bottom, of one pane, the changing first: what it is doing, how far it is, error, speed, effects,
// kernel, device.
std::string status_text(const preview::PaneStatus& status, bool with_device);

// In a pane's corner: name without folders, what is shown, what is left out, how fine.
// `kind`: of picture, where that is not what the scene's camera sees; else empty.
std::string pane_title(const preview::PaneStatus& status, const preview::View& view, const std::string& kind);

// "polarization degree" and the like: what a list of quantities says.
std::string quantity_label(preview::Quantity quantity);

// A line of a scene with its tabs as blanks, and the caret's place in it: -1: none. column: in bytes, from 1; 0: none.
struct ShownLine {
  std::string text;
  int caret = -1;
};
ShownLine shown_line(const std::string& line, int column);

// "scene.pov:12:5"; without a place: the file, or nothing.
std::string place_text(const preview::Message& message);

// Round numbers within [low, high], at most `most`, for an axis.
std::vector<double> ticks(double low, double high, int most);

}  // namespace nicol::window
