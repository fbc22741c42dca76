// Kernels built on the side, so that pictures go on with one that is ready.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <tuple>

#include "host/opencl/render.hpp"
#include "host/preview/latest_job.hpp"

namespace nicol::preview {

struct KernelChoice {
  bool ready = false;
  KernelOptions options;      // ready: to render with
  bool specialised = false;   // that kernel is the one for these features alone
  bool building = false;      // the specialised one is being built
  std::string failure;        // why it cannot be, the generic one in its place
};

class SideBuilder {
 public:
  // From the building thread, after each build: `done`, then, when idle() may be true again, `after`.
  SideBuilder(std::function<void()> done, std::function<void()> after) : done_(std::move(done)), jobs_(false, std::move(after)) {}
  ~SideBuilder() { quit_ = true; }   // a build in a process of its own is given up

  // The specialised kernel if it is ready; else the generic one, and the specialised one is begun; else that is waited for
  // (ready false). `wanted.generic`: only ever the generic one. Throws DeviceError if what was asked for cannot be built.
  KernelChoice choose(const std::shared_ptr<Device>& device, const KernelContents& contents, const KernelOptions& wanted);

  // Builds the generic kernel too, for changes to come.
  void build_generic(const std::shared_ptr<Device>& device, const KernelOptions& wanted);

  bool idle() const { return jobs_.idle(); }

 private:
  using Key = std::tuple<const Device*, std::uint32_t, std::string, bool, bool, int>;   // contents, options
  void build(const std::shared_ptr<Device>& device, const KernelContents& contents, const KernelOptions& options);
  std::string failure_of(const Key& key) const;

  std::function<void()> done_;
  std::atomic<bool> quit_{false};
  mutable std::mutex lock_;
  std::map<Key, std::string> failures_;
  std::set<Key> there_;       // known to be ready, without a look at the disk
  LatestJob jobs_;            // last: its thread ends first
};

}  // namespace nicol::preview
