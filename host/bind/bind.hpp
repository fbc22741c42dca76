// Tree to Scene: words get their meaning here, units and handedness are converted here (units.hpp).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/plugins/source.hpp"
#include "host/scene.hpp"
#include "sdl/diagnostics.hpp"
#include "sdl/tree.hpp"

namespace nicol {

// What the command line knows, or wants otherwise than the scene says.
struct BindOptions {
  int width = 640, height = 480;  // of the picture
  std::string path;               // of the scene, for Scene::path
  std::vector<std::string> library_paths;  // where gem cuts are looked for, as include files are
  std::vector<double> lambda_nm;  // empty: as the scene says
  std::optional<int> max_trace_level;
  std::optional<double> adc_bailout;
  std::optional<int> samples;
  std::optional<double> error, sample_error;  // see Settings
  std::optional<double> exposure;
  std::optional<bool> polarization;
  plugins::PluginSource* plugins = nullptr;  // formulas, spectra and solids that the scene asks for; null: none
  std::vector<std::string>* files_read = nullptr;  // takes the names of files that bind reads (gem cuts)
};

// All errors are collected in `diagnostics`; the Scene is whole only if none was added.
Scene bind(const sdl::Document& document, const BindOptions& options,
           sdl::Diagnostics& diagnostics);

// Every block and word that bind understands, as Markdown tables.
std::string vocabulary();

// A word of the language that #declare refuses, or an object's: no scene could use a number of that name. The words of a block
// (size, samples) may be declared, as in a scene.
bool is_reserved_word(const std::string& text);

}  // namespace nicol
