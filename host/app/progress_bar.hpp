// One line on standard error that tells how far a render is; silent where standard error is not a
// terminal.
#pragma once
#include <string>

#include "host/app/render_picture.hpp"
#include "host/opencl/render.hpp"

namespace nicol::app {

std::string progress_line(const Progress& progress);

// Of all frames: that of the one in work goes with those before it.
Progress progress_of_frames(const Progress& frame, const FrameOfMany& frames, std::chrono::steady_clock::time_point start);
std::string frames_text(const FrameOfMany& frames);

class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { clear(); }
  void show(const Progress& progress, const std::string& before = "");
  void clear();

 private:
  bool active_;
  bool drawn_ = false;
  double last_seconds_ = -1;
};

}  // namespace nicol::app
