// Renders a scene at many settings and holds each picture against a reference.
#pragma once
#include <atomic>
#include <string>
#include <vector>

#include "host/accuracy/measurements.hpp"
#include "host/app/accuracy_command.hpp"
#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

class ProgressBar;

struct Sweep {
  bool has_reference = false;   // false: interrupted before there was anything to tell
  Reference reference;
  std::vector<Measurement> measurements;
  KnobErrors base_alone;            // what each knob errs where the scene has it
  std::vector<std::string> notes;   // what was left out, and why
  std::string device;               // as the renders report it
  bool interrupted = false;
};

// Every setting once, then all of them again in turn, so that the machine's moods meet all alike. Building of kernels
// lies outside of the times. Stops after the tiles in flight where `cancel` is raised, and answers what it has.
Sweep run_sweep(const AccuracyCommand& command, const LoadedScene& loaded, Device& device,
                const std::atomic<bool>& cancel, ProgressBar& bar);

}  // namespace nicol::app
