// Launches the trace kernel over the picture: two queues in turn, so that the device always has the next tile.
#include "host/opencl/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <optional>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/gather.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/samples.hpp"
#include "host/opencl/scalar_buffer.hpp"
#include "host/opencl/tiles.hpp"
#include "kernels/abi.h"

namespace nicol {
namespace {

using Clock = std::chrono::steady_clock;
using Counters = std::array<cl_uint, COUNTERS>;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// PoCL compiles another version of the kernel for grids of 64k and more.
constexpr std::int64_t max_work_groups = 60000;
constexpr std::int64_t max_out_bytes = 64 << 20;

// No work: compiles what the first launch would compile.
void warm_up_trace(Device& device, cl::CommandQueue& queue, cl::Kernel& kernel, int local_size) {
  const cl::Buffer empty(device.context, CL_MEM_READ_WRITE, 4096);
  for (cl_uint i = 0; i < 6; ++i) kernel.setArg(i, empty);
  for (cl_uint i = 6; i < 10; ++i) kernel.setArg(i, cl_int{0});
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(local_size), cl::NDRange(local_size));
  queue.finish();
}

std::shared_ptr<const Kernel> trace_kernel(Device& device, std::uint32_t features, const KernelOptions& options) {
  KernelRequest request;
  request.file = "trace.cl";
  request.name = "trace";
  request.lanes = lanes_on(device, options);
  request.real_double = options.real_double;
  if (!options.generic) request.defines = fmt::format(" -D SCENE_FEATURES={}", features);
  request.binary_cache = options.binary_cache;
  request.warm_up = [&device](cl::CommandQueue& queue, cl::Kernel& kernel, int local_size) {
    warm_up_trace(device, queue, kernel, local_size);
  };
  return get_kernel(device, request);
}

void check_scene(const PackedScene& scene, const std::vector<double>& lambda_nm,
                 const std::vector<double>& weight_nm, int lanes) {
  const std::size_t channels = static_cast<std::size_t>(scene.channels);
  const bool fits = scene.width > 0 && scene.height > 0 && scene.channels > 0 && scene.stride >= scene.channels &&
                    scene.stride % lanes == 0 && lambda_nm.size() == weight_nm.size() && !lambda_nm.empty() &&
                    scene.mixing.size() == (scene.mixing.empty() ? 0 : channels * lambda_nm.size()) &&
                    (!scene.mixing.empty() || channels == lambda_nm.size());
  if (!fits)
    throw std::invalid_argument(fmt::format(
        "the packed scene does not fit the launch: {} x {} pixels, {} channels in rows of {}, {} mixing shares, "
        "{} wavelengths, {} lanes", scene.width, scene.height, scene.channels, scene.stride, scene.mixing.size(),
        lambda_nm.size(), lanes));
}

// The kernel numbers its work-items with an int.
void check_item_count(const PackedScene& scene, int lanes) {
  if (item_layout(scene, lanes).items() > INT_MAX)
    throw DeviceError(fmt::format("a picture of {} x {} pixels and {} channels is more than one launch can number: "
                                  "render parts of it", scene.width, scene.height, scene.channels));
}

class Renderer {
 public:
  Renderer(Device& device, const PackedScene& scene, const RenderOptions& options, const Kernel& kernel, int lanes,
           Frame& frame, RenderReport& report);
  void run();

 private:
  // A launch in flight, on the queue of the same index.
  struct Slot {
    cl::Buffer out, counters;
    void* mapped = nullptr;
    Counters counted{};
    std::optional<Tile> tile;
  };

  void allocate();
  void submit(int slot, const Tile& tile);
  void collect(int slot);
  void drop_all();
  void tell_progress(const Tile& tile);
  bool cancelled() const { return options_.cancel && options_.cancel->load(); }
  std::int64_t out_values(std::int64_t units) const {
    return units * layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes;
  }
  std::int64_t units_that_fit() const;

  Device& device_;
  const RenderOptions& options_;
  RenderReport& report_;
  const int local_size_;
  const std::size_t scalar_bytes_;
  const ItemLayout layout_;
  const std::vector<std::array<double, 2>> samples_;
  TileSchedule schedule_;
  Gather gather_;
  cl::Kernel& kernel_;
  cl::Buffer ints_, reals_, tables_, sample_points_;
  std::array<Slot, 2> slots_;
  std::int64_t units_done_ = 0;
  Clock::time_point start_ = Clock::now(), last_collected_ = start_;
};

std::vector<std::array<double, 2>> samples_of(const RenderOptions& options) {
  return options.positions.empty() ? pixel_samples(std::max(1, options.samples)) : options.positions;
}

// Rows are ends of tiles only where units are pixels or fill rows.
std::int64_t row_units_of(const PackedScene& scene, const ItemLayout& layout) {
  return scene.width % layout.pixels_per_unit() == 0 ? scene.width / layout.pixels_per_unit() : 0;
}

Renderer::Renderer(Device& device, const PackedScene& scene, const RenderOptions& options, const Kernel& kernel,
                   int lanes, Frame& frame, RenderReport& report)
    : device_(device), options_(options), report_(report), local_size_(kernel.local_size),
      scalar_bytes_(options.kernel.real_double ? sizeof(double) : sizeof(float)), layout_(item_layout(scene, lanes)),
      samples_(samples_of(options)),
      schedule_(layout_.units(), row_units_of(scene, layout_), static_cast<int>(samples_.size()), units_that_fit(),
                options.tile_seconds),
      gather_(scene, layout_, static_cast<int>(samples_.size()), frame),
      kernel_(kernel.kernel) {
  const bool real_double = options.kernel.real_double;
  std::vector<double> points;
  for (const auto& sample : samples_) points.insert(points.end(), sample.begin(), sample.end());
  ints_ = int_buffer(device.context, scene.ints);
  reals_ = scalar_buffer(device.context, scene.reals, real_double);
  tables_ = scalar_buffer(device.context, scene.tables, real_double);
  sample_points_ = scalar_buffer(device.context, points, real_double);
}

std::int64_t Renderer::units_that_fit() const {
  const std::int64_t bytes = std::min<std::int64_t>(
      max_out_bytes, static_cast<std::int64_t>(std::max<std::size_t>(device_.about.max_allocation_bytes, 1 << 20)));
  const std::int64_t by_memory = bytes / (out_values(1) * static_cast<std::int64_t>(scalar_bytes_));
  return std::max<std::int64_t>(1, std::min(by_memory, max_work_groups * local_size_ / layout_.items_per_unit()));
}

void Renderer::allocate() {
  const std::size_t bytes = static_cast<std::size_t>(out_values(schedule_.max_units())) * scalar_bytes_;
  for (Slot& slot : slots_) {
    slot = Slot{};
    slot.out = cl::Buffer(device_.context, CL_MEM_WRITE_ONLY, bytes);
    slot.counters = cl::Buffer(device_.context, CL_MEM_READ_WRITE, sizeof(Counters));
  }
}

void Renderer::submit(int index, const Tile& tile) {
  Slot& slot = slots_[index];
  cl::CommandQueue& queue = device_.queues[index];
  const std::int64_t items = tile.unit_count * layout_.items_per_unit();
  const auto padded = static_cast<std::size_t>((items + local_size_ - 1) / local_size_ * local_size_);
  slot.counted = {};
  queue.enqueueWriteBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted.data());
  cl_uint arg = 0;
  for (const cl::Buffer* buffer : {&ints_, &reals_, &tables_, &sample_points_, &slot.out, &slot.counters})
    kernel_.setArg(arg++, *buffer);
  for (std::int64_t number : {tile.first_unit * layout_.items_per_unit(), items,
                              static_cast<std::int64_t>(tile.sample_begin), static_cast<std::int64_t>(tile.sample_end)})
    kernel_.setArg(arg++, static_cast<cl_int>(number));
  queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(padded), cl::NDRange(local_size_));
  queue.enqueueReadBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted.data());
  slot.mapped = queue.enqueueMapBuffer(slot.out, CL_FALSE, CL_MAP_READ, 0,
                                       static_cast<std::size_t>(out_values(tile.unit_count)) * scalar_bytes_);
  queue.flush();
  slot.tile = tile;
}

void Renderer::collect(int index) {
  Slot& slot = slots_[index];
  device_.queues[index].finish();
  const Tile tile = *slot.tile;
  schedule_.took(tile, seconds_since(last_collected_));
  last_collected_ = Clock::now();
  if (report_.tiles++ == 0) report_.seconds_to_first_tile = seconds_since(start_);
  if (options_.kernel.real_double)
    gather_.add(tile, static_cast<const double*>(slot.mapped));
  else
    gather_.add(tile, static_cast<const float*>(slot.mapped));
  device_.queues[index].enqueueUnmapMemObject(slot.out, slot.mapped);
  slot.tile.reset();
  report_.nan_count += slot.counted[COUNT_NAN];
  report_.energy_count += slot.counted[COUNT_ENERGY];
  report_.stack_count += slot.counted[COUNT_STACK];
  report_.stokes_count += slot.counted[COUNT_STOKES];
  report_.fallback_count += slot.counted[COUNT_FALLBACK];
  report_.segments += slot.counted[COUNT_SEGMENTS];
  if (tile.sample_end == static_cast<int>(samples_.size())) units_done_ = tile.first_unit + tile.unit_count;
  tell_progress(tile);
}

void Renderer::tell_progress(const Tile& tile) {
  if (!options_.progress) return;
  Progress now;
  const double part = static_cast<double>(tile.sample_end) / static_cast<double>(samples_.size());
  now.fraction = (static_cast<double>(tile.first_unit) + part * static_cast<double>(tile.unit_count)) /
                 static_cast<double>(layout_.units());
  now.seconds = seconds_since(start_);
  now.seconds_left = now.fraction > 0 ? now.seconds * (1 - now.fraction) / now.fraction : 0;
  now.segments_per_second = static_cast<double>(report_.segments) / std::max(now.seconds, 1e-9);
  options_.progress(now);
}

// After a shortage: what is in flight is lost and will be launched again.
void Renderer::drop_all() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    try {
      device_.queues[i].finish();
    } catch (const cl::Error&) {
      continue;
    }
  }
  for (Slot& slot : slots_) slot = Slot{};
}

void Renderer::run() {
  bool ready = false;
  for (;;) {
    try {
      if (!ready) allocate();
      ready = true;
      int index = 0;
      for (Tile tile; !cancelled() && schedule_.next(tile); index ^= 1) {
        if (slots_[index].tile) collect(index);
        submit(index, tile);
      }
      for (int i : {index, index ^ 1})
        if (slots_[i].tile) collect(i);
      break;
    } catch (const cl::Error& error) {
      drop_all();
      ready = false;
      if (!is_shortage(error.err()) || !schedule_.shrink(units_done_)) throw;
    }
  }
  gather_.finish();
  report_.seconds = seconds_since(start_);
  report_.interrupted = units_done_ < layout_.units();
  report_.cut_off_mean = gather_.cut_off_mean;
  report_.cut_off_worst = gather_.cut_off_worst;
}

}  // namespace

int lanes_on(const Device& device, const KernelOptions& options) {
  const DeviceInfo& about = info(device);
  const int wanted = options.lanes > 0 ? options.lanes : about.is_cpu ? about.native_float_width : 1;
  for (int lanes : {16, 8, 4, 1})
    if (lanes == wanted || (options.lanes <= 0 && lanes <= wanted)) return lanes;
  throw DeviceError(fmt::format("{} lanes: there are kernels for 1, 4, 8 and 16", options.lanes));
}

Frame render(Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
             const std::vector<double>& weight_nm, const RenderOptions& options, RenderReport& report) {
  const auto start = Clock::now();
  report = RenderReport{};
  report.device = device.about.name;
  report.lanes = lanes_on(device, options.kernel);
  report.real = options.kernel.real_double ? "double" : "float";
  report.precise_real = options.kernel.real_double || device.about.has_fp64 ? "double" : "float, for the device has no fp64";
  check_scene(scene, lambda_nm, weight_nm, report.lanes);
  check_item_count(scene, report.lanes);
  Frame frame = make_frame(scene, lambda_nm, weight_nm);
  try {
    const auto kernel = trace_kernel(device, scene.features, options.kernel);
    report.build = kernel->report;
    const std::lock_guard<std::mutex> one_at_a_time(device.launches);
    const double before_tiles = seconds_since(start);
    Renderer(device, scene, options, *kernel, report.lanes, frame, report).run();
    report.seconds_to_first_tile += before_tiles;
    keep(*kernel);
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
  return frame;
}

BuildReport prepare_kernel(Device& device, std::uint32_t features, const KernelOptions& options) {
  const auto kernel = trace_kernel(device, features, options);
  keep(*kernel);
  return kernel->report;
}

}  // namespace nicol
