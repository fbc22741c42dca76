#include "host/opencl/device_executor.hpp"

#include <algorithm>

#include "host/opencl/errors.hpp"
#include "host/opencl/samples.hpp"
#include "host/opencl/scalar_buffer.hpp"

namespace nicol {
namespace {

constexpr std::int64_t max_out_bytes = 64 << 20;

std::vector<double> points_of(const RenderOptions& options) {
  const int first = first_samples(options);
  const auto samples = !options.positions.empty() ? options.positions
                                                  : pixel_samples(options.sample_error > 0 ? std::max(first, options.most_samples) : first);
  std::vector<double> points;
  for (const auto& sample : samples) points.insert(points.end(), sample.begin(), sample.end());
  return points;
}

}  // namespace

int first_samples(const RenderOptions& options) {
  return options.positions.empty() ? std::max(1, options.samples) : static_cast<int>(options.positions.size());
}

// OpenCL's errors with the device's name.
template <class Work>
auto DeviceExecutor::told(Work work) const {
  try {
    return work();
  } catch (const cl::Error& error) {
    const std::string message = error_message(error, device_.about.name);
    if (is_shortage(error.err())) throw ShortageError(message);
    throw DeviceError(message);
  }
}

DeviceExecutor::DeviceExecutor(Device& device, const PackedScene& scene, const RenderOptions& options,
                               std::shared_ptr<const Kernel> kernel, int lanes)
    : device_(device), kernel_(std::move(kernel)), save_later_(options.kernel.save_later), turn_(std::in_place, device),
      scene_(scene), layout_(item_layout(scene, lanes)),
      scalar_bytes_(options.kernel.real_double ? sizeof(double) : sizeof(float)) {
  told([&] {
    const bool real_double = options.kernel.real_double;
    ints_ = int_buffer(device.context, scene.ints);
    reals_ = scalar_buffer(device.context, scene.reals, real_double);
    tables_ = scalar_buffer(device.context, scene.tables, real_double);
    sample_points_ = scalar_buffer(device.context, points_of(options), real_double);
  });
}

DeviceExecutor::~DeviceExecutor() {
  try {
    if (in_flight() > 0) drop();
    turn_.reset();
    if (!save_later_) keep(kernel_);
  } catch (const std::exception&) {
    return;   // not to be kept is no failure: the next start builds again
  }
}

void DeviceExecutor::begin_pass(const std::vector<std::int32_t>& listed, int begin, int) {
  told([&] {
    begin_ = begin;
    listed_count_ = static_cast<std::int64_t>(listed.size());
    listed_ = int_buffer(device_.context, listed);
    layout_ = item_layout(scene_, layout_.lanes, listed_count_);
  });
}

std::int64_t DeviceExecutor::units_that_fit() const {
  const std::int64_t bytes = std::min<std::int64_t>(
      max_out_bytes, static_cast<std::int64_t>(std::max<std::size_t>(device_.about.max_allocation_bytes, 1 << 20)));
  const std::int64_t by_memory = bytes / static_cast<std::int64_t>(bytes_of(1));
  return std::max<std::int64_t>(1, std::min(by_memory, max_work_groups * kernel_->local_size / layout_.items_per_unit()));
}

void DeviceExecutor::allocate(Slot& slot, std::int64_t units) {
  slot = Slot{};
  slot.out = cl::Buffer(device_.context, CL_MEM_WRITE_ONLY, bytes_of(units));
  slot.counters = cl::Buffer(device_.context, CL_MEM_READ_WRITE, sizeof(Counters));
  slot.out_bytes = bytes_of(units);
}

void DeviceExecutor::submit(const Tile& tile, std::int64_t most_units) {
  told([&] {
    Slot& slot = slots_[next_];
    if (slot.out_bytes < bytes_of(tile.unit_count)) allocate(slot, std::max(tile.unit_count, most_units));
    launch(next_, tile);
    slot.tile = tile;
    next_ ^= 1;
  });
}

void DeviceExecutor::launch(int index, const Tile& tile) {
  Slot& slot = slots_[index];
  cl::CommandQueue& queue = device_.queues[index];
  cl::Kernel& kernel = kernel_->kernel;
  const std::int64_t items = tile.unit_count * layout_.items_per_unit();
  *slot.counted = {};
  queue.enqueueWriteBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted->data());
  cl_uint arg = 0;
  for (const cl::Buffer* buffer : {&ints_, &reals_, &tables_, &sample_points_, &listed_, &slot.out, &slot.counters})
    kernel.setArg(arg++, *buffer);
  for (std::int64_t number : {listed_count_, tile.first_unit * layout_.items_per_unit(), items,
                              static_cast<std::int64_t>(begin_ + tile.sample_begin),
                              static_cast<std::int64_t>(begin_ + tile.sample_end)})
    kernel.setArg(arg++, static_cast<cl_int>(number));
  enqueue(queue, kernel, kernel_->local_size, items);
  queue.enqueueReadBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted->data());
  slot.mapped = queue.enqueueMapBuffer(slot.out, CL_FALSE, CL_MAP_READ, 0, bytes_of(tile.unit_count), nullptr, &slot.done);
  queue.flush();
}

bool DeviceExecutor::ready() {
  const Slot& oldest = slots_[slots_[next_].tile ? next_ : next_ ^ 1];
  return oldest.tile && told([&] { return oldest.done.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE; });
}

TracedTile DeviceExecutor::collect() {
  return told([&] {
    const int index = slots_[next_].tile ? next_ : next_ ^ 1;
    Slot& slot = slots_[index];
    device_.queues[index].finish();
    collected_ = index;
    TracedTile traced;
    traced.tile = *slot.tile;
    traced.sums = slot.mapped;
    traced.counted = *slot.counted;
    return traced;
  });
}

void DeviceExecutor::release() {
  told([&] {
    Slot& slot = slots_[*collected_];
    device_.queues[*collected_].enqueueUnmapMemObject(slot.out, slot.mapped);
    slot.tile.reset();
    collected_.reset();
  });
}

void DeviceExecutor::drop() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    try {
      device_.queues[i].finish();
    } catch (const cl::Error&) {
      static_cast<void>(slots_[i].counted.release());  // the device may still write there
    }
  }
  for (Slot& slot : slots_) slot = Slot{};
  collected_.reset();
}

}  // namespace nicol
