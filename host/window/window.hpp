// The window of the preview: a session shown on a surface.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/preview/session.hpp"
#include "host/window/surface.hpp"

namespace nicol::window {

struct Screenshot {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;   // 3 bytes a pixel, sRGB, rows from the top
};

struct ScreenOptions {
  bool pictures_fit_window = true; // their size follows the window's (Session::take_window_size)
};

// The session must have been given surface.wake() to wake it, and both must outlive the screen. One at a time: ImGui
// has one context. Throws WindowError where OpenGL is not what it must be.
class Screen {
 public:
  Screen(preview::Session& session, Surface& surface, ScreenOptions options = {});
  ~Screen();

  // Takes up what has happened, without waiting; draws a frame if anything that is shown may have changed.
  void turn();
  void redraw();                      // the next turn draws: the controls were changed by other hands
  bool more_to_do() const;            // events are left, or a frame is to follow: the next turn should not wait
  bool size_waits() const;            // for the window's size to stay as it is: a turn is to follow soon
  bool ended() const;                 // closed, by the window's button or a key
  std::uint64_t frames_drawn() const;

  Screenshot screenshot();            // of the last frame, drawn once more
  // The important widgets of the last frame that can be seen, by name ("analyzer", "difference", "View"), in logical
  // pixels.
  const std::vector<std::pair<std::string, preview::Rect>>& widgets() const;
  const preview::Layout& layout() const;   // of the last frame

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Until the window is closed. Draws only after an event or when the session has something new, then at most 20 times a
// second.
void run(preview::Session& session, Surface& surface, ScreenOptions options = {});

}  // namespace nicol::window
