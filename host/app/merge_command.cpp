// `nicol merge`: parts of a picture to the whole.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "host/app/commands.hpp"
#include "host/engine/merged_picture.hpp"

namespace nicol::app {

int merge_command(const MergeCommand& command) {
  std::vector<std::unique_ptr<FrameSink>> sinks;
  for (const std::string& path : command.outputs) sinks.push_back(make_sink(path));
  for (const std::string& output : command.outputs)
    for (const std::string& part : command.parts) {
      std::error_code none;
      if (std::filesystem::equivalent(output, part, none)) throw UsageError(fmt::format("{} is one of the parts: the whole takes another name", output));
    }
  const auto start = std::chrono::steady_clock::now();
  const MergedPicture merged = merge_parts(command.parts, command.incomplete, command.command_line);
  for (const std::string& warning : merged.warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (!merged.missing.empty()) {
    fmt::print(stderr, "nicol: missing: {}\n", merged.missing);
    if (!command.incomplete) {
      fmt::print(stderr, "nicol: nothing written; --incomplete writes what there is\n");
      return exit_error;
    }
  }
  const Frame& frame = merged.frame;
  for (const auto& sink : sinks) sink->write(frame);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!command.quiet)
    fmt::print(stderr, "{}: {} parts, {}x{} pixels, {} wavelengths; merged in {:.2f} s\n", command.outputs.front(), merged.parts,
               frame.width, frame.height, frame.lambda_nm.size(), taken.count());
  return exit_done;
}

}  // namespace nicol::app
