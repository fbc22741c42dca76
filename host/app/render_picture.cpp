// See render_picture.hpp.
#include "host/app/render_picture.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "host/engine/error_budget.hpp"
#include "host/app/interrupt.hpp"
#include "host/engine/kept_error.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/engine/picture_share.hpp"
#include "host/app/progress_bar.hpp"
#include "host/engine/render_summary.hpp"
#include "host/output/error_map.hpp"
#include "host/output/journal.hpp"
#include "host/pack.hpp"

namespace nicol::app {
namespace {

struct Target {
  std::string path;
  std::unique_ptr<FrameSink> sink;
};

// The sinks come first: a picture that cannot be written is not worth its rendering.
std::vector<Target> make_targets(const RenderCommand& command) {
  std::vector<Target> targets;
  for (std::string& path : outputs_of(command)) {
    auto sink = make_sink(path);
    targets.push_back({std::move(path), std::move(sink)});
  }
  return targets;
}

void check_memory(const LoadedScene& loaded, const SceneOptions& options, const PictureShare& share) {
  const std::size_t wavelengths = share.wavelengths.count > 0 ? share.wavelengths.count : loaded.scene.lambda_nm.size();
  const double components = 4;
  const double bytes = components * sizeof(float) *
                       static_cast<double>(wavelengths) * options.width *
                       options.height;
  const double machine_bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr double bytes_per_gb = 1e9;
  if (machine_bytes > 0 && bytes > machine_bytes)
    throw UsageError(fmt::format(
        "a picture of {}x{} pixels and {} wavelengths takes {:.1f} GB; this machine has {:.1f}",
        options.width, options.height, wavelengths, bytes / bytes_per_gb,
        machine_bytes / bytes_per_gb));
}

// A render under way: what it needs and what came of it.
struct Job {
  std::shared_ptr<Device> device;
  RenderOptions options;
  PictureShare share, rendered;              // what is wanted; with it what lanes hold beside that
  PackedScene packed;
  std::vector<double> lambda_nm, weight_nm;  // that are rendered
  std::unique_ptr<Journal> journal;
  Frame frame;
  RenderReport report;
  ErrorBudget budget;
};

// Everything is bound, and every effect decided, for the whole scene; then what is not in the share is left out.
void pack_share(const LoadedScene& loaded, const RenderCommand& command, Job& job) {
  const Scene& scene = loaded.scene;
  const int lanes = lanes_on(*job.device, job.options.kernel), width = command.options.width, height = command.options.height;
  if (job.share.wavelengths.count == 0) job.share.wavelengths = {0, scene.lambda_nm.size()};
  job.packed = pack(scene, loaded.geometry, loaded.features.mask, width, height, lanes);
  job.rendered = whole_lanes(job.share, job.packed, scene.lambda_nm.size(), lanes);
  const WavelengthRange only = job.rendered.wavelengths;
  if (only.count < scene.lambda_nm.size())
    job.packed = pack(scene, loaded.geometry, loaded.features.mask, width, height, lanes, 0, only);
  const auto cut = [&](const std::vector<double>& values) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(only.first);
    return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(only.count));
  };
  job.lambda_nm = cut(scene.lambda_nm);
  job.weight_nm = cut(scene.weight_nm);
  job.options.pixels = job.rendered.pixels;
  job.options.channel_cut_off = job.share.wavelengths.count < scene.lambda_nm.size();
}

void prepare(const LoadedScene& loaded, const RenderCommand& command, const std::vector<Target>& targets, Job& job) {
  const Settings& settings = loaded.scene.settings;
  job.options.samples = settings.samples;
  job.options.sample_error = settings.sample_error;
  pack_share(loaded, command, job);
  std::string note;
  job.journal = Journal::open(journal_path(targets.front().path),
                              render_identity(*job.device, job.packed, job.lambda_nm, job.options), command.resume, note);
  job.options.journal = job.journal.get();
  if (!note.empty()) fmt::print(stderr, "nicol: {}\n", note);
}

void render_loaded(const LoadedScene& loaded, const RenderCommand& command, const std::vector<Target>& targets,
                   const RenderTools& tools, Job& job) {
  ProgressBar bar(!command.quiet);
  job.options.progress = [&](const Progress& progress) {
    if (tools.frames) bar.show(progress_of_frames(progress, *tools.frames, tools.start), frames_text(*tools.frames));
    else bar.show(progress);
  };
  try {
    job.frame = render(*job.device, job.packed, job.lambda_nm, job.weight_nm, job.options, job.report);
  } catch (const DeviceError& error) {
    bar.clear();
    throw DeviceError(fmt::format("{}\nWhat was finished after the first seconds is kept in {}: --continue goes on from there",
                                  error.what(), journal_path(targets.front().path)));
  }
  bar.clear();
  if (command.resume && !command.quiet)
    fmt::print(stderr, "nicol: {} tiles were there, {} were rendered\n", job.report.tiles_found, job.report.tiles);
  if (!job.journal->note().empty()) fmt::print(stderr, "nicol: {}\n", job.journal->note());
  job.options.progress = nullptr;
  job.frame.exposure = loaded.scene.settings.exposure;
}

// A part: of full size, and with what it belongs to.
void make_part_of(const LoadedScene& loaded, const RenderCommand& command, Job& job) {
  const int width = command.options.width, height = command.options.height;
  const std::vector<std::int32_t>& pixels = job.share.pixels;
  std::vector<float> wanted(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), pixels.empty() ? 1.0f : 0.0f);
  for (const std::int32_t p : pixels) wanted[static_cast<std::size_t>(p)] = 1;
  const WavelengthRange wavelengths = job.share.wavelengths;
  if (!pixels.empty() || wavelengths.count < job.lambda_nm.size()) {
    std::vector<std::int32_t> rendered = job.rendered.pixels;
    for (std::int32_t p = 0; rendered.size() < wanted.size() && pixels.empty(); ++p) rendered.push_back(p);
    job.frame = cut_out(job.frame, rendered, wanted, width, height, wavelengths.first - job.rendered.wavelengths.first, wavelengths.count);
  }
  const RenderReport& report = job.report;
  PartNote part;
  part.whole = whole_picture(loaded, command);
  part.name = job.share.name;
  part.device = fmt::format("{} ({}, {} lanes)", report.device, info(*job.device).driver, report.lanes);
  part.seconds = report.seconds;
  part.counted = {report.nan_count, report.energy_count, report.stack_count, report.stokes_count, report.fallback_count};
  part.checksum = make_part(job.frame, wanted);
  for (auto& note : notes_of_part(part)) job.frame.how.push_back(std::move(note));
}

// The error budget, into the picture's notes.
void look_into_errors(const LoadedScene& loaded, const RenderCommand& command, Job& job) {
  if (command.no_budget || job.report.interrupted || !job.share.whole()) return;
  job.budget = error_budget(loaded, command.options.width, command.options.height, *job.device, job.options, job.frame,
                            job.report);
  for (auto& note : budget_notes(job.budget)) job.frame.how.push_back(std::move(note));
}

void write_map(const LoadedScene& loaded, const RenderCommand& command, const Job& job) {
  if (command.error_map.empty()) return;
  double rounding = 0;
  for (const BudgetLine& line : job.budget.lines)
    if (line.source == "rounding" && std::isfinite(line.rms)) rounding = line.rms * job.report.mean_radiance;
  make_sink(command.error_map)
      ->write(error_map(job.frame, job.frame.sample_error, brightest_radiance(loaded.scene), rounding,
                        job.report.mean_radiance));
}

// Every picture is tried, so that one full disk does not cost the others.
int write_all(const std::vector<Target>& targets, const Frame& frame) {
  int code = exit_done;
  for (const Target& target : targets) {
    try {
      target.sink->write(frame);
    } catch (const OutputError& error) {
      fmt::print(stderr, "nicol: {}\n", error.what());
      code = exit_error;
    }
  }
  return code;
}

void tell(const std::vector<Target>& targets, const Job& job, bool one_of_many) {
  const Frame& frame = job.frame;
  if (one_of_many) {
    fmt::print(stderr, "{}: {:.2f} s\n", targets.front().path, job.report.seconds);
    return;
  }
  fmt::print(stderr, "{}", summary_text(frame, job.report));
  if (!job.share.whole())
    fmt::print(stderr, "part: {}; {} of {} pixels\n", job.share.name,
               job.share.pixels.empty() ? frame.plane() : job.share.pixels.size(), frame.plane());
  for (const Target& target : targets) {
    const std::string suffix = std::filesystem::path(target.path).extension().string();
    if (suffix != ".png" && suffix != ".PNG") continue;
    const std::size_t clipped = clipped_pixels(frame);
    fmt::print(stderr, "{}: {} pixels clipped ({:.1f} %)\n", target.path, clipped,
               100.0 * static_cast<double>(clipped) / static_cast<double>(frame.plane()));
  }
}

int finish_interrupted(const std::vector<Target>& targets, const Job& job, bool one_of_many) {
  const Frame& frame = job.frame;
  if (one_of_many) return exit_interrupted;
  const auto rows = std::count_if(frame.row_done.begin(), frame.row_done.end(),
                                  [](unsigned char d) { return d != 0; });
  const std::string more =
      job.report.seconds > job.options.journal_after_seconds ? "; --continue goes on from here" : "";
  if (rows == 0 || !job.share.whole()) {
    fmt::print(stderr, "nicol: interrupted {}; nothing written{}\n", rows == 0 ? "before the first rows" : "in a part of a picture", more);
    return exit_interrupted;
  }
  if (write_all(targets, frame) != exit_done) return exit_error;
  if (rows == frame.height)
    fmt::print(stderr, "nicol: interrupted while samples were added where they matter; sampling error {:.2g} %{}\n",
               100 * job.report.sample_error, more);
  else
    fmt::print(stderr, "nicol: interrupted; {} of {} rows are in the picture{}\n", rows, frame.height, more);
  return exit_interrupted;
}

void tell_kept(const ChosenSettings& chosen, double error, const Job& job) {
  const bool kept = chosen.reachable && job.report.sample_error_kept && !(job.budget.rms > error);
  fmt::print(stderr, "error {:g} %: {} with {} (chosen in {:.2f} s)\n", 100 * error, kept ? "kept" : "NOT KEPT", chosen.text,
             chosen.seconds);
  if (!chosen.reason.empty()) fmt::print(stderr, "nicol: {}\n", chosen.reason);
}

}  // namespace

std::vector<std::string> outputs_of(const RenderCommand& command) {
  if (!command.outputs.empty()) return command.outputs;
  return {std::filesystem::path(command.scene).stem().string() + ".png"};
}

std::string journal_path(const std::string& output) { return output + ".part"; }

int render_picture(const RenderCommand& command, RenderTools& tools) {
  const std::vector<Target> targets = make_targets(command);
  if (!command.error_map.empty()) make_sink(command.error_map);
  auto loaded = load_scene(command.scene, command.options, Expectations::where_they_apply, &tools.told);
  if (!loaded) return exit_error;
  Job job;
  job.share = choose_share(command, outputs_of(command), loaded->scene);
  check_memory(*loaded, command.options, job.share);
  const std::atomic<bool>& cancel = finish_first();
  if (!tools.device) tools.device = open_wanted_device(command.device);
  job.device = tools.device;
  job.options.kernel = kernel_options(command.device);
  job.options.cancel = &cancel;
  const double error = loaded->scene.settings.error;
  ChosenSettings chosen;
  if (error > 0) {
    chosen = choose_settings(loaded, command, *job.device, error, cancel);
    job.options.kernel.real_double = chosen.real_double;
  }
  if (!command.error_map.empty()) loaded->features.mask |= path_signatures_bit();
  prepare(*loaded, command, targets, job);
  render_loaded(*loaded, command, targets, tools, job);
  const bool one_of_many = tools.frames.has_value();
  job.frame.how = how_made(*loaded, command, job.report);
  if (error > 0) job.frame.how.emplace_back("chosen", fmt::format("for an error of {:g} %: {}", 100 * error, chosen.text));
  fmt::print(stderr, "{}", counter_warnings(job.report));
  if (job.report.interrupted) return finish_interrupted(targets, job, one_of_many);
  look_into_errors(*loaded, command, job);
  if (!job.share.whole()) make_part_of(*loaded, command, job);
  const int code = write_all(targets, job.frame);
  if (code == exit_done) job.journal->remove();  // else --continue writes the picture without rendering it again
  write_map(*loaded, command, job);
  if (!command.quiet) {
    tell(targets, job, one_of_many);
    if (!command.no_budget && job.share.whole()) fmt::print(stderr, "{}", budget_text(job.budget));
  }
  if (error > 0 && !(command.quiet && chosen.reachable)) tell_kept(chosen, error, job);
  return code;
}

}  // namespace nicol::app
