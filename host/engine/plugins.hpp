// Plugins as a scene's options name them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host/engine/options.hpp"
#include "host/fragments/manifest.hpp"
#include "host/plugins/finder.hpp"

namespace nicol::engine {

// Where they are looked for; nothing is loaded yet.
plugins::Finder plugin_finder(const SceneOptions& options);

// Fragments in the folders where scenes look for them, by the folders' order and then by name: NAME.json beside NAME.cl, there or in a folder
// NAME. faults: of manifests that cannot be used.
struct FoundFragments {
  std::vector<std::pair<std::string, Manifest>> manifests;   // with their files
  std::vector<std::string> faults;
};
FoundFragments find_fragments(const SceneOptions& options);

// Loads those that are named, and takes up their sinks, so that make_sink() knows their suffixes. UsageError for one that cannot be
// loaded.
void load_plugins(const SceneOptions& options);

// The program or the library that this is part of.
std::string own_file();

}  // namespace nicol::engine
