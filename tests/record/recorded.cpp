#include "tests/record/recorded.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "host/bind/bind.hpp"
#include "sdl/parse.hpp"

namespace nicol::test {
namespace {

constexpr int size = 400;

Loaded load(const std::function<void(const sdl::Options&, sdl::Result&)>& parse, const std::vector<double>& lambda_nm) {
  sdl::Options options;
  options.library_paths = {SCENES_FOLDER "/include", SCENES_FOLDER "/founding", SCENES_FOLDER "/gems"};
  options.image_width = options.image_height = size;
  options.debug = [](const std::string&) {};
  sdl::Result parsed;
  parse(options, parsed);
  BindOptions wanted;
  wanted.width = wanted.height = size;
  wanted.library_paths = options.library_paths;
  wanted.lambda_nm = lambda_nm;
  auto& items = parsed.document.items;  // expectations hold for the scene's own wavelengths
  items.erase(std::remove_if(items.begin(), items.end(),
                             [](const sdl::Item& item) { return item.block() && item.block()->name == "expect"; }),
              items.end());
  Loaded loaded;
  loaded.scene = bind(parsed.document, wanted, parsed.diagnostics);
  if (!parsed.diagnostics.failed()) loaded.geometry = build_geometry(loaded.scene, parsed.diagnostics);
  if (parsed.diagnostics.failed()) throw std::runtime_error(parsed.diagnostics.text());
  loaded.features = decide_features(loaded.scene, loaded.geometry);
  return loaded;
}

}  // namespace

Loaded load_gallery(const std::string& file, const std::vector<double>& lambda_nm) {
  return load([&](const sdl::Options& options,
                  sdl::Result& parsed) { sdl::parse_file(SCENES_FOLDER "/" + file, options, parsed); },
              lambda_nm);
}

Loaded load_text(const std::string& text) {
  return load([&](const sdl::Options& options,
                  sdl::Result& parsed) { sdl::parse_text("test.pov", text, options, parsed); },
              {});
}

bool has_effect(const PathRecord& record, const std::string& name) {
  return std::find(record.effects.begin(), record.effects.end(), name) != record.effects.end();
}

std::vector<int> cells_met(const PathRecord& record) {
  std::vector<int> cells;
  for (const MetCell& met : record.cells) cells.push_back(met.cell);
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace nicol::test
