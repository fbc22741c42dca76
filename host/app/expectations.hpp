// The numbers that a scene says it must give (`expect { }`), measured and compared.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

struct Outcome {
  std::vector<double> value;       // measured; empty: it could not be, and `reason` says why
  std::vector<double> difference;  // value - expected
  bool pass = false;
  std::string reason;
};

const char* quantity_name(Expectation::Quantity quantity);

// Compares value by value against the expectation's tolerance. NaN never passes.
Outcome compare(const Expectation& expectation, std::vector<double> value);

// One outcome for each of the scene's expectations. Places are rendered as pictures of one pixel
// whose only sample lies exactly there.
std::vector<Outcome> evaluate_expectations(const LoadedScene& loaded, Device& device,
                                           const KernelOptions& kernel);

}  // namespace nicol::app
