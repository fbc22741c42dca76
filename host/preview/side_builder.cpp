#include "host/preview/side_builder.hpp"

namespace nicol::preview {
namespace {

auto key_of(const std::shared_ptr<Device>& device, const KernelContents& contents, const KernelOptions& options) {
  return std::tuple<const Device*, std::uint32_t, std::string, bool, bool, int>{
      device.get(), options.generic ? 0 : contents.features, contents.fragment_text(), options.generic, options.real_double, options.lanes};
}

}  // namespace

std::string SideBuilder::failure_of(const Key& key) const {
  const std::lock_guard<std::mutex> held(lock_);
  const auto found = failures_.find(key);
  return found == failures_.end() ? "" : found->second;
}

void SideBuilder::build(const std::shared_ptr<Device>& device, const KernelContents& contents, const KernelOptions& options) {
  const Key key = key_of(device, contents, options);
  if (!failure_of(key).empty()) return;
  jobs_.post([this, key, device, contents, how = options]() mutable {
    std::string failure;
    how.stop = &quit_;
    try {
      prepare_kernel(*device, contents, how);
    } catch (const std::exception& error) {
      failure = error.what();
    }
    {
      const std::lock_guard<std::mutex> held(lock_);
      if (failure.empty()) there_.insert(key);
      else failures_[key] = failure;
    }
    done_();
  });
}

KernelChoice SideBuilder::choose(const std::shared_ptr<Device>& device, const KernelContents& contents, const KernelOptions& wanted) {
  const auto ready = [&](const KernelOptions& options) {
    const Key key = key_of(device, contents, options);
    const std::lock_guard<std::mutex> held(lock_);
    if (there_.count(key) == 0 && kernel_readiness(*device, contents, options) != KernelReadiness::missing) there_.insert(key);
    return there_.count(key) > 0;
  };
  KernelChoice choice;
  choice.options = wanted;
  choice.specialised = !wanted.generic;
  choice.ready = ready(wanted);
  if (choice.ready) return choice;
  KernelOptions generic = wanted;
  generic.generic = true;
  const bool meanwhile = !wanted.generic && ready(generic);
  KernelOptions built = wanted;
  built.own_process = meanwhile;   // PoCL starts no kernel while it compiles another; with nothing to show it is quicker here
  build(device, contents, built);
  choice.failure = failure_of(key_of(device, contents, wanted));
  choice.building = choice.failure.empty();
  if (meanwhile) {
    choice.options = generic;
    choice.specialised = false;
    choice.ready = true;
  } else if (!choice.failure.empty()) {
    throw DeviceError(choice.failure);
  }
  return choice;
}

void SideBuilder::build_generic(const std::shared_ptr<Device>& device, const KernelOptions& wanted) {
  KernelOptions generic = wanted;
  generic.generic = generic.own_process = true;
  const bool here = kernel_readiness(*device, 0, generic) != KernelReadiness::missing;
  if (!here) build(device, 0, generic);
}

}  // namespace nicol::preview
