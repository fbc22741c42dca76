// See animation.hpp.
#include "host/app/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "host/app/film.hpp"
#include "host/app/interrupt.hpp"
#include "host/app/render_picture.hpp"

namespace nicol::app {
namespace {

constexpr int most_frames = 1'000'000;

int digits_of(const AnimationOptions& options) {
  return static_cast<int>(std::to_string(*options.final_frame).size());
}

// POV-Ray 3.7.0.10: below 1 a part of final_frame, rounded down.
int frame_at(double value, const AnimationOptions& options) {
  return static_cast<int>(std::floor(value < 1 ? value * *options.final_frame : value));
}

RenderCommand command_of_frame(const RenderCommand& command, const std::vector<std::string>& outputs, int frame) {
  RenderCommand one = command;
  one.options.clock = clock_at(command.animation, frame);
  one.outputs.clear();
  for (const std::string& path : outputs) one.outputs.push_back(frame_path(path, command.animation, frame));
  one.no_budget = true;  // of each frame: that would take a third of the time
  return one;
}

void tell_end(const std::vector<std::string>& outputs, const AnimationOptions& options, FrameRange range, int found, double seconds) {
  fmt::print(stderr, "{} to {}: {} frames rendered in {:.2f} s", frame_path(outputs.front(), options, range.first),
             frame_path(outputs.front(), options, range.last), range.last - range.first + 1 - found, seconds);
  if (found > 0) fmt::print(stderr, ", {} were there", found);
  fmt::print(stderr, "\n");
}

}  // namespace

FrameRange frames_of(const AnimationOptions& options) {
  const int first = options.initial_frame, last = *options.final_frame;
  if (first < 0 || last < first || last > most_frames)
    throw UsageError(fmt::format("frames {} to {}: the first is 0 or more, the last not before it and at most {}", first, last, most_frames));
  FrameRange range{first, last};
  if (options.subset_start) range.first = std::max(first, frame_at(*options.subset_start, options));
  if (options.subset_end) range.last = frame_at(*options.subset_end, options);
  if (range.last > last || range.last < range.first)
    throw UsageError(fmt::format("of frames {} to {} there are none from {} to {}", first, last, range.first, range.last));
  return range;
}

FrameClock clock_at(const AnimationOptions& options, int frame) {
  FrameClock clock;
  clock.initial_frame = options.initial_frame;
  clock.final_frame = *options.final_frame;
  clock.frame_number = frame;
  clock.initial_clock = options.initial_clock;
  clock.final_clock = options.final_clock;
  const int steps = clock.final_frame - clock.initial_frame + (options.cyclic ? 1 : 0);
  const double range = options.final_clock - options.initial_clock;
  clock.clock = options.initial_clock + (steps > 0 ? range * (frame - options.initial_frame) / steps : 0);
  clock.clock_delta = steps > 0 ? range / steps : 0;
  return clock;
}

std::string frame_path(const std::string& path, const AnimationOptions& options, int frame) {
  std::filesystem::path named(path);
  const std::string suffix = named.extension().string();
  named.replace_extension();
  return fmt::format("{}{:0{}}{}", named.string(), frame, digits_of(options), suffix);
}

int render_animation(const RenderCommand& command) {
  const FrameRange range = frames_of(command.animation);
  const std::vector<std::string> outputs = outputs_of(command);
  if (!command.error_map.empty()) throw UsageError("--error-map is for one picture, not for frames");
  if (!command.animation.film.empty()) check_film(command.animation.film, outputs);
  const auto start = std::chrono::steady_clock::now();
  const std::atomic<bool>& cancel = finish_first();
  RenderTools tools;
  int found = 0;
  for (int frame = range.first; frame <= range.last; ++frame) {
    const RenderCommand one = command_of_frame(command, outputs, frame);
    tools.frames = {frame - range.first, range.last - range.first + 1, frame - range.first - found};
    const int code = cancel ? exit_interrupted : render_picture(one, tools);
    if (code == exit_interrupted)
      fmt::print(stderr, "nicol: interrupted in frame {} of {} to {}; --continue goes on from here\n", frame, range.first, range.last);
    if (code == exit_error) fmt::print(stderr, "nicol: frame {} (clock {:g}) failed\n", frame, one.options.clock.clock);
    if (code != exit_done) return code;
    if (tools.was_there) ++found;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!command.quiet) tell_end(outputs, command.animation, range, found, taken.count());
  if (command.animation.film.empty()) return exit_done;
  const int code = make_film(command.animation, outputs, range, command.quiet);
  return cancel ? exit_interrupted : code;
}

}  // namespace nicol::app
