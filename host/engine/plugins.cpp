// See plugins.hpp.
#include "host/engine/plugins.hpp"

#include <filesystem>

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

}  // namespace

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
