// The verb `accuracy` and its options.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"

namespace nicol::app {

struct AccuracyCommand {
  std::string scene;
  std::string output;           // .csv; the plot lies beside it; empty: the scene's name and _accuracy.csv, here
  SceneOptions options;         // 128x128 pixels
  DeviceOptions device;
  std::vector<std::string> knobs;        // names of the knobs to turn; empty: all
  int repeats = 3;                       // renderings of each setting
  int most_samples = 64;                 // a pixel, of the uniform ones that are tried
  std::string reference_error = "0.05%"; // of the reference's sampling
  double reference_step_nm = 3.2;        // of its wavelengths, or less
  int reference_samples = 4095;          // a pixel, at most
  double longest_seconds = 20;           // more samples are not tried where they would take longer
  bool quiet = false;

  AccuracyCommand() { options.width = options.height = 128; }
};

// Names that `knobs` may have.
std::vector<std::string> accuracy_knobs();

// Measures, and writes table, CSV, PNG and SVG. Throws UsageError, DeviceError, OutputError.
int accuracy_command(const AccuracyCommand& command);

}  // namespace nicol::app
