// See picture.hpp.
#include "host/engine/picture.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "host/channels.hpp"
#include "host/engine/render_summary.hpp"
#include "host/opencl/fragment_check.hpp"
#include "host/output/error_map.hpp"
#include "host/pack.hpp"

namespace nicol::engine {
namespace {

void check_memory(const LoadedScene& loaded, const SceneOptions& options, const PictureShare& share) {
  const std::size_t wavelengths = share.wavelengths.count > 0 ? share.wavelengths.count : loaded.scene.lambda_nm.size();
  const double components = 4;
  const double bytes = components * sizeof(float) * static_cast<double>(wavelengths) * options.width * options.height;
  const double machine_bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr double bytes_per_gb = 1e9;
  if (machine_bytes > 0 && bytes > machine_bytes)
    throw UsageError(fmt::format("a picture of {}x{} pixels and {} wavelengths takes {:.1f} GB; this machine has {:.1f}",
                                 options.width, options.height, wavelengths, bytes / bytes_per_gb, machine_bytes / bytes_per_gb));
}

// A picture in the making.
class Making {
 public:
  Making(const PictureOptions& wanted, const PictureHooks& hooks) : wanted_(wanted), hooks_(hooks) {}

  Picture run(std::unique_ptr<LoadedScene>& scene, std::shared_ptr<Device>& device) {
    picture_.share = choose_share(wanted_, wanted_.outputs, scene->scene);
    check_memory(*scene, wanted_.options, picture_.share);
    if (device) check_precision(*device, wanted_.device);
    else device = open_wanted_device(wanted_.device);
    options_.kernel = kernel_options(wanted_.device);
    options_.cancel = hooks_.cancel ? hooks_.cancel : &never_;
    whole_ = whole_picture(*scene, wanted_);
    choose(scene, *device);
    if (wanted_.wants_error_bound()) scene->features.mask |= path_signatures_bit();
    prepare(*scene, *device);
    render_prepared(*scene, *device);
    tell_notes(*scene);
    if (picture_.report.interrupted) return std::move(picture_);
    look_into_errors(*scene, *device);
    if (!picture_.share.whole()) make_part_of(*device);
    else for (auto& note : notes_of_whole(whole_)) picture_.frame.how.push_back(std::move(note));
    return std::move(picture_);
  }

 private:
  void note(const std::string& text) const {
    if (hooks_.message && !text.empty()) hooks_.message(Severity::note, text);
  }

  void begin_stage() const {
    if (hooks_.stage) hooks_.stage();
  }

  void choose(std::unique_ptr<LoadedScene>& scene, Device& device) {
    picture_.error = scene->scene.settings.error;
    if (!(picture_.error > 0)) return;
    begin_stage();
    picture_.chosen = choose_settings(scene, wanted_, device, picture_.error, *options_.cancel);
    options_.kernel.real_double = picture_.chosen->real_double;
  }

  // Everything is bound, and every effect decided, for the whole scene; then what is not in the share is left out.
  void pack_share(const LoadedScene& loaded, const Device& device) {
    const Scene& scene = loaded.scene;
    PictureShare& share = picture_.share;
    const int lanes = lanes_on(device, options_.kernel), width = wanted_.options.width, height = wanted_.options.height;
    if (share.wavelengths.count == 0) share.wavelengths = {0, scene.lambda_nm.size()};
    packed_ = pack(scene, loaded.geometry, loaded.features.mask, width, height, lanes);
    rendered_ = whole_lanes(share, packed_, scene.lambda_nm.size(), lanes);
    const WavelengthRange only = rendered_.wavelengths;
    if (only.count < scene.lambda_nm.size())
      packed_ = pack(scene, loaded.geometry, loaded.features.mask, width, height, lanes, 0, only);
    const auto cut = [&](const std::vector<double>& values) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(only.first);
      return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(only.count));
    };
    lambda_nm_ = cut(scene.lambda_nm);
    weight_nm_ = cut(scene.weight_nm);
    options_.pixels = rendered_.pixels;
    options_.channel_cut_off = share.wavelengths.count < scene.lambda_nm.size();
  }

  void prepare(const LoadedScene& loaded, const Device& device) {
    const Settings& settings = loaded.scene.settings;
    options_.samples = settings.samples;
    options_.sample_error = settings.sample_error;
    picture_.brightest = brightest_radiance(loaded.scene);
    pack_share(loaded, device);
    if (wanted_.journal.empty()) return;
    std::string told;
    picture_.journal = Journal::open(wanted_.journal, render_identity(device, packed_, lambda_nm_, options_), wanted_.resume, told);
    options_.journal = picture_.journal.get();
    options_.journal_after_seconds = wanted_.keep_after_s;
    if (picture_.journal->note().empty()) note(told);
    tell_obstacle();
  }

  // Once, why no tiles are kept.
  void tell_obstacle() {
    const std::string obstacle = picture_.journal->note();
    if (hooks_.message && obstacle != told_obstacle_) hooks_.message(Severity::warning, obstacle);
    told_obstacle_ = obstacle;
  }

  // Of a frame that is a row of the pixels rendered, back to the picture.
  void tell_tile(const Frame& frame, const std::int32_t* pixels, std::size_t count) const {
    const PictureShare& share = picture_.share;
    TileView view{frame, {}, {}, {share.wavelengths.first - rendered_.wavelengths.first, share.wavelengths.count}};
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t at = rendered_.pixels.empty() ? pixels[i] : rendered_.pixels[static_cast<std::size_t>(pixels[i])];
      if (!share.pixels.empty() && !std::binary_search(share.pixels.begin(), share.pixels.end(), at)) continue;
      view.from.push_back(pixels[i]);
      view.to.push_back(at);
    }
    if (!view.to.empty()) hooks_.tile(view);
  }

  void render_prepared(const LoadedScene& loaded, Device& device) {
    begin_stage();
    options_.progress = hooks_.progress;
    options_.also = hooks_.also;
    options_.others = hooks_.others;
    options_.only_others = hooks_.only_others;
    if (hooks_.tile)
      options_.tile = [this](const Frame& frame, const std::int32_t* pixels, std::size_t count) { tell_tile(frame, pixels, count); };
    try {
      picture_.frame = render(device, packed_, lambda_nm_, weight_nm_, options_, picture_.report);
    } catch (const FragmentError&) {
      throw;
    } catch (const DeviceError& error) {
      throw RenderFailure(error.what());
    }
    options_.progress = nullptr;
    options_.tile = nullptr;
    picture_.journal_used = picture_.journal && picture_.report.seconds > options_.journal_after_seconds;
    picture_.frame.exposure = loaded.scene.settings.exposure;
    if (!picture_.journal) return;
    if (wanted_.resume && wanted_.tell_resumed && told_obstacle_.empty())
      note(fmt::format("{} tiles were there, {} were rendered", picture_.report.tiles_found, picture_.report.tiles));
    tell_obstacle();
  }

  void tell_notes(const LoadedScene& loaded) {
    Frame& frame = picture_.frame;
    frame.how = how_made(loaded, wanted_, picture_.report);
    if (picture_.chosen)
      frame.how.emplace_back("chosen", fmt::format("for an error of {:g} %: {}", 100 * picture_.error, picture_.chosen->text));
    if (hooks_.message)
      for (const std::string& line : picture_.report.notes) hooks_.message(Severity::warning, line);
    if (hooks_.message)
      for (const std::string& line : counter_warnings(picture_.report)) hooks_.message(Severity::warning, line);
  }

  // The error budget, into the picture's notes.
  void look_into_errors(const LoadedScene& loaded, Device& device) {
    if (wanted_.no_budget || !picture_.share.whole()) return;
    begin_stage();
    picture_.budget = error_budget(loaded, wanted_.options.width, wanted_.options.height, device, options_, picture_.frame,
                                   picture_.report);
    for (auto& note : budget_notes(picture_.budget)) picture_.frame.how.push_back(std::move(note));
  }

  // A part: of full size, and with what it belongs to.
  void make_part_of(const Device& device) {
    const int width = wanted_.options.width, height = wanted_.options.height;
    const std::vector<std::int32_t>& pixels = picture_.share.pixels;
    std::vector<float> wanted(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), pixels.empty() ? 1.0f : 0.0f);
    for (const std::int32_t p : pixels) wanted[static_cast<std::size_t>(p)] = 1;
    const WavelengthRange wavelengths = picture_.share.wavelengths;
    Frame& frame = picture_.frame;
    if (!pixels.empty() || wavelengths.count < lambda_nm_.size()) {
      std::vector<std::int32_t> rendered = rendered_.pixels;
      for (std::int32_t p = 0; rendered.size() < wanted.size() && pixels.empty(); ++p) rendered.push_back(p);
      frame = cut_out(frame, rendered, wanted, width, height, wavelengths.first - rendered_.wavelengths.first, wavelengths.count);
    }
    const RenderReport& report = picture_.report;
    PartNote part;
    part.whole = whole_;
    part.name = picture_.share.name;
    part.device = fmt::format("{} ({}, {} lanes)", report.device, info(device).driver, report.lanes);
    part.seconds = report.seconds;
    part.counted = {report.nan_count, report.energy_count, report.stack_count, report.stokes_count, report.fallback_count};
    part.checksum = make_part(frame, wanted);
    for (auto& note : notes_of_part(part)) frame.how.push_back(std::move(note));
  }

  const PictureOptions& wanted_;
  const PictureHooks& hooks_;
  const std::atomic<bool> never_{false};
  RenderOptions options_;
  WholePicture whole_;                         // as the scene and the options ask for it
  PictureShare rendered_;                      // what is wanted, and what lanes hold beside that
  PackedScene packed_;
  std::vector<double> lambda_nm_, weight_nm_;  // that are rendered
  std::string told_obstacle_;
  Picture picture_;
};

}  // namespace

std::size_t Picture::rows_done() const {
  return static_cast<std::size_t>(
      std::count_if(frame.row_done.begin(), frame.row_done.end(), [](unsigned char done) { return done != 0; }));
}

Picture make_picture(std::unique_ptr<LoadedScene>& scene, const PictureOptions& options, std::shared_ptr<Device>& device,
                     const PictureHooks& hooks) {
  return Making(options, hooks).run(scene, device);
}

Frame error_bound(const Picture& picture) {
  double rounding = 0;
  for (const BudgetLine& line : picture.budget.lines)
    if (line.source == "rounding" && std::isfinite(line.rms)) rounding = line.rms * picture.report.mean_radiance;
  return error_map(picture.frame, picture.frame.sample_error, picture.brightest, rounding, picture.report.mean_radiance);
}

}  // namespace nicol::engine
