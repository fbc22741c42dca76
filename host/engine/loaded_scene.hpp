// A scene file taken through parser, bind, solids and features, with all its errors told at once.
#pragma once
#include <memory>
#include <string>

#include "host/engine/options.hpp"
#include "host/features.hpp"
#include "host/opencl/render.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"
#include "sdl/parse.hpp"

namespace nicol::engine {

struct LoadedScene {
  sdl::Result parsed;  // holds the sources that Locations point into
  Scene scene;
  Geometry geometry;
  Features features;
  std::string place(const Location& where) const;  // "scene.pov:12"
};

// Where the command line brings wavelengths of its own, a scene's expectations at others are not at
// issue.
enum class Expectations { where_they_apply, always };

// What reading came to: errors and warnings stand in loaded->parsed.diagnostics.
struct ReadScene {
  std::unique_ptr<LoadedScene> loaded;  // never null
  bool whole = false;                   // no errors: everything in it holds
  std::vector<std::string> files;       // that were read beside those of loaded->parsed.sources
};
ReadScene read_scene(const std::string& path, const SceneOptions& options,
                     Expectations expectations = Expectations::where_they_apply);

// Null if there was an error. told: takes what the diagnostics say. UsageError for wrong options.
std::unique_ptr<LoadedScene> load_scene(const std::string& path, const SceneOptions& options,
                                        Expectations expectations = Expectations::where_they_apply,
                                        std::string* told = nullptr);

// Scene, geometry and features, for settings of its own; without what was parsed.
std::unique_ptr<LoadedScene> working_copy(const LoadedScene& loaded);

// Where include files lie (folders that are named, then that of the scene's path, then the standard ones), what is declared, the
// size of the picture.
sdl::Options parse_options(const SceneOptions& options, const std::string& path = "");
void drop_expectations(sdl::Document& document);

KernelOptions kernel_options(const DeviceOptions& options);

// Opens the device that is asked for, and checks that it can do what is asked.
std::shared_ptr<Device> open_wanted_device(const DeviceOptions& options);
// UsageError where the device lacks it.
void check_precision(const Device& device, const DeviceOptions& options);

// From soft X-rays to 1 mm: beyond, no light is followed along rays.
inline constexpr double least_wavelength_nm = 1, most_wavelength_nm = 1e6;

// from:to:step or a list with commas, nm, ascending.
std::vector<double> parse_wavelengths(const std::string& text);

}  // namespace nicol::engine
