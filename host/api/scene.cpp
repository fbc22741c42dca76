// Scenes of the C interface: reading, diagnostics, explanation.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <new>
#include <set>

#include "host/api/handles.hpp"
#include "host/engine/explanation.hpp"

namespace nicol::api {

std::optional<std::string> IncludeTexts::text_of(const std::string& name) {
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  if (!callbacks || !include) return std::nullopt;
  nicol_include answer;
  if (!callbacks->ask([&] { return include(user, name.c_str(), &answer); })) return std::nullopt;
  return known[name] = std::move(answer.text);
}

void IncludeTexts::debug(const std::string& text) const {
  if (callbacks) context->tell(*callbacks, NICOL_NOTE, text);
}

namespace {

// 17 digits bring every double back.
std::string exact(double value) { return fmt::format("{:.17g}", value); }

void check_switch(nicol_switch value, const char* name) {
  require(value == NICOL_AS_IN_SCENE || value == NICOL_ON || value == NICOL_OFF, fmt::format("{} is no nicol_switch: {}", name, value));
}

double checked_error(double value, const char* name) {
  require(value > 0 && value < 1, fmt::format("{} must lie between 0 and 1, not {:g}", name, value));
  return value;
}

// Letters, digits and _, not beginning with a digit: as POV-Ray's identifiers.
bool is_identifier(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 && std::all_of(name.begin(), name.end(), fits);
}

void take_names(const nicol_scene_options& wanted, const nicol_context& context, engine::SceneOptions& options) {
  require(wanted.library_path_count == 0 || wanted.library_paths, "library_paths is NULL");
  for (uint32_t i = 0; i < wanted.library_path_count; ++i) {
    require(wanted.library_paths[i], "one of library_paths");
    options.library_paths.push_back(wanted.library_paths[i]);
  }
  options.library_paths.insert(options.library_paths.end(), context.library_paths.begin(), context.library_paths.end());
  require(wanted.declare_count == 0 || (wanted.declare_names && wanted.declare_values), "declare_names or declare_values is NULL");
  for (size_t i = 0; i < wanted.declare_count; ++i) {
    require(wanted.declare_names[i], "one of declare_names");
    const std::string name = wanted.declare_names[i];
    require(is_identifier(name), fmt::format("'{}' is no name to declare", name));
    require(std::isfinite(wanted.declare_values[i]), fmt::format("the value of '{}' is no number", name));
    options.declares.push_back(name + "=" + exact(wanted.declare_values[i]));
  }
  require(wanted.wavelength_count == 0 || wanted.wavelengths_nm, "wavelengths_nm is NULL");
  for (size_t i = 0; i < wanted.wavelength_count; ++i) {
    const double nm = wanted.wavelengths_nm[i];
    require(nm >= engine::least_wavelength_nm && nm <= engine::most_wavelength_nm,
            fmt::format("wavelengths_nm: {:g} to {:.0f}, not {:g}", engine::least_wavelength_nm, engine::most_wavelength_nm, nm));
    options.wavelengths += (i > 0 ? "," : "") + exact(nm);
  }
}

void take_clock(const nicol_scene_options& wanted, engine::FrameClock& clock) {
  for (const double value : {wanted.clock, wanted.clock_delta, wanted.initial_clock, wanted.final_clock})
    require(std::isfinite(value), "a clock is no number");
  require(0 <= wanted.initial_frame && wanted.initial_frame <= wanted.final_frame,
          fmt::format("there are no frames {} to {}", wanted.initial_frame, wanted.final_frame));
  require(wanted.initial_frame <= wanted.frame_number && wanted.frame_number <= wanted.final_frame,
          fmt::format("frame_number {} is none of the frames {} to {}", wanted.frame_number, wanted.initial_frame, wanted.final_frame));
  clock.frame_number = wanted.frame_number;
  clock.initial_frame = wanted.initial_frame;
  clock.final_frame = wanted.final_frame;
  clock.clock = wanted.clock;
  clock.clock_delta = wanted.clock_delta;
  clock.initial_clock = wanted.initial_clock;
  clock.final_clock = wanted.final_clock;
}

engine::SceneOptions options_of(const nicol_scene_options& wanted, const nicol_context& context) {
  constexpr int most_pixels = 65536, most_samples = 65536, most_levels = 4096;
  engine::SceneOptions options;
  take_names(wanted, context, options);
  for (const auto& [given, taken, name] : {std::tuple{wanted.width, &options.width, "width"}, {wanted.height, &options.height, "height"}}) {
    require(given >= 0 && given <= most_pixels, fmt::format("{} must lie between 1 and {}, not {}", name, most_pixels, given));
    if (given > 0) *taken = given;
  }
  require(wanted.samples >= 0 && wanted.samples <= most_samples, fmt::format("samples: 1 to {}, not {}", most_samples, wanted.samples));
  if (wanted.samples > 0) options.samples = wanted.samples;
  require(wanted.max_trace_level >= 0 && wanted.max_trace_level <= most_levels,
          fmt::format("max_trace_level: 1 to {}, not {}", most_levels, wanted.max_trace_level));
  if (wanted.max_trace_level > 0) options.max_trace_level = wanted.max_trace_level;
  if (wanted.error != 0) options.error = checked_error(wanted.error, "error");
  if (wanted.sample_error != 0) options.sample_error = checked_error(wanted.sample_error, "sample_error");
  require(wanted.adc_bailout >= 0 && wanted.adc_bailout <= 1, fmt::format("adc_bailout: 0 to 1, not {:g}", wanted.adc_bailout));
  if (wanted.adc_bailout > 0) options.adc_bailout = wanted.adc_bailout;
  check_switch(wanted.polarization, "polarization");
  if (wanted.polarization != NICOL_AS_IN_SCENE) options.polarization = wanted.polarization == NICOL_ON ? "on" : "off";
  take_clock(wanted, options.clock);
  return options;
}

nicol_severity severity_of(sdl::Severity severity) {
  switch (severity) {
    case sdl::Severity::note: return NICOL_NOTE;
    case sdl::Severity::warning: return NICOL_WARNING;
    case sdl::Severity::error: break;
  }
  return NICOL_ERROR;
}

// What there is to tell of it, as texts that stay.
void describe(nicol_scene& scene) {
  const sdl::Sources& sources = scene.read.loaded->parsed.sources;
  const sdl::Diagnostics& diagnostics = scene.read.loaded->parsed.diagnostics;
  for (const sdl::Diagnostic& d : diagnostics.all())
    scene.diagnostics.push_back({severity_of(d.severity), sources.name(d.where.file), d.message, diagnostics.text(d), d.where.line,
                                 d.where.column});
  std::set<std::string> known;
  const auto add = [&](const std::string& path) {
    if (known.insert(path).second) scene.files.push_back(path);
  };
  for (std::uint32_t i = 0; sources.name(i) != "?"; ++i) add(sources.name(i));
  for (const std::string& path : scene.read.files) add(path);
  if (scene.read.whole) scene.explanation = engine::explanation(*scene.read.loaded);
}

bool cannot_be_opened(const nicol_scene& scene) {
  const auto& diagnostics = scene.diagnostics;
  return !scene.options.options.text && !diagnostics.empty() &&
         diagnostics.front().message.rfind("Cannot open input file.", 0) == 0;
}

// That is no fault of the scene, though the parser tells it as one.
bool lacked_memory(const nicol_scene& scene) {
  return std::any_of(scene.diagnostics.begin(), scene.diagnostics.end(), [](const DiagnosticText& d) {
    return d.message.rfind("Out of memory.", 0) == 0 && d.message.find(std::bad_alloc().what()) != std::string::npos;
  });
}

nicol_status load(nicol_context* context, const char* name, const std::string* text, const nicol_scene_options* options,
                  nicol_scene** handed_out) {
  refuse_in_callback("nicol_scene_load");
  const nicol_scene_options wanted = taken(options, "nicol_scene_options");
  auto scene = std::make_unique<nicol_scene>(context);
  scene->options.scene = name;
  engine::SceneOptions& how = scene->options.options;
  how = options_of(wanted, *context);
  how.plugins = context->plugins();
  if (text) how.text = std::make_shared<const std::string>(*text);
  Callbacks callbacks;
  IncludeTexts& includes = scene->includes;
  includes.include = wanted.include;
  includes.user = wanted.user;
  includes.context = context;
  includes.callbacks = &callbacks;
  how.include = [&includes](const std::string& file) { return includes.text_of(file); };
  how.debug = [&includes](const std::string& line) { includes.debug(line); };
  scene->read = engine::read_scene(name, how);
  includes.callbacks = nullptr;
  if (const nicol_status stopped = callbacks.status(); stopped != NICOL_OK) return stopped;
  describe(*scene);
  if (lacked_memory(*scene)) throw std::bad_alloc();
  if (cannot_be_opened(*scene)) throw Failure(NICOL_ERROR_INPUT, scene->diagnostics.front().text);
  const bool whole = scene->read.whole;
  const std::string told = whole ? "" : scene->read.loaded->parsed.diagnostics.text();
  *handed_out = scene.release();
  return whole ? NICOL_OK : fail(NICOL_ERROR_SCENE, told.c_str());
}

const nicol_scene& whole(const nicol_scene* scene) {
  require(scene, "scene");
  if (!scene->read.whole) throw Failure(NICOL_ERROR_SCENE, "the scene has errors");
  return *scene;
}

}  // namespace
}  // namespace nicol::api

using namespace nicol;
using namespace nicol::api;

extern "C" {

nicol_status nicol_include_set_text(nicol_include* include, const char* text, size_t size) {
  return guarded([&] {
    require(include, "include");
    require(text || size == 0, "text is NULL");
    include->text = size > 0 ? std::string(text, size) : std::string();
    return NICOL_OK;
  });
}

nicol_status nicol_scene_load_file(nicol_context* context, const char* path, const nicol_scene_options* options, nicol_scene** scene) {
  return guarded([&] {
    require(scene, "scene");
    *scene = nullptr;
    require(context, "context");
    require(path, "path");
    return load(context, path, nullptr, options, scene);
  });
}

nicol_status nicol_scene_load_text(nicol_context* context, const char* name, const char* text, size_t size,
                                   const nicol_scene_options* options, nicol_scene** scene) {
  return guarded([&] {
    require(scene, "scene");
    *scene = nullptr;
    require(context, "context");
    require(name, "name");
    require(text || size == 0, "text is NULL");
    const std::string taken_text = size > 0 ? std::string(text, size) : std::string();
    return load(context, name, &taken_text, options, scene);
  });
}

nicol_scene* nicol_scene_retain(nicol_scene* scene) { return retained(scene); }
void nicol_scene_release(nicol_scene* scene) { released(scene); }

int nicol_scene_is_whole(const nicol_scene* scene) { return scene && scene->read.whole ? 1 : 0; }

size_t nicol_scene_diagnostic_count(const nicol_scene* scene) { return scene ? scene->diagnostics.size() : 0; }

nicol_status nicol_scene_diagnostic(const nicol_scene* scene, size_t index, nicol_diagnostic* diagnostic) {
  return guarded([&] {
    require(scene, "scene");
    require(index < scene->diagnostics.size(), fmt::format("there is no diagnostic {}", index));
    const DiagnosticText& d = scene->diagnostics[index];
    give(nicol_diagnostic{0, d.severity, d.file.c_str(), d.line, d.column, d.message.c_str(), d.text.c_str()}, diagnostic, "diagnostic");
    return NICOL_OK;
  });
}

size_t nicol_scene_file_count(const nicol_scene* scene) { return scene ? scene->files.size() : 0; }

nicol_status nicol_scene_file(const nicol_scene* scene, size_t index, const char** path) {
  return guarded([&] {
    require(path, "path");
    *path = nullptr;
    require(scene, "scene");
    require(index < scene->files.size(), fmt::format("there is no file {}", index));
    *path = scene->files[index].c_str();
    return NICOL_OK;
  });
}

size_t nicol_scene_feature_count(const nicol_scene* scene) {
  return scene && scene->read.whole ? scene->read.loaded->features.rows.size() : 0;
}

nicol_status nicol_scene_feature(const nicol_scene* scene, size_t index, nicol_feature* feature) {
  return guarded([&] {
    const auto& rows = whole(scene).read.loaded->features.rows;
    require(index < rows.size(), fmt::format("there is no feature {}", index));
    const FeatureReason& row = rows[index];
    give(nicol_feature{0, row.on ? 1 : 0, row.name.c_str(), row.meaning.c_str(), row.reason.c_str()}, feature, "feature");
    return NICOL_OK;
  });
}

nicol_status nicol_scene_explanation(const nicol_scene* scene, const char** text) {
  return guarded([&] {
    require(text, "text");
    *text = nullptr;
    *text = whole(scene).explanation.c_str();
    return NICOL_OK;
  });
}

nicol_status nicol_scene_size(const nicol_scene* scene, int32_t* width, int32_t* height) {
  return guarded([&] {
    require(scene, "scene");
    require(width, "width");
    require(height, "height");
    *width = scene->options.options.width;
    *height = scene->options.options.height;
    return NICOL_OK;
  });
}

nicol_status nicol_scene_wavelengths(const nicol_scene* scene, const double** wavelengths_nm, size_t* count) {
  return guarded([&] {
    require(wavelengths_nm, "wavelengths_nm");
    require(count, "count");
    *wavelengths_nm = nullptr;
    *count = 0;
    const auto& lambda_nm = whole(scene).read.loaded->scene.lambda_nm;
    *wavelengths_nm = lambda_nm.data();
    *count = lambda_nm.size();
    return NICOL_OK;
  });
}

}  // extern "C"
