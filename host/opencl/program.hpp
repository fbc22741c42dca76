// From kernel text to a kernel that is ready to launch: built once a process, kept on disk between them.
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/render.hpp"

namespace nicol {

struct Kernel {
  cl::Program program;
  mutable cl::Kernel kernel;  // made once: while PoCL gives the binary of a program, it makes no kernels of it
  int local_size = 1;
  BuildReport report;
  std::function<void()> save;              // to the binary cache
  mutable std::atomic<bool> unsaved{false};  // save is still to be called
};

struct KernelRequest {
  std::string file, name;         // "trace.cl", "trace"
  std::string fragments;          // text in place of scene_fragments.h; "": none
  int lanes = 1;
  bool real_double = false;
  std::string defines;            // further -D options
  bool binary_cache = true;
  // Launches the kernel once on no work, with its fixed local size: PoCL compiles at the first launch, and a binary
  // holds only what was launched before it was saved.
  std::function<void(cl::CommandQueue&, cl::Kernel&, int local_size)> warm_up;
  std::function<bool()> build_elsewhere;   // puts it into the binary cache, from where it is loaded; false: it has not. May be empty
};

// 1 on a CPU: PoCL keeps the private memory of a whole work-group on one thread's stack. 64 elsewhere.
int local_size_on(const DeviceInfo& device);

// Throws DeviceError; a build failure carries the log, which names kernel file and line, and the next call tries again.
// For several threads: one builds a kernel, others that want the same one wait; other kernels are not held up.
std::shared_ptr<const Kernel> get_kernel(Device& device, const KernelRequest& request);

// The kernel that traces scenes with these features, and fragments of plugins as this text (SceneFragments::text; "": none). As get_kernel.
std::shared_ptr<const Kernel> build_kernel(Device& device, std::uint32_t features, const std::string& fragments,
                                           const KernelOptions& options);

// The same for a scene, its fragments having been checked (fragment_check.hpp).
std::shared_ptr<const Kernel> trace_kernel(Device& device, const KernelContents& contents, const KernelOptions& options);

// In this process, in the binary cache, or neither.
KernelReadiness readiness_of(Device& device, const KernelRequest& request);

// All that are built.
std::vector<std::shared_ptr<const Kernel>> kernels_here(Device& device);

// Saves a kernel's binary if that is still to be done. PoCL compiles once more to give it and must not be running any
// kernel meanwhile (its table of loaded code is not guarded): the callers hold device.launches, their work finished.
void keep(Device& device, const Kernel& kernel);

}  // namespace nicol
