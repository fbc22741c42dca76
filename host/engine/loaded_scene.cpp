// See loaded_scene.hpp.
#include "host/engine/loaded_scene.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "host/bind/bind.hpp"
#include "host/crystal_rows.hpp"
#include "host/engine/plugins.hpp"
#include "host/fragments/scene_fragments.hpp"
#include "kernels/waves_kinds.h"

namespace nicol::engine {
namespace {

double parse_number(std::string_view text, const std::string& whole) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw UsageError(fmt::format("'{}' is not a number in '{}'", text, whole));
  return value;
}

}  // namespace

double parse_relative_error(const std::string& text) {
  const bool percent = !text.empty() && text.back() == '%';
  const double value = parse_number(percent ? std::string_view(text).substr(0, text.size() - 1) : text, text) / (percent ? 100 : 1);
  if (value > 0 && value < 1) return value;
  throw UsageError(fmt::format("the error '{}' must lie between 0 and 100 % (0.1% or 0.001)", text));
}

namespace {

std::vector<double> split_numbers(const std::string& text, char separator) {
  std::vector<double> numbers;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    numbers.push_back(parse_number(std::string_view(text).substr(from, to - from), text));
    if (to == text.size()) return numbers;
    from = to + 1;
  }
}

namespace fs = std::filesystem;

}  // namespace

std::string own_file() {
  std::error_code failed;
  Dl_info about{};
  const bool library = dladdr(reinterpret_cast<const void*>(&parse_relative_error), &about) != 0 && about.dli_fname &&
                       std::string_view(about.dli_fname).find(".so") != std::string_view::npos;
  return (library ? fs::canonical(about.dli_fname, failed) : fs::read_symlink("/proc/self/exe", failed)).string();
}

namespace {

// nicol's own include files, installed or beside the program or where it was built, and POV-Ray's where it is installed.
std::vector<std::string> standard_libraries() {
  std::error_code failed;
  std::vector<std::string> folders;
  constexpr int levels_up = 4;  // build/release/bin/nicol, usr/lib/x86_64-linux-gnu/libnicol.so
  fs::path above = fs::path(own_file()).parent_path();
  for (int i = 0; i < levels_up && folders.empty(); ++i, above = above.parent_path())
    for (const char* place : {"scenes/include", "share/nicol/include"})
      if (folders.empty() && fs::is_regular_file(above / place / "units.inc", failed)) folders.push_back((above / place).string());
  if (folders.empty()) folders.push_back(NICOL_INCLUDE_FOLDER);
  folders.push_back((fs::path(folders.front()).parent_path() / "plugins").string());
  folders.push_back("/usr/share/povray-3.7/include");
  return folders;
}

BindOptions bind_options(const std::string& path, const SceneOptions& options) {
  BindOptions result;
  result.library_paths = parse_options(options, path).library_paths;
  result.width = options.width;
  result.height = options.height;
  result.path = path;
  if (!options.wavelengths.empty()) result.lambda_nm = parse_wavelengths(options.wavelengths);
  result.max_trace_level = options.max_trace_level;
  result.adc_bailout = options.adc_bailout;
  result.samples = options.samples;
  result.error = options.error;
  result.sample_error = options.sample_error;
  if (!options.polarization.empty()) result.polarization = options.polarization == "on";
  return result;
}

// A polarizer's axis is told apart from e and f, which a crystal's waves do not have.
void refuse_polarizers_in_crystals(const Scene& scene, const Geometry& geometry, sdl::Diagnostics& diagnostics) {
  if (!scene.settings.polarization) return;
  for (const Sheet& sheet : geometry.sheets) {
    const Medium& around = scene.media[geometry.cells[sheet.cell].medium];
    const bool polarizes =
        sheet.polarizer >= 0 || (sheet.emission >= 0 && scene.emissions[sheet.emission].polarizer.has_value());
    if (waves_of(around) == WAVES_ISOTROPIC || !polarizes) continue;
    const Object& object = scene.objects[sheet.object];
    diagnostics.error(object.where, "this " + object.kind + " polarizes inside the crystal '" + around.name +
                                        "', where waves have polarizations of their own: give it a gap of an "
                                        "isotropic medium");
  }
}

}  // namespace

sdl::Options parse_options(const SceneOptions& options, const std::string& path) {
  sdl::Options result;
  result.library_paths = options.library_paths;
  if (fs::path(path).has_parent_path()) result.library_paths.push_back(fs::path(path).parent_path().string());
  for (std::string& folder : standard_libraries())
    result.library_paths.push_back(std::move(folder));
  for (const std::string& declare : options.declares) {
    const std::size_t equals = declare.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw UsageError(fmt::format("--declare takes name=value, not '{}'", declare));
    if (is_reserved_word(declare.substr(0, equals)))
      throw UsageError(fmt::format("'{}' is a word of the language: it cannot be declared", declare.substr(0, equals)));
    result.declares[declare.substr(0, equals)] =
        parse_number(std::string_view(declare).substr(equals + 1), declare);
  }
  result.include = options.include;
  result.debug = options.debug;
  const FrameClock& clock = options.clock;
  result.clock = clock.clock;
  result.clock_delta = clock.clock_delta;
  result.initial_clock = clock.initial_clock;
  result.final_clock = clock.final_clock;
  result.frame_number = clock.frame_number;
  result.initial_frame = clock.initial_frame;
  result.final_frame = clock.final_frame;
  result.image_width = options.width;
  result.image_height = options.height;
  return result;
}

void drop_expectations(sdl::Document& document) {
  const auto expects = [](const sdl::Item& item) {
    return item.block() && item.block()->name == "expect";
  };
  auto& items = document.items;
  items.erase(std::remove_if(items.begin(), items.end(), expects), items.end());
}

namespace {

void check_range(double nm, const std::string& text) {
  if (nm >= least_wavelength_nm && nm <= most_wavelength_nm) return;
  throw UsageError(fmt::format("wavelengths {}: {:g} nm is not between {:g} and {:.0f} nm", text, nm, least_wavelength_nm,
                               most_wavelength_nm));
}

}  // namespace

std::vector<double> parse_wavelengths(const std::string& text) {
  if (text.find(':') == std::string::npos) {
    std::vector<double> list = split_numbers(text, ',');
    std::sort(list.begin(), list.end());
    check_range(list.front(), text);
    check_range(list.back(), text);
    if (std::adjacent_find(list.begin(), list.end()) != list.end())
      throw UsageError(fmt::format("wavelengths {}: a wavelength stands there twice", text));
    return list;
  }
  const std::vector<double> range = split_numbers(text, ':');
  constexpr double most = 10000;
  if (range.size() != 3 || !(range[2] > 0) || !(range[1] >= range[0]))
    throw UsageError(fmt::format(
        "wavelengths are told as from:to:step in nm (400:700:10) or as a list, not '{}'", text));
  check_range(range[0], text);
  check_range(range[1], text);
  const double steps =
      std::floor((range[1] - range[0]) / range[2] + 1e-9);  // 1e-9: 0.1 is no binary number
  if (steps >= most)
    throw UsageError(fmt::format("wavelengths {}: more than {} wavelengths", text, most));
  std::vector<double> lambda_nm;
  for (int i = 0; i <= static_cast<int>(steps); ++i) lambda_nm.push_back(range[0] + i * range[2]);
  return lambda_nm;
}

std::string LoadedScene::place(const Location& where) const {
  return fmt::format("{}:{}", parsed.sources.name(where.file), where.line);
}

namespace {

// The scene's text: handed in, made by a plugin's importer from a file with its suffix, or the file itself.
void parse(const std::string& path, const SceneOptions& options, plugins::Finder& finder, const sdl::Options& sdl_options,
           sdl::Result& parsed) {
  if (options.text) return sdl::parse_text(path, *options.text, sdl_options, parsed);
  try {
    const plugins::Importer* importer = finder.importer(fs::path(path).extension().string());
    if (!importer) return sdl::parse_file(path, sdl_options, parsed);
    sdl::parse_text(path, importer->read(path), sdl_options, parsed);
  } catch (const plugins::PluginError& error) {
    sdl::parse_text(path, "", sdl_options, parsed);
    parsed.diagnostics.error({0, 1, 1, 0}, error.what());
  }
}

}  // namespace

ReadScene read_scene(const std::string& path, const SceneOptions& options, Expectations expectations) {
  const sdl::Options sdl_options = parse_options(options, path);
  BindOptions wanted = bind_options(path, options);
  ReadScene read;
  wanted.files_read = &read.files;
  read.loaded = std::make_unique<LoadedScene>();
  LoadedScene& loaded = *read.loaded;
  sdl::Diagnostics& diagnostics = loaded.parsed.diagnostics;
  load_plugins(options);
  plugins::Finder finder = plugin_finder(options);
  wanted.plugins = &finder;
  parse(path, options, finder, sdl_options, loaded.parsed);
  if (!wanted.lambda_nm.empty() && expectations == Expectations::where_they_apply)
    drop_expectations(loaded.parsed.document);
  if (!loaded.parsed.document.items.empty() || !diagnostics.failed())
    loaded.scene = bind(loaded.parsed.document, wanted, diagnostics);
  if (!diagnostics.failed()) {
    loaded.geometry = build_geometry(loaded.scene, diagnostics);
    refuse_polarizers_in_crystals(loaded.scene, loaded.geometry, diagnostics);
    refuse_surfaces(loaded.scene, loaded.geometry, diagnostics);
    for (FragmentUse& use : loaded.scene.fragments) use.place = loaded.place(use.where);
  }
  read.whole = !diagnostics.failed();
  if (read.whole) loaded.features = decide_features(loaded.scene, loaded.geometry);
  return read;
}

std::unique_ptr<LoadedScene> load_scene(const std::string& path, const SceneOptions& options,
                                        Expectations expectations, std::string* told) {
  ReadScene read = read_scene(path, options, expectations);
  if (told) *told = read.loaded->parsed.diagnostics.text();
  if (!read.whole) return nullptr;
  return std::move(read.loaded);
}

std::unique_ptr<LoadedScene> working_copy(const LoadedScene& loaded) {
  auto copy = std::make_unique<LoadedScene>();
  copy->scene = loaded.scene;
  copy->geometry = loaded.geometry;
  copy->features = loaded.features;
  return copy;
}

KernelOptions kernel_options(const DeviceOptions& options) {
  KernelOptions result;
  result.real_double = options.real == "double";
  result.lanes = options.lanes;
  result.generic = options.generic;
  result.binary_cache = !options.no_cache;
  return result;
}

std::shared_ptr<Device> open_wanted_device(const DeviceOptions& options) {
  std::shared_ptr<Device> device = open_device(options.device);
  check_precision(*device, options);
  return device;
}

void check_precision(const Device& device, const DeviceOptions& options) {
  if (options.real == "double" && !info(device).has_fp64)
    throw UsageError(fmt::format("{} has no double precision; use float", info(device).name));
}

}  // namespace nicol::engine
