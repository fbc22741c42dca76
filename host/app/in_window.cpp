// `nicol preview`: the session in a window, or in none by its script.
#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>

#include "host/app/preview_command.hpp"
#include "host/window/script.hpp"
#include "host/window/window.hpp"

namespace nicol::app {
namespace {

struct WindowSize {
  int width, height;
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
  std::atomic<window::Surface*> surface{nullptr};
  const auto wake = [&surface] {
    if (window::Surface* open = surface) open->wake();
  };
  std::unique_ptr<window::Surface> opened;
  preview::Session session(preview_session(command), wake);
  const WindowSize size = window_size(command);
  window::OffscreenSurface* offscreen = nullptr;
  if (command.script.empty() || command.show) {
    opened = window::open_window("nicol preview: " + command.scene, size.width, size.height);
  } else {
    auto made = window::open_offscreen(size.width, size.height);
    offscreen = made.get();
    opened = std::move(made);
  }
  surface = opened.get();
  window::ScreenOptions options;
  options.pictures_fit_window = !command.size_given;
  if (command.script.empty()) window::run(session, *opened, options);
  else run_script(command, session, *opened, offscreen, options);
  surface = nullptr;
  return exit_done;
}

}  // namespace nicol::app
