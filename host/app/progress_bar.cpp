// See progress_bar.hpp.
#include "host/app/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nicol::app {
namespace {

std::string clock_text(double seconds) {
  const long whole_s = std::lround(std::clamp(seconds, 0.0, 3.6e6));
  if (whole_s < 3600) return fmt::format("{}:{:02}", whole_s / 60, whole_s % 60);
  return fmt::format("{}:{:02}:{:02}", whole_s / 3600, whole_s / 60 % 60, whole_s % 60);
}

}  // namespace

std::string progress_line(const Progress& progress) {
  constexpr int width = 30;
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * width);
  return fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  {:.1f} M segments/s  {} left", "", filled, "",
                     width - filled, std::floor(100 * fraction), progress.segments_per_second / 1e6,
                     clock_text(progress.seconds_left));
}

Progress progress_of_frames(const Progress& frame, const FrameOfMany& frames, std::chrono::steady_clock::time_point start) {
  Progress all = frame;
  all.fraction = (frames.index + frame.fraction) / frames.count;
  all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double rendered = frames.rendered + frame.fraction, ahead = frames.count - frames.index - frame.fraction;
  all.seconds_left = rendered > 0 ? all.seconds * ahead / rendered : 0;
  return all;
}

std::string frames_text(const FrameOfMany& frames) { return fmt::format("frame {} of {} ", frames.index + 1, frames.count); }

ProgressBar::ProgressBar(bool wanted) : active_(wanted && isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const Progress& progress, const std::string& before) {
  constexpr double redraw_after_s = 0.1;
  if (!active_ || (drawn_ && progress.seconds < last_seconds_ + redraw_after_s)) return;
  last_seconds_ = progress.seconds;
  drawn_ = true;
  fmt::print(stderr, "\r\033[K{}{}", before, progress_line(progress));
  std::fflush(stderr);
}

void ProgressBar::clear() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace nicol::app
