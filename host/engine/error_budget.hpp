// What a finished picture is off by, from each source of error, and what each costs.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "host/engine/loaded_scene.hpp"
#include "host/channels.hpp"
#include "host/output/frame.hpp"

namespace nicol::engine {

struct BudgetLine {
  std::string source;  // "cut-off", "spectral step", ...
  // RMS over pixels, relative to the picture's mean radiance (spectral step: to its mean Y); NaN: not known, `detail` says why
  double rms = std::numeric_limits<double>::quiet_NaN();
  std::string detail;
  std::string price;   // what less of it costs
  double seconds = 0;  // that it has taken: to keep it as small, and to find out
};

struct ErrorBudget {
  std::vector<BudgetLine> lines;
  double rms = 0;      // of all that are known, as independent
  int pixels = 0;      // that were rendered again
  double seconds = 0;  // for that
  bool stopped = false;  // by Ctrl-C: what is missing says so
};

// `options` as the picture was rendered with.
ErrorBudget error_budget(const LoadedScene& loaded, int width, int height, Device& device, const RenderOptions& options,
                         const Frame& frame, const RenderReport& report);

std::string budget_text(const ErrorBudget& budget);
// For the header: name and words of each line.
std::vector<std::pair<std::string, std::string>> budget_notes(const ErrorBudget& budget);

}  // namespace nicol::engine
