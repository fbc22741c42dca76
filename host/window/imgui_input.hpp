// A surface's events handed to ImGui, in portions that it can take.
#pragma once
#include <optional>
#include <vector>

#include "host/window/surface.hpp"

namespace nicol::window {

class ImguiInput {
 public:
  ImguiInput();                            // needs ImGui's context

  // Takes the events of one turn, feeds them to ImGui and gives them back. ImGui sees the state at the turn's end
  // only: so a turn ends after a mouse button changed, before one changes where the mouse has moved, and before a key
  // just pressed is let go.
  std::vector<Event> take(Surface& surface);
  bool has_more(const Surface& surface) const { return held_ || surface.has_events(); }

 private:
  void feed(const Event& event);
  void set_key(const std::string& name, bool down);

  std::optional<Event> held_;              // the first of the next turn
};

// "shift+left": "left".
std::string without_modifiers(const std::string& key);

}  // namespace nicol::window
