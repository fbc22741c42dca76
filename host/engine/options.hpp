// What may be asked of a picture: of its scene, its device, and what of it is rendered and written.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace nicol::engine {

// What the user did wrong, told in full.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Where in an animation a picture stands, as the scene sees it.
struct FrameClock {
  double clock = 0, clock_delta = 0, initial_clock = 0, final_clock = 0;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
};

// What may be said of a scene beside its text.
struct SceneOptions {
  int width = 512, height = 512;
  std::vector<std::string> library_paths;
  std::vector<std::string> plugins;   // shared objects that are loaded: files, or names to be looked for
  std::vector<std::string> declares;  // name=value
  std::string wavelengths;  // from:to:step in nm, or a list with commas; empty: the scene's
  std::optional<int> samples;
  std::optional<double> error, sample_error;  // see Settings
  std::optional<int> max_trace_level;
  std::optional<double> adc_bailout;
  std::string polarization;  // on, off; empty: the scene's
  FrameClock clock;
  std::shared_ptr<const std::string> text;  // the scene's, in place of its file's; null: the file's
  // sdl::Options: texts in place of include files, and what takes what #debug prints.
  std::function<std::optional<std::string>(const std::string& name)> include;
  std::function<void(const std::string&)> debug;
};

struct DeviceOptions {
  std::string device;  // index or part of the name; empty: the default
  std::string real = "float";
  int lanes = 0;
  bool generic = false;
  bool no_cache = false;
};

// "0.1%" or "0.001": greater than 0, less than 1. UsageError otherwise.
double parse_relative_error(const std::string& text);

// 0-based, inclusive.
struct PixelRange {
  int first = 0, last = 0;
};

// POV-Ray's partial output: numbers above 1 are pixels, from 1 on and inclusive, those up to 1 parts of the picture.
struct WindowOptions {
  std::optional<double> start_row, end_row, start_column, end_column;
  std::optional<PixelRange> rows, columns;  // in place of these
};

struct PictureOptions {
  std::string scene;                 // its file, or what its text is called
  std::vector<std::string> outputs;
  SceneOptions options;
  DeviceOptions device;
  std::string journal;          // where finished tiles are kept; "": nowhere
  bool resume = false;          // from the tiles that an unfinished run has kept there
  double keep_after_s = 3;      // tiles of the first seconds are not worth keeping
  bool tell_resumed = true;     // how many they were
  bool no_budget = false;
  std::string part;             // i/n: this share of the picture's pixels; "": all
  std::string wavelength_part;  // a..b in nm: those of the scene's wavelengths; "": all
  WindowOptions window;
  std::string error_map;        // where what each pixel may be off by is written; "": nowhere
  bool error_bound = false;     // that is wanted, written or not
  std::string command_line;     // for the picture's header
  bool wants_error_bound() const { return error_bound || !error_map.empty(); }
};

const char* version();

}  // namespace nicol::engine
