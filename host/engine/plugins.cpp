// See plugins.hpp.
#include "host/engine/plugins.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "host/engine/loaded_scene.hpp"
#include "host/output/sinks.hpp"
#include "host/plugins/plugin_sink.hpp"

namespace nicol::engine {
namespace {

namespace fs = std::filesystem;

// Where it was built, if it lies there; else below the prefix that it is installed under.
std::vector<std::string> own_folders() {
  std::error_code failed;
  const std::string self = own_file(), built = NICOL_BUILD_FOLDER;
  if (self.rfind(built + "/", 0) == 0) return {built + "/plugins"};
  constexpr int levels_up = 4;  // usr/bin/nicol, usr/lib/x86_64-linux-gnu/libnicol.so
  fs::path above = fs::path(self).parent_path();
  for (int i = 0; i < levels_up; ++i, above = above.parent_path())
    for (const char* place : {NICOL_LIBDIR "/nicol/plugins", "lib/nicol/plugins"})
      if (fs::is_directory(above / place, failed)) return {(above / place).string()};
  return {};
}

// Where two want the suffix, the complaint waits for a picture with it.
SinkMaker maker_for(plugins::Finder& finder, const std::string& suffix) {
  try {
    const plugins::Sink* sink = finder.sink(suffix);
    return [sink](const std::string& path) { return plugins::make_plugin_sink(*sink, path); };
  } catch (const plugins::PluginError& error) {
    return [why = std::string(error.what())](const std::string&) -> std::unique_ptr<FrameSink> { throw UsageError(why); };
  }
}

// The manifests of one folder and of its folders, sorted.
std::vector<fs::path> manifests_in(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
    const fs::path path = entry.path();
    const fs::path manifest = entry.is_directory(failed) ? path / (path.filename().string() + ".json") : path;
    const bool pair = manifest.extension() == ".json" && fs::is_regular_file(manifest, failed) &&
                      fs::is_regular_file(fs::path(manifest).replace_extension(".cl"), failed);
    if (pair) found.push_back(manifest);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

FoundFragments find_fragments(const SceneOptions& options) {
  FoundFragments found;
  std::set<fs::path> met;
  std::error_code failed;
  for (const std::string& folder : parse_options(options).library_paths)
    for (const fs::path& file : manifests_in(folder)) {
      if (!met.insert(fs::weakly_canonical(file, failed)).second) continue;
      try {
        found.manifests.emplace_back(file.string(), read_manifest(file.string()));
      } catch (const ManifestError& error) {
        found.faults.push_back(error.what());
      }
    }
  return found;
}

plugins::Finder plugin_finder(const SceneOptions& options) {
  return plugins::Finder(plugins::places_of(options.plugins, options.library_paths, own_folders()));
}

void load_plugins(const SceneOptions& options) {
  plugins::Finder finder = plugin_finder(options);
  try {
    finder.load_named();
  } catch (const plugins::PluginError& error) {
    throw UsageError(error.what());
  }
  for (const plugins::Library* library : finder.named())
    for (const plugins::Sink& sink : library->sinks) add_sink_maker(sink.suffix, maker_for(finder, sink.suffix));
}

}  // namespace nicol::engine
