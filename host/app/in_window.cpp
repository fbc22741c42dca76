// `nicol preview`: the session in a window, or in none by its script.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <mutex>

#include "host/app/preview_command.hpp"
#include "host/window/script.hpp"
#include "host/window/window.hpp"

namespace nicol::app {
namespace {

struct WindowSize {
  int width, height;
};

// Tells the surface that is open, if one is, that there is something new.
class Waker {
 public:
  void set(window::Surface* surface) {
    const std::lock_guard<std::mutex> held(lock_);
    surface_ = surface;
  }
  void wake() {
    const std::lock_guard<std::mutex> held(lock_);
    if (surface_) surface_->wake();
  }

 private:
  std::mutex lock_;
  window::Surface* surface_ = nullptr;
};

// Both pictures at their full size beside the panel, within what most screens hold.
WindowSize window_size(const PreviewCommand& command) {
  constexpr int least_width = 900, least_height = 720, most_width = 1800, most_height = 1000;
  const double width = 2 * command.options.width + preview::divider_width + preview::panel_width;
  const double height = command.options.height + preview::status_height;
  return {std::clamp(static_cast<int>(width), least_width, most_width), std::clamp(static_cast<int>(height), least_height, most_height)};
}

void run_script(const PreviewCommand& command, preview::Session& session, window::Surface& surface,
                window::OffscreenSurface* offscreen, const window::ScreenOptions& options) {
  window::Script script(session, surface, offscreen, options);
  if (command.script == "-") return script.run(std::cin, std::cout, true);
  std::ifstream in(command.script);
  if (!in) throw UsageError("cannot read the script " + command.script);
  try {
    script.run(in, std::cout, false);
  } catch (const window::ScriptError& error) {
    throw UsageError(command.script + ", " + error.what());
  }
}

}  // namespace

int preview_command(const PreviewCommand& command) {
  if (!command.script.empty() && command.script != "-" && !std::ifstream(command.script))
    throw UsageError("cannot read the script " + command.script);
  // Work begins while the window is being opened.
  Waker waker;
  std::unique_ptr<window::Surface> opened;
  preview::Session session(preview_session(command), [&waker] { waker.wake(); });
  const WindowSize size = window_size(command);
  window::OffscreenSurface* offscreen = nullptr;
  if (command.script.empty() || command.show) {
    opened = window::open_window("nicol preview: " + command.scene, size.width, size.height);
  } else {
    auto made = window::open_offscreen(size.width, size.height);
    offscreen = made.get();
    opened = std::move(made);
  }
  waker.set(opened.get());
  window::ScreenOptions options;
  options.pictures_fit_window = !command.size_given;
  if (command.script.empty()) window::run(session, *opened, options);
  else run_script(command, session, *opened, offscreen, options);
  // The window goes at once; a kernel in building is waited for.
  waker.set(nullptr);
  opened.reset();
  return exit_done;
}

}  // namespace nicol::app
