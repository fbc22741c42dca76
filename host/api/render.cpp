// Rendering and merging in the C interface, on the engine that the command line stands on.
#include <fmt/format.h>

#include <cmath>

#include "host/api/handles.hpp"
#include "host/engine/merged_picture.hpp"

namespace nicol::api {
namespace {

constexpr const char* made_by = "libnicol";

void check_flag(int32_t value, const char* name) { require(value == 0 || value == 1, fmt::format("{} must be 0 or 1, not {}", name, value)); }

// From `first` on `count` of `all`; count 0: none is said.
std::optional<engine::PixelRange> range(int32_t first, int32_t count, int32_t all, const char* what) {
  if (first == 0 && count == 0) return std::nullopt;
  require(first >= 0 && count >= 1 && count <= all - first,
          fmt::format("{} {} {}s from {} on are not in the picture of {}", "the", count, what, first, all));
  return engine::PixelRange{first, first + count - 1};
}

void take_device(const nicol_render_options& wanted, engine::DeviceOptions& device) {
  require(wanted.precision == NICOL_FLOAT || wanted.precision == NICOL_DOUBLE, fmt::format("there is no precision {}", wanted.precision));
  device.real = wanted.precision == NICOL_DOUBLE ? "double" : "float";
  require(wanted.lanes == 0 || wanted.lanes == 1 || wanted.lanes == 4 || wanted.lanes == 8 || wanted.lanes == 16,
          fmt::format("{} lanes: there are kernels for 1, 4, 8 and 16", wanted.lanes));
  device.lanes = wanted.lanes;
  device.generic = wanted.generic == 1;
  device.no_cache = wanted.no_cache == 1;
}

void take_share(const nicol_render_options& wanted, engine::PictureOptions& options) {
  if (wanted.part != 0 || wanted.part_count != 0) options.part = fmt::format("{}/{}", wanted.part, wanted.part_count);
  options.window.rows = range(wanted.first_row, wanted.row_count, options.options.height, "row");
  options.window.columns = range(wanted.first_column, wanted.column_count, options.options.width, "column");
  const double first_nm = wanted.first_wavelength_nm, last_nm = wanted.last_wavelength_nm;
  if (first_nm == 0 && last_nm == 0) return;
  require(std::isfinite(first_nm) && std::isfinite(last_nm), "the wavelengths of the part are no numbers");
  options.wavelength_part = fmt::format("{:.17g}..{:.17g}", first_nm, last_nm);
}

engine::PictureOptions options_of(const nicol_scene& scene, const nicol_render_options& wanted) {
  check_flag(wanted.generic, "generic");
  check_flag(wanted.no_cache, "no_cache");
  check_flag(wanted.resume, "resume");
  check_flag(wanted.want_error_bound, "want_error_bound");
  check_flag(wanted.want_error_budget, "want_error_budget");
  engine::PictureOptions options = scene.options;
  take_device(wanted, options.device);
  take_share(wanted, options);
  if (wanted.journal) options.journal = wanted.journal;
  require(wanted.resume == 0 || !options.journal.empty(), "resume takes a journal");
  options.resume = wanted.resume == 1;
  options.no_budget = wanted.want_error_budget == 0;
  options.error_bound = wanted.want_error_bound == 1;
  options.command_line = made_by;
  return options;
}

// The pixels of a tile as a picture of one row.
Frame row_of(const engine::TileView& view, double exposure) {
  Frame row;
  row.width = static_cast<int>(view.from.size());
  row.height = 1;
  row.exposure = exposure;
  const auto cut = [&](const std::vector<double>& values) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(view.wavelengths.first);
    return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(view.wavelengths.count));
  };
  row.lambda_nm = cut(view.frame.lambda_nm);
  row.weight_nm = cut(view.frame.weight_nm);
  row.stokes.resize(4 * row.lambda_nm.size() * row.plane());
  for (int s = 0; s < 4; ++s)
    for (std::size_t w = 0; w < row.lambda_nm.size(); ++w) {
      const float* from = view.frame.component(s, view.wavelengths.first + w);
      float* to = row.component(s, w);
      for (std::size_t i = 0; i < view.from.size(); ++i) to[i] = from[view.from[i]];
    }
  return row;
}

// One rendering: options, callbacks, and what came of it.
class Rendering {
 public:
  Rendering(const nicol_scene& scene, const nicol_render_options& wanted)
      : scene_(scene), wanted_(wanted), options_(options_of(scene, wanted)) {}

  nicol_status run(nicol_picture** handed_out) {
    auto loaded = engine::working_copy(*scene_.read.loaded);
    auto made = std::make_unique<nicol_picture>(const_cast<nicol_scene*>(&scene_));
    ask_cancel();
    if (callbacks_.stopped()) return callbacks_.status();
    refuse_budget_of_part(loaded->scene);
    const auto devices = scene_.context->open();
    for (const auto& device : devices) engine::check_precision(*device, options_.device);
    std::shared_ptr<Device> first = devices.front();
    engine::PictureHooks calls = hooks();
    calls.also.assign(devices.begin() + 1, devices.end());
    made->picture = engine::make_picture(loaded, options_, first, calls);
    made->samples = loaded->scene.settings.sample_error > 0 ? 0 : loaded->scene.settings.samples;
    finish(*made);
    if (!made->picture.nothing()) *handed_out = made.release();
    return callbacks_.status();
  }

 private:
  void refuse_budget_of_part(const Scene& scene) const {
    if (options_.no_budget) return;
    const engine::PictureShare share = engine::choose_share(options_, {}, scene);
    require(share.whole(), fmt::format("want_error_budget does not go with a part of a picture ({}): it is of the whole picture", share.name));
  }

  void ask_cancel() {
    if (wanted_.cancel) callbacks_.ask([&] { return wanted_.cancel(wanted_.user); });
  }

  engine::PictureHooks hooks() {
    engine::PictureHooks hooks;
    hooks.cancel = &callbacks_.stopped();
    hooks.stage = [this] { ask_cancel(); };
    hooks.message = [this](engine::Severity severity, const std::string& line) {
      scene_.context->tell(callbacks_, severity == engine::Severity::warning ? NICOL_WARNING : NICOL_NOTE, line);
    };
    hooks.progress = [this](const Progress& now) {
      ask_cancel();
      if (wanted_.progress)
        callbacks_.ask([&] { return wanted_.progress(wanted_.user, now.fraction, now.seconds, now.seconds_left); });
    };
    if (wanted_.tile) hooks.tile = [this](const engine::TileView& view) { tell_tile(view); };
    return hooks;
  }

  void tell_tile(const engine::TileView& view) {
    if (callbacks_.stopped()) return;
    const Frame row = row_of(view, scene_.read.loaded->scene.settings.exposure);
    const std::vector<float> rgb = linear_rgb(row);
    nicol_tile tile{};
    tile.struct_size = sizeof tile;
    tile.width = options_.options.width;
    tile.height = options_.options.height;
    tile.pixel_count = view.to.size();
    tile.pixels = view.to.data();
    tile.wavelength_count = row.lambda_nm.size();
    tile.wavelengths_nm = row.lambda_nm.data();
    tile.stokes = row.stokes.data();
    tile.linear_srgb = rgb.data();
    callbacks_.ask([&] { return wanted_.tile(wanted_.user, &tile); });
  }

  void finish(nicol_picture& made) {
    engine::Picture& picture = made.picture;
    if (options_.error_bound && !picture.report.interrupted) made.bound = engine::error_bound(picture);
    if (picture.journal && !picture.report.interrupted) picture.journal->remove();
    picture.journal.reset();   // who goes on from it needs it, whatever becomes of this picture
  }

  const nicol_scene& scene_;
  const nicol_render_options wanted_;
  const engine::PictureOptions options_;
  Callbacks callbacks_;
};

}  // namespace
}  // namespace nicol::api

using namespace nicol;
using namespace nicol::api;

extern "C" {

nicol_status nicol_render(const nicol_scene* scene, const nicol_render_options* options, nicol_picture** picture) {
  return guarded([&] {
    require(picture, "picture");
    *picture = nullptr;
    require(scene, "scene");
    refuse_in_callback("nicol_render");
    if (!scene->read.whole) throw Failure(NICOL_ERROR_SCENE, "the scene has errors");
    const Held<nicol_scene> held(const_cast<nicol_scene*>(scene));
    return Rendering(*scene, taken(options, "nicol_render_options")).run(picture);
  });
}

nicol_status nicol_merge(nicol_context* context, const char* const* paths, size_t count, const nicol_merge_options* options,
                         nicol_picture** picture) {
  return guarded([&]() -> nicol_status {
    require(picture, "picture");
    *picture = nullptr;
    require(context, "context");
    require(paths && count > 0, "there are no parts to merge");
    refuse_in_callback("nicol_merge");
    const nicol_merge_options wanted = taken(options, "nicol_merge_options");
    check_flag(wanted.incomplete, "incomplete");
    std::vector<std::string> parts;
    for (size_t i = 0; i < count; ++i) {
      require(paths[i], "one of paths");
      parts.push_back(paths[i]);
    }
    engine::MergedPicture merged = engine::merge_parts(parts, wanted.incomplete == 1, made_by);
    const Held<nicol_context> held(context);
    Callbacks callbacks;
    for (const std::string& warning : merged.warnings) context->tell(callbacks, NICOL_WARNING, warning);
    if (!merged.missing.empty() && wanted.incomplete == 0) throw Failure(NICOL_ERROR_INPUT, "missing: " + merged.missing);
    if (!merged.missing.empty()) context->tell(callbacks, NICOL_WARNING, "missing: " + merged.missing);
    if (callbacks.stopped()) return callbacks.status();
    auto made = std::make_unique<nicol_picture>(nullptr);
    made->picture.frame = std::move(merged.frame);
    *picture = made.release();
    return NICOL_OK;
  });
}

}  // extern "C"
