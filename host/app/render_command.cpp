// `nicol render`: scene file to pictures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "host/app/commands.hpp"
#include "host/app/error_budget.hpp"
#include "host/app/interrupt.hpp"
#include "host/app/kept_error.hpp"
#include "host/app/loaded_scene.hpp"
#include "host/app/progress_bar.hpp"
#include "host/app/render_summary.hpp"
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
  std::vector<std::string> paths = command.outputs;
  if (paths.empty()) paths.push_back(std::filesystem::path(command.scene).stem().string() + ".png");
  std::vector<Target> targets;
  for (std::string& path : paths) {
    auto sink = make_sink(path);
    targets.push_back({std::move(path), std::move(sink)});
  }
  return targets;
}

void check_memory(const LoadedScene& loaded, const SceneOptions& options) {
  const double components = 4;
  const double bytes = components * sizeof(float) *
                       static_cast<double>(loaded.scene.lambda_nm.size()) * options.width *
                       options.height;
  const double machine_bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr double bytes_per_gb = 1e9;
  if (machine_bytes > 0 && bytes > machine_bytes)
    throw UsageError(fmt::format(
        "a picture of {}x{} pixels and {} wavelengths takes {:.1f} GB; this machine has {:.1f}",
        options.width, options.height, loaded.scene.lambda_nm.size(), bytes / bytes_per_gb,
        machine_bytes / bytes_per_gb));
}

// The finished tiles lie beside the first picture.
std::string journal_path(const std::vector<Target>& targets) { return targets.front().path + ".part"; }

// A render under way: what it needs and what came of it.
struct Job {
  std::shared_ptr<Device> device;
  RenderOptions options;
  PackedScene packed;
  std::unique_ptr<Journal> journal;
  Frame frame;
  RenderReport report;
  ErrorBudget budget;
};

void prepare(const LoadedScene& loaded, const RenderCommand& command, const std::vector<Target>& targets, Job& job) {
  const Settings& settings = loaded.scene.settings;
  job.options.samples = settings.samples;
  job.options.sample_error = settings.sample_error;
  job.packed = pack(loaded.scene, loaded.geometry, loaded.features.mask, command.options.width, command.options.height,
                    lanes_on(*job.device, job.options.kernel));
  std::string note;
  job.journal = Journal::open(journal_path(targets),
                              render_identity(*job.device, job.packed, loaded.scene.lambda_nm, job.options),
                              command.resume, note);
  job.options.journal = job.journal.get();
  if (!note.empty()) fmt::print(stderr, "nicol: {}\n", note);
}

void render_loaded(const LoadedScene& loaded, const RenderCommand& command, const std::vector<Target>& targets,
                   Job& job) {
  ProgressBar bar(!command.quiet);
  job.options.progress = [&](const Progress& progress) { bar.show(progress); };
  try {
    job.frame = render(*job.device, job.packed, loaded.scene.lambda_nm, loaded.scene.weight_nm, job.options, job.report);
  } catch (const DeviceError& error) {
    bar.clear();
    throw DeviceError(fmt::format("{}\nWhat was finished after the first seconds is kept in {}: --continue goes on from there",
                                  error.what(), journal_path(targets)));
  }
  bar.clear();
  if (command.resume && !command.quiet)
    fmt::print(stderr, "nicol: {} tiles were there, {} were rendered\n", job.report.tiles_found, job.report.tiles);
  if (!job.journal->note().empty()) fmt::print(stderr, "nicol: {}\n", job.journal->note());
  job.options.progress = nullptr;
  job.frame.exposure = loaded.scene.settings.exposure;
}

// The error budget, into the picture's notes.
void look_into_errors(const LoadedScene& loaded, const RenderCommand& command, Job& job) {
  if (command.no_budget || job.report.interrupted) return;
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

void tell(const std::vector<Target>& targets, const Frame& frame, const RenderReport& report) {
  fmt::print(stderr, "{}", summary_text(frame, report));
  for (const Target& target : targets) {
    const std::string suffix = std::filesystem::path(target.path).extension().string();
    if (suffix != ".png" && suffix != ".PNG") continue;
    const std::size_t clipped = clipped_pixels(frame);
    fmt::print(stderr, "{}: {} pixels clipped ({:.1f} %)\n", target.path, clipped,
               100.0 * static_cast<double>(clipped) / static_cast<double>(frame.plane()));
  }
}

int finish_interrupted(const std::vector<Target>& targets, const Job& job) {
  const Frame& frame = job.frame;
  const auto rows = std::count_if(frame.row_done.begin(), frame.row_done.end(),
                                  [](unsigned char d) { return d != 0; });
  const std::string more =
      job.report.seconds > job.options.journal_after_seconds ? "; --continue goes on from here" : "";
  if (rows == 0) {
    fmt::print(stderr, "nicol: interrupted before the first rows; nothing written{}\n", more);
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

int render_command(const RenderCommand& command) {
  const std::vector<Target> targets = make_targets(command);
  if (!command.error_map.empty()) make_sink(command.error_map);
  auto loaded = load_scene(command.scene, command.options);
  if (!loaded) return exit_error;
  check_memory(*loaded, command.options);
  const std::atomic<bool>& cancel = finish_first();
  Job job;
  job.device = open_wanted_device(command.device);
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
  render_loaded(*loaded, command, targets, job);
  job.frame.how = how_made(*loaded, command, job.report);
  if (error > 0) job.frame.how.emplace_back("chosen", fmt::format("for an error of {:g} %: {}", 100 * error, chosen.text));
  fmt::print(stderr, "{}", counter_warnings(job.report));
  if (job.report.interrupted) return finish_interrupted(targets, job);
  look_into_errors(*loaded, command, job);
  const int code = write_all(targets, job.frame);
  if (code == exit_done) job.journal->remove();  // else --continue writes the picture without rendering it again
  write_map(*loaded, command, job);
  if (!command.quiet) {
    tell(targets, job.frame, job.report);
    if (!command.no_budget) fmt::print(stderr, "{}", budget_text(job.budget));
  }
  if (error > 0 && !(command.quiet && chosen.reachable)) tell_kept(chosen, error, job);
  return code;
}

}  // namespace nicol::app
