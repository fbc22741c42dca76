// See render_picture.hpp.
#include "host/app/render_picture.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "host/app/interrupt.hpp"
#include "host/app/progress_bar.hpp"
#include "host/app/there_already.hpp"
#include "host/app/told_scene.hpp"
#include "host/engine/picture.hpp"
#include "host/engine/plugins.hpp"
#include "host/engine/render_summary.hpp"
#include "host/mpi/ranks.hpp"

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

PictureOptions options_of(const RenderCommand& command, const std::vector<Target>& targets, bool resume) {
  PictureOptions options = command;
  options.resume = resume;
  options.outputs = outputs_of(command);
  options.journal = journal_path(targets.front().path);
  options.tell_resumed = !command.quiet;
  return options;
}

// Those that --device names; of ranks on one machine each takes one of them.
void open_wanted(const RenderCommand& command, RenderTools& tools) {
  if (tools.device) return;
  const std::string& wanted = command.device.device;
  auto devices = command.ranks ? std::vector{open_device(device_of_rank(wanted, command.ranks->on_node()))} : open_devices(wanted);
  for (const auto& device : devices) check_precision(*device, command.device);
  tools.device = devices.front();
  tools.also.assign(devices.begin() + 1, devices.end());
}

// With a bar that lines which tell something do not run into.
Picture make_with_bar(const RenderCommand& command, const std::vector<Target>& targets, bool resume,
                      std::unique_ptr<LoadedScene>& loaded, RenderTools& tools) {
  ProgressBar bar(!command.quiet);
  PictureHooks hooks;
  hooks.cancel = &interrupt_flag();
  hooks.also = tools.also;
  if (command.ranks) hooks.others = &command.ranks->others(command.device.device);
  hooks.only_others = command.first_rank_idle;
  hooks.progress = [&](const Progress& progress) {
    finish_first();   // while kernels are built and fragments checked, which may take for ever, nothing is worth to wait for
    if (tools.frames) bar.show(progress_of_frames(progress, *tools.frames, tools.start), frames_text(*tools.frames));
    else bar.show(progress);
  };
  hooks.message = [&](Severity severity, const std::string& line) {
    bar.clear();
    fmt::print(stderr, "{}: {}\n", severity == Severity::warning ? "warning" : "nicol", line);
  };
  try {
    return make_picture(loaded, options_of(command, targets, resume), tools.device, hooks);
  } catch (const RenderFailure& error) {
    const std::string kept = journal_path(targets.front().path);
    std::error_code failed;
    if (!std::filesystem::exists(kept, failed)) throw;
    throw DeviceError(fmt::format("{}\nWhat was finished after the first seconds is kept in {}: --continue goes on from there",
                                  error.what(), kept));
  }
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

void tell(const std::vector<Target>& targets, const Picture& picture, bool one_of_many) {
  const Frame& frame = picture.frame;
  if (one_of_many) {
    fmt::print(stderr, "{}: {:.2f} s\n", targets.front().path, picture.report.seconds);
    return;
  }
  fmt::print(stderr, "{}", summary_text(frame, picture.report));
  if (!picture.share.whole())
    fmt::print(stderr, "part: {}; {} of {} pixels\n", picture.share.name,
               picture.share.pixels.empty() ? frame.plane() : picture.share.pixels.size(), frame.plane());
  for (const Target& target : targets) {
    const std::string suffix = std::filesystem::path(target.path).extension().string();
    if (suffix != ".png" && suffix != ".PNG") continue;
    const std::size_t clipped = clipped_pixels(frame);
    fmt::print(stderr, "{}: {} pixels clipped ({:.1f} %)\n", target.path, clipped,
               100.0 * static_cast<double>(clipped) / static_cast<double>(frame.plane()));
  }
}

int finish_interrupted(const std::vector<Target>& targets, const Picture& picture, bool one_of_many) {
  if (one_of_many) return exit_interrupted;
  const int rows = static_cast<int>(picture.rows_done());
  const std::string more = picture.journal_used ? "; --continue goes on from here" : "";
  if (picture.nothing()) {
    fmt::print(stderr, "nicol: interrupted {}; nothing written{}\n", rows == 0 ? "before the first rows" : "in a part of a picture", more);
    return exit_interrupted;
  }
  if (write_all(targets, picture.frame) != exit_done) return exit_error;
  if (rows == picture.frame.height)
    fmt::print(stderr, "nicol: interrupted while samples were added where they matter; sampling error {:.2g} %{}\n",
               100 * picture.report.sample_error, more);
  else
    fmt::print(stderr, "nicol: interrupted; {} of {} rows are in the picture{}\n", rows, picture.frame.height, more);
  return exit_interrupted;
}

void tell_kept(const Picture& picture) {
  const ChosenSettings& chosen = *picture.chosen;
  fmt::print(stderr, "error {:g} %: {} with {} (chosen in {:.2f} s)\n", 100 * picture.error, picture.error_kept() ? "kept" : "NOT KEPT",
             chosen.text, chosen.seconds);
  if (!chosen.reason.empty()) fmt::print(stderr, "nicol: {}\n", chosen.reason);
}

}  // namespace

std::vector<std::string> outputs_of(const RenderCommand& command) {
  if (!command.outputs.empty()) return command.outputs;
  return {std::filesystem::path(command.scene).stem().string() + ".png"};
}

std::string journal_path(const std::string& output) { return output + ".part"; }

int render_picture(const RenderCommand& command, RenderTools& tools) {
  load_plugins(command.options);  // their sinks come before the outputs
  const std::vector<Target> targets = make_targets(command);
  if (!command.error_map.empty()) make_sink(command.error_map);
  auto loaded = load_and_tell(command.scene, command.options, Expectations::where_they_apply, &tools.told);
  if (!loaded) return exit_error;
  const bool one_of_many = tools.frames.has_value();
  const Found found = command.resume ? find_what_is_there(command, outputs_of(command), *loaded) : Found{};
  tools.was_there = found.picture;
  if (found.picture && !one_of_many && !command.quiet) fmt::print(stderr, "{} is there already\n", targets.front().path);
  if (found.picture) return exit_done;
  open_wanted(command, tools);
  const bool resume = found.tiles || (command.resume && !one_of_many && !found.another);
  const Picture picture = make_with_bar(command, targets, resume, loaded, tools);
  if (picture.report.interrupted) return finish_interrupted(targets, picture, one_of_many);
  const int code = write_all(targets, picture.frame);
  if (code == exit_done) picture.journal->remove();  // else --continue writes the picture without rendering it again
  if (!command.error_map.empty()) make_sink(command.error_map)->write(error_bound(picture));
  if (!command.quiet) {
    tell(targets, picture, one_of_many);
    if (!command.no_budget && picture.share.whole()) fmt::print(stderr, "{}", budget_text(picture.budget));
  }
  if (picture.chosen && !(command.quiet && picture.chosen->reachable)) tell_kept(picture);
  return code;
}

}  // namespace nicol::app
