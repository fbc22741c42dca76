// From kernel text to a kernel that is ready to launch: built once a process, kept on disk between them.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/render.hpp"

namespace nicol {

// The widest grid of a launch, in work-groups. PoCL compiles another version of a kernel for grids of 64k and more.
// Every kernel's first launch, which has no work, is this wide: PoCL up to 6.0 looks for loaded code that was asked for by a
// grid at least as wide, but gives back whichever of that work-group size comes first, so that its counts go wrong, and
// an assertion ends the process, where a launch is wider than all before it while others of the kernel run.
constexpr std::int64_t max_work_groups = 60000;

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
  // Gives the kernel arguments that mean no work, with `empty` for each buffer, for its first launch: PoCL compiles then, and
  // a binary holds only what was launched before it was saved.
  std::function<void(cl::Kernel&, const cl::Buffer& empty)> set_no_work;
  std::function<bool()> build_elsewhere;   // puts it into the binary cache, from where it is loaded; false: it has not. May be empty
};

// 1 on a CPU: PoCL keeps the private memory of a whole work-group on one thread's stack. 64 elsewhere.
int local_size_on(const DeviceInfo& device);

// Puts a launch of `items` work-items, filled up to whole work-groups (max_work_groups at most), into the queue.
void enqueue(cl::CommandQueue& queue, const cl::Kernel& kernel, int local_size, std::int64_t items);

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

// Saves a kernel's binary if that is still to be done. PoCL compiles once more to give it and must not be running that
// kernel meanwhile, on any of its devices (its counts of loaded code go wrong): with launches or compilations in the process,
// the next call without any does it, so that nobody waits. Callers hold no Turn.
void keep(const std::shared_ptr<const Kernel>& kernel);

}  // namespace nicol
