// The one place that decides which effects a scene calls for, and says why.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

struct FeatureReason {
  std::string name;     // as in kernels/features.def
  std::string meaning;
  bool on = false;
  std::string reason;   // on: what calls for it ("calcite polarizer at line 12"); off: why it is left out
};

struct Features {
  std::uint32_t mask = 0;
  std::vector<FeatureReason> rows;  // every feature, in the order of features.def
  std::vector<std::string> notes;   // work saved on the host ("one geometry serves all 21 wavelengths")
};

Features decide_features(const Scene& scene, const Geometry& geometry);

}  // namespace nicol
