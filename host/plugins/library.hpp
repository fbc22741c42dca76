// One shared object: loaded once, never unloaded, with what its entry nicol_plugin_v1 has registered.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "host/plugins/source.hpp"

struct nicol_picture_v1;

namespace nicol::plugins {

struct Importer : Entry {
  std::string suffix;                                           // ".gon"
  std::function<std::string(const std::string& path)> read;     // scene text
};
struct Sink : Entry {
  std::string suffix;
  std::function<void(const nicol_picture_v1& picture, const std::string& path)> write;
};

struct Library {
  std::string path;  // canonical
  std::vector<Dispersion> dispersions;
  std::vector<Spectrum> spectra;
  std::vector<Solid> solids;
  std::vector<Importer> importers;
  std::vector<Sink> sinks;
};

// The same object for the same file, whoever asks. PluginError, again and again, for one that could not be loaded.
const Library& load_library(const std::string& path);

// "goniometer" of "/usr/lib/nicol/plugins/goniometer.so"
std::string stem_of(const std::string& path);

}  // namespace nicol::plugins
