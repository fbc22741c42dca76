// `nicol render`: scene file to pictures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "host/app/commands.hpp"
#include "host/app/interrupt.hpp"
#include "host/app/loaded_scene.hpp"
#include "host/app/progress_bar.hpp"
#include "host/app/render_summary.hpp"
#include "host/output/frame.hpp"
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

Frame render_loaded(const LoadedScene& loaded, const RenderCommand& command,
                    const std::atomic<bool>& cancel, RenderReport& report) {
  const auto device = open_wanted_device(command.device);
  RenderOptions options;
  options.kernel = kernel_options(command.device);
  options.samples = loaded.scene.settings.samples;
  options.sample_error = loaded.scene.settings.sample_error;
  options.cancel = &cancel;
  ProgressBar bar(!command.quiet);
  options.progress = [&](const Progress& progress) { bar.show(progress); };
  const PackedScene packed =
      pack(loaded.scene, loaded.geometry, loaded.features.mask, command.options.width,
           command.options.height, lanes_on(*device, options.kernel));
  Frame frame =
      render(*device, packed, loaded.scene.lambda_nm, loaded.scene.weight_nm, options, report);
  frame.exposure = loaded.scene.settings.exposure;
  frame.how = how_made(loaded, command, report);
  return frame;
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

void tell(const std::vector<Target>& targets, const Frame& frame, const RenderReport& report,
          int samples) {
  fmt::print(stderr, "{}", summary_text(frame, report, samples));
  for (const Target& target : targets) {
    const std::string suffix = std::filesystem::path(target.path).extension().string();
    if (suffix != ".png" && suffix != ".PNG") continue;
    const std::size_t clipped = clipped_pixels(frame);
    fmt::print(stderr, "{}: {} pixels clipped ({:.1f} %)\n", target.path, clipped,
               100.0 * static_cast<double>(clipped) / static_cast<double>(frame.plane()));
  }
}

int finish_interrupted(const std::vector<Target>& targets, const Frame& frame) {
  const auto rows = std::count_if(frame.row_done.begin(), frame.row_done.end(),
                                  [](unsigned char d) { return d != 0; });
  if (rows == 0) {
    fmt::print(stderr, "nicol: interrupted before the first rows; nothing written\n");
    return exit_interrupted;
  }
  if (write_all(targets, frame) != exit_done) return exit_error;
  fmt::print(stderr, "nicol: interrupted; {} of {} rows are in the picture\n", rows, frame.height);
  return exit_interrupted;
}

}  // namespace

int render_command(const RenderCommand& command) {
  const std::vector<Target> targets = make_targets(command);
  const auto loaded = load_scene(command.scene, command.options);
  if (!loaded) return exit_error;
  check_memory(*loaded, command.options);
  RenderReport report;
  const Frame frame = render_loaded(*loaded, command, finish_first(), report);
  fmt::print(stderr, "{}", counter_warnings(report));
  if (report.interrupted) return finish_interrupted(targets, frame);
  const int code = write_all(targets, frame);
  if (!command.quiet) tell(targets, frame, report, loaded->scene.settings.samples);
  return code;
}

}  // namespace nicol::app
