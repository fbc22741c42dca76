// Plugins as a scene's options name them.
#pragma once
#include <string>
#include <vector>

#include "host/engine/options.hpp"
#include "host/plugins/finder.hpp"

namespace nicol::engine {

// Where they are looked for; nothing is loaded yet.
plugins::Finder plugin_finder(const SceneOptions& options);

// Loads those that are named, and takes up their sinks, so that make_sink() knows their suffixes. UsageError for one that cannot be
// loaded.
void load_plugins(const SceneOptions& options);

// The program or the library that this is part of.
std::string own_file();

}  // namespace nicol::engine
