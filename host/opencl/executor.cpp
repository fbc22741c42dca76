// Opens the executors of a render.
#include "host/opencl/executor.hpp"

#include <fmt/format.h>

#include "host/opencl/device_executor.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/fragment_check.hpp"

namespace nicol {
std::unique_ptr<TileExecutor> open_executor(Device& device, const PackedScene& scene, const RenderOptions& options, BuildReport& build) {
  try {
    const auto kernel = trace_kernel(device, scene.contents(), options.kernel);
    build = kernel->report;
    return std::make_unique<DeviceExecutor>(device, scene, options, kernel, lanes_on(device, options.kernel));
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
}

std::vector<std::unique_ptr<TileExecutor>> open_executors(Device& device, const PackedScene& scene, const RenderOptions& options,
                                                          RenderReport& report) {
  std::vector<std::unique_ptr<TileExecutor>> executors, elsewhere;
  if (scene.fragments) {
    const std::string warnings = check_fragments(device, *scene.fragments, options.kernel);
    if (!warnings.empty()) report.notes.push_back(warnings.substr(0, warnings.size() - 1));   // without the last line's end
  }
  if (options.others) elsewhere = options.others->executors(scene, options, report.lanes);
  if (!options.only_others || elsewhere.empty()) executors.push_back(open_executor(device, scene, options, report.build));
  RenderOptions same_lanes = options;
  same_lanes.kernel.lanes = report.lanes;
  for (const auto& further : options.also) {
    try {
      BuildReport build;
      executors.push_back(open_executor(*further, scene, same_lanes, build));
    } catch (const DeviceError& error) {
      report.notes.push_back(fmt::format("{}\n  The picture is rendered without it.", error.what()));
    }
  }
  for (auto& executor : elsewhere) executors.push_back(std::move(executor));
  return executors;
}

}  // namespace nicol
