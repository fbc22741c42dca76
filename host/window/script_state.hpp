// What a script can ask for, as JSON in one line.
#pragma once
#include <string>

#include "host/window/window.hpp"

namespace nicol::window {

// Panes, controls, layout, widgets, frames drawn, memory.
std::string state_text(const preview::Session& session, const Surface& surface, const Screen& screen, double first_picture_seconds);

// All that is known of a pixel; null where nothing is.
std::string pixel_text(preview::Session& session, int pane, int x, int y);

// Of this process; steps of some milliseconds.
double seconds_since_start();

}  // namespace nicol::window
