// `nicol devices` and `nicol probe`: the OpenCL devices themselves.
#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <iterator>

#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/opencl/probe.hpp"

namespace nicol::app {
namespace {

const char* kind(const DeviceInfo& device) {
  if (device.is_gpu) return "GPU";
  return device.is_cpu ? "CPU" : "other";
}

}  // namespace

int devices_command() {
  const std::vector<DeviceInfo> devices = list_devices();
  if (devices.empty()) {
    fmt::print(stderr, "nicol: there is no OpenCL device; pocl-opencl-icd makes one of any CPU\n");
    return exit_error;
  }
  const int standard = info(*open_device("")).index;
  for (const DeviceInfo& device : devices) {
    constexpr double bytes_per_gib = 1024.0 * 1024.0 * 1024.0;
    fmt::print("{} {}  {}\n", device.index == standard ? '*' : ' ', device.index, device.name);
    fmt::print("     {}, {} units, {:.1f} GiB ({:.1f} in one piece), lanes {} float, {} double{}\n",
               kind(device), device.compute_units,
               static_cast<double>(device.memory_bytes) / bytes_per_gib,
               static_cast<double>(device.max_allocation_bytes) / bytes_per_gib,
               device.native_float_width, device.native_double_width,
               device.has_fp64 ? "" : " (no double precision)");
    fmt::print("     {}, {}, driver {}\n", device.platform, device.version, device.driver);
  }
  fmt::print("* is used unless --device names another by its number or a part of its name\n");
  std::string all;
  for (const DeviceInfo& device : choose_devices("all")) all += fmt::format("{}{}", all.empty() ? "" : ",", device.index);
  fmt::print("render takes several: --device {}, which is what --device all means; lanes are those that suit the first\n", all);
  return exit_done;
}

int probe_command(const DeviceOptions& options) {
  const std::string json{std::istreambuf_iterator<char>(std::cin),
                         std::istreambuf_iterator<char>()};
  const auto device = open_wanted_device(options);
  fmt::print("{}\n", probe(*device, json, options.real == "double"));
  return exit_done;
}

}  // namespace nicol::app
