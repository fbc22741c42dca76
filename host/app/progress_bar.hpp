// One line on standard error that tells how far a render is; silent where standard error is not a
// terminal.
#pragma once
#include <string>

#include "host/opencl/render.hpp"

namespace nicol::app {

std::string progress_line(const Progress& progress);

class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { clear(); }
  void show(const Progress& progress);
  void clear();

 private:
  bool active_;
  bool drawn_ = false;
  double last_seconds_ = -1;
};

}  // namespace nicol::app
