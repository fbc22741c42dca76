// `nicol explain`: which effects a scene calls for and why, what was left out, what the kernel cost
// to build.
#include <fmt/format.h>

#include "host/app/commands.hpp"
#include "host/app/media_table.hpp"
#include "host/app/told_scene.hpp"
#include "host/engine/explanation.hpp"

namespace nicol::app {
namespace {

void print_kernel(const ExplainCommand& command, const KernelContents& contents) {
  const auto device = open_wanted_device(command.device);
  const KernelOptions options = kernel_options(command.device);
  const BuildReport build = prepare_kernel(*device, contents, options);
  fmt::print("kernel for {}: {}\n  {} in {:.3f} s\n", info(*device).name, build.options,
             build.cached ? "loaded from the cache" : "built", build.seconds);
  if (!build.note.empty()) fmt::print("{}\n", build.note);
}

}  // namespace

int explain_command(const ExplainCommand& command) {
  if (command.media) return print_media(command);
  if (command.scene.empty()) throw UsageError("`nicol explain` takes a scene, or --media");
  const auto loaded = load_and_tell(command.scene, command.options);
  if (!loaded) return exit_error;
  fmt::print("{}", explanation(*loaded));
  if (!command.no_build) print_kernel(command, loaded->features.contents());
  return exit_done;
}

}  // namespace nicol::app
