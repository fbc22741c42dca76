// The OpenCL side of a device, for this folder only.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "host/opencl/device.hpp"
#include "host/opencl/opencl.hpp"

namespace nicol {

struct Kernel;

// A kernel of this process: null while it is being built, and after a build that failed.
struct KernelPlace {
  std::mutex building;                     // held during a build; comes before kernels_lock
  std::shared_ptr<const Kernel> kernel;    // under kernels_lock
};

class Device {
 public:
  Device(const DeviceInfo& device_info, const cl::Device& cl_device);

  DeviceInfo about;
  cl::Device device;
  cl::Context context;
  std::array<cl::CommandQueue, 2> queues;   // in order; launches alternate between them

  // Kernels keep their arguments: one picture at a time. To be taken by wait_for_turn().
  std::mutex launches, next_in_line;

  // In order of asking: pictures that follow one another at once would never let go of a mutex long enough for anyone else.
  std::unique_lock<std::mutex> wait_for_turn() {
    const std::lock_guard<std::mutex> next(next_in_line);
    return std::unique_lock<std::mutex>(launches);
  }

  // First launches, in which PoCL compiles, and the saving of binaries take turns; comes after `launches`.
  static inline std::mutex compiling;   // one for all devices: PoCL keeps one table of loaded code

  // Kernels of this process by identity (see program.cpp), so that a second picture builds nothing. Held for look-ups only.
  std::mutex kernels_lock;
  std::map<std::string, std::shared_ptr<KernelPlace>> kernels;
};

}  // namespace nicol
