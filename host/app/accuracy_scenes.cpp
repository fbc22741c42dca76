// See accuracy_scenes.hpp.
#include "host/app/accuracy_scenes.hpp"

#include <fmt/format.h>

#include "host/bind/bind.hpp"
#include "host/effects.hpp"
#include "host/engine/plugins.hpp"

namespace nicol::app {

AccuracySetting base_setting(const Scene& scene, bool real_double) {
  AccuracySetting base;
  base.lambda_nm = scene.lambda_nm;
  base.max_trace_level = scene.settings.max_trace_level;
  base.adc_bailout = scene.settings.adc_bailout;
  base.samples = scene.settings.samples;
  base.sample_error = scene.settings.sample_error;
  base.real_double = real_double;
  return base;
}

const AccuracyScenes::Bound& AccuracyScenes::bound_at(const std::vector<double>& lambda_nm) {
  const auto known = bound_.find(lambda_nm);
  if (known != bound_.end()) return known->second;
  BindOptions wanted;
  wanted.library_paths = parse_options(options_).library_paths;
  wanted.width = options_.width;
  wanted.height = options_.height;
  wanted.path = loaded_.scene.path;
  wanted.lambda_nm = lambda_nm;
  plugins::Finder finder = plugin_finder(options_);
  wanted.plugins = &finder;
  wanted.polarization = loaded_.scene.settings.polarization;
  sdl::Document document = loaded_.parsed.document;
  drop_expectations(document);
  sdl::Diagnostics diagnostics(loaded_.parsed.sources);
  Bound bound;
  bound.scene = bind(document, wanted, diagnostics);
  if (!diagnostics.failed()) bound.geometry = build_geometry(bound.scene, diagnostics);
  if (diagnostics.failed())
    throw UsageError(fmt::format("the scene does not fit the wavelengths {}:\n{}", wavelengths_text(lambda_nm),
                                 diagnostics.text()));
  return bound_.emplace(lambda_nm, std::move(bound)).first->second;
}

AccuracyScene AccuracyScenes::at(const AccuracySetting& setting) {
  const bool as_loaded = setting.lambda_nm == loaded_.scene.lambda_nm;
  AccuracyScene made;
  made.scene = as_loaded ? loaded_.scene : bound_at(setting.lambda_nm).scene;
  made.geometry = as_loaded ? &loaded_.geometry : &bound_at(setting.lambda_nm).geometry;
  Settings& settings = made.scene.settings;
  settings.max_trace_level = setting.max_trace_level;
  settings.adc_bailout = setting.adc_bailout;
  settings.samples = setting.samples;
  settings.error = 0;
  settings.sample_error = setting.sample_error;
  if (!setting.without.empty()) made.scene = without_effect(made.scene, setting.without);
  made.features = decide_features(made.scene, *made.geometry);
  return made;
}

}  // namespace nicol::app
