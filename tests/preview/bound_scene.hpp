// A scene text taken through parser, bind and solids.
#pragma once
#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "host/bind/bind.hpp"
#include "host/plugins/finder.hpp"
#include "host/solids/solids.hpp"
#include "sdl/parse.hpp"

namespace nicol::preview {

struct Loaded {
  std::unique_ptr<sdl::Result> parsed = std::make_unique<sdl::Result>();
  Scene scene;
  Geometry geometry;
};

// `name`: the file that the text stands for. Without geometry.
inline Loaded read(const std::string& text, const std::string& name = "test.pov") {
  Loaded loaded;
  sdl::Options options;
  for (const char* folder : {"/include", "/founding", "/gems", "/conical", "/plugins"})
    options.library_paths.push_back(std::string(SCENES_FOLDER) + folder);
  plugins::Finder plugins(plugins::places_of({}, {}, {PLUGINS_FOLDER}));
  BindOptions wanted;
  wanted.library_paths = options.library_paths;
  wanted.path = name;
  wanted.plugins = &plugins;
  sdl::parse_text(name, text, options, *loaded.parsed);
  loaded.scene = bind(loaded.parsed->document, wanted, loaded.parsed->diagnostics);
  CHECK_MESSAGE(!loaded.parsed->diagnostics.failed(), loaded.parsed->diagnostics.text());
  return loaded;
}

inline Loaded load(const std::string& text) {
  Loaded loaded = read(text);
  loaded.geometry = build_geometry(loaded.scene, loaded.parsed->diagnostics);
  CHECK_MESSAGE(!loaded.parsed->diagnostics.failed(), loaded.parsed->diagnostics.text());
  return loaded;
}

}  // namespace nicol::preview
