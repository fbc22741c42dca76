// `nicol explain`: which effects a scene calls for and why, what was left out, what the kernel cost
// to build.
#include <fmt/format.h>

#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/app/media_table.hpp"

namespace nicol::app {
namespace {

void print_features(const Features& features, bool on) {
  std::size_t name_width = 0;
  for (const FeatureReason& row : features.rows) name_width = std::max(name_width, row.name.size());
  for (const FeatureReason& row : features.rows)
    if (row.on == on)
      fmt::print("  {:<{}}  {}\n  {:<{}}    {}\n", row.name, name_width, row.meaning, "",
                 name_width, row.reason);
}

void print_geometry(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  const Geometry& geometry = loaded.geometry;
  fmt::print("{}: {} objects, {} cells, {} faces, {} contacts, {} sheets\n", scene.path,
             scene.objects.size(), geometry.cells.size(), geometry.faces.size(),
             geometry.patches.size(), geometry.sheets.size());
  fmt::print("{} wavelengths, {:g} to {:g} nm\n", scene.lambda_nm.size(), scene.lambda_nm.front(),
             scene.lambda_nm.back());
}

void print_kernel(const ExplainCommand& command, std::uint32_t mask) {
  const auto device = open_wanted_device(command.device);
  const KernelOptions options = kernel_options(command.device);
  const BuildReport build = prepare_kernel(*device, mask, options);
  fmt::print("kernel for {}: {}\n  {} in {:.3f} s\n", info(*device).name, build.options,
             build.cached ? "loaded from the cache" : "built", build.seconds);
}

}  // namespace

int explain_command(const ExplainCommand& command) {
  if (command.media) return print_media(command);
  if (command.scene.empty()) throw UsageError("`nicol explain` takes a scene, or --media");
  const auto loaded = load_scene(command.scene, command.options);
  if (!loaded) return exit_error;
  print_geometry(*loaded);
  fmt::print("called for (mask {:#07x}):\n", loaded->features.mask);
  print_features(loaded->features, true);
  fmt::print("left out:\n");
  print_features(loaded->features, false);
  if (!command.no_build) print_kernel(command, loaded->features.mask);
  return exit_done;
}

}  // namespace nicol::app
