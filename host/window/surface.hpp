// What a window is drawn on: a real one (GLFW), or none at all (EGL without a display) for scripts and tests.
#pragma once
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/preview/input.hpp"
#include "host/preview/layout.hpp"

namespace nicol::window {

// The message is complete: what is missing, and what would mend it.
struct WindowError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Event {
  enum class Kind {
    mouse_move, mouse_press, mouse_release, scroll, key_press, key_release, character, resize, close, focus
  };
  Kind kind = Kind::mouse_move;
  preview::Point at;                               // mouse_move: logical pixels from the left, from the top
  preview::Button button = preview::Button::left;
  double scroll_right = 0, scroll_up = 0;          // steps of the wheel
  // As preview::Action has it: "d", "shift+1", "F2", "left", "["; with its modifiers in the order ctrl, alt, shift.
  // Signs come as they are typed, without shift.
  std::string key;
  bool repeated = false;                           // the key is held down
  bool shift = false, ctrl = false, alt = false;   // of mouse and key events
  char32_t character = 0;                          // of text typed
  bool focused = true;
};

enum class Cursor { arrow, resize_horizontally };

// All but wake() and push() is for the thread that made it.
class Surface {
 public:
  virtual ~Surface() = default;

  virtual void make_current() = 0;
  virtual unsigned framebuffer() const = 0;        // OpenGL's name of what is drawn to; 0: the window's own
  virtual void framebuffer_size(int& width, int& height) const = 0;
  virtual double content_scale() const = 0;        // framebuffer pixels per logical pixel
  virtual void swap() = 0;
  // Until there is an event, or a wake() since the last wait, or the time is over.
  virtual void wait(std::optional<double> timeout_seconds) = 0;
  virtual void poll() = 0;                         // takes up events without waiting
  virtual void wake() = 0;                         // from any thread
  virtual void set_clipboard(const std::string& text) = 0;
  virtual void set_cursor(Cursor cursor) = 0;
  virtual bool should_close() const = 0;

  double logical_width() const;
  double logical_height() const;

  void push(Event event);                          // as if a person had done it; from any thread
  std::optional<Event> next_event();               // none: all are taken
  bool has_events() const;

 private:
  mutable std::mutex mutex_;
  std::deque<Event> events_;
};

// A visible window with OpenGL 3.3. Throws WindowError.
std::unique_ptr<Surface> open_window(const std::string& title, int width, int height);

// No display: draws into memory. width and height in framebuffer pixels.
class OffscreenSurface : public Surface {
 public:
  virtual void resize(int width, int height) = 0;  // and tells so by an event
  virtual std::string clipboard() const = 0;       // what was last put there
  virtual Cursor cursor() const = 0;
};
std::unique_ptr<OffscreenSurface> open_offscreen(int width, int height, double content_scale = 1);

}  // namespace nicol::window
