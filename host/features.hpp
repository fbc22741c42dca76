// The one place that decides which effects a scene calls for, and says why.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/fragments/scene_fragments.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

struct FeatureReason {
  std::string name;     // as in kernels/features.def
  std::string meaning;
  bool on = false;
  std::string reason;   // on: what calls for it ("calcite polarizer at line 12"); off: why it is left out
};

// What a kernel is built for: these features, and the fragments that plugins bring (null: none).
struct KernelContents {
  std::uint32_t features = 0;
  std::shared_ptr<const SceneFragments> fragments;
  KernelContents(std::uint32_t mask, std::shared_ptr<const SceneFragments> of_plugins = nullptr)
      : features(mask), fragments(std::move(of_plugins)) {}
  const std::string& fragment_text() const {
    static const std::string none;
    return fragments ? fragments->text : none;
  }
};

struct Features {
  std::uint32_t mask = 0;
  std::shared_ptr<const SceneFragments> fragments;
  KernelContents contents() const { return {mask, fragments}; }
  std::vector<FeatureReason> rows;  // every feature, in the order of features.def
  std::vector<std::string> notes;   // work saved on the host ("one geometry serves all 21 wavelengths")
};

Features decide_features(const Scene& scene, const Geometry& geometry);

}  // namespace nicol
