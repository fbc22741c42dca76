// The tiles of one pass: launched, collected, kept, found.
#include <algorithm>

#include "host/opencl/errors.hpp"
#include "host/opencl/renderer.hpp"
#include "host/opencl/samples.hpp"
#include "host/opencl/scalar_buffer.hpp"

namespace nicol {
namespace {

// PoCL compiles another version of the kernel for grids of 64k and more.
constexpr std::int64_t max_work_groups = 60000;
constexpr std::int64_t max_out_bytes = 64 << 20;

std::vector<std::array<double, 2>> samples_of(const RenderOptions& options) {
  if (!options.positions.empty()) return options.positions;
  const int first = first_samples(options);
  return pixel_samples(options.sample_error > 0 ? std::max(first, options.most_samples) : first);
}

// What a tile counted goes with its first unit, as a pass of its own.
TileKey key_of_counters(TileKey tile, std::int64_t unit) {
  tile.pass = -1 - tile.pass;
  tile.first_unit = unit;
  tile.unit_count = 1;
  return tile;
}

}  // namespace

Renderer::Renderer(Device& device, const PackedScene& scene, const RenderOptions& options, const Kernel& kernel,
                   int lanes, Frame& frame, RenderReport& report)
    : device_(device), scene_(scene), options_(options), frame_(frame), report_(report), local_size_(kernel.local_size),
      scalar_bytes_(options.kernel.real_double ? sizeof(double) : sizeof(float)), layout_(item_layout(scene, lanes)),
      samples_(samples_of(options)), gather_(scene, lanes, frame), kernel_(kernel.kernel) {
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

// The pixels of the scene's picture that the kernel is to trace.
void Renderer::list_pixels(const std::vector<std::int32_t>* pixels) {
  const std::vector<std::int32_t>& base = options_.pixels;
  std::vector<std::int32_t> list;
  if (!pixels) {
    list = base;
  } else {
    for (const std::int32_t p : *pixels) list.push_back(base.empty() ? p : base[static_cast<std::size_t>(p)]);
  }
  listed_count_ = static_cast<std::int64_t>(list.size());
  listed_ = int_buffer(device_.context, list);
  layout_ = item_layout(scene_, layout_.lanes, listed_count_);
}

void Renderer::allocate(const TileSchedule& schedule) {
  const std::size_t bytes = static_cast<std::size_t>(out_values(schedule.max_units())) * scalar_bytes_;
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
  *slot.counted = {};
  queue.enqueueWriteBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted->data());
  cl_uint arg = 0;
  for (const cl::Buffer* buffer : {&ints_, &reals_, &tables_, &sample_points_, &listed_, &slot.out, &slot.counters})
    kernel_.setArg(arg++, *buffer);
  for (std::int64_t number : {listed_count_, tile.first_unit * layout_.items_per_unit(), items,
                              static_cast<std::int64_t>(begin_ + tile.sample_begin),
                              static_cast<std::int64_t>(begin_ + tile.sample_end)})
    kernel_.setArg(arg++, static_cast<cl_int>(number));
  queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(padded), cl::NDRange(local_size_));
  queue.enqueueReadBuffer(slot.counters, CL_FALSE, 0, sizeof(Counters), slot.counted->data());
  slot.mapped = queue.enqueueMapBuffer(slot.out, CL_FALSE, CL_MAP_READ, 0,
                                       static_cast<std::size_t>(out_values(tile.unit_count)) * scalar_bytes_);
  queue.flush();
  slot.tile = tile;
}

void Renderer::collect(int index, TileSchedule& schedule) {
  Slot& slot = slots_[index];
  device_.queues[index].finish();
  const Tile tile = *slot.tile;
  schedule.took(tile, seconds_since(last_collected_));
  last_collected_ = Clock::now();
  if (report_.tiles++ == 0) report_.seconds_to_first_tile = seconds_since(start_);
  gather(tile, slot.mapped);
  keep_in_journal(tile, slot);
  count(tile, *slot.counted);
  device_.queues[index].enqueueUnmapMemObject(slot.out, slot.mapped);
  slot.tile.reset();
  tell_progress(tile);
}

// Counted for good when all samples of the units are done: a shortage before that starts them anew.
void Renderer::count(const Tile& tile, const Counters& counted) {
  for (std::size_t i = 0; i < COUNTERS; ++i) counted_[i] += counted[i];
  if (tile.sample_end < end_ - begin_) return;
  report_.nan_count += counted_[COUNT_NAN];
  report_.energy_count += counted_[COUNT_ENERGY];
  report_.stack_count += counted_[COUNT_STACK];
  report_.stokes_count += counted_[COUNT_STOKES];
  report_.fallback_count += counted_[COUNT_FALLBACK];
  report_.segments += counted_[COUNT_SEGMENTS];
  counted_ = {};
}

void Renderer::gather(const Tile& tile, const void* sums) {
  if (options_.kernel.real_double)
    gather_.add(tile, static_cast<const double*>(sums));
  else
    gather_.add(tile, static_cast<const float*>(sums));
  if (tile.sample_end < end_ - begin_) return;
  units_done_ = tile.first_unit + tile.unit_count;
  if (!options_.tile) return;
  const std::vector<std::int32_t> pixels = gather_.pixels_of(tile);
  options_.tile(frame_, pixels.data(), pixels.size());
}

void Renderer::keep_in_journal(const Tile& tile, const Slot& slot) {
  if (!options_.journal || seconds_since(start_) < options_.journal_after_seconds) return;
  const TileKey key = key_of(tile);
  options_.journal->add(key_of_counters(key, key.first_unit), slot.counted->data(), sizeof(Counters));
  options_.journal->add(key, slot.mapped, bytes_per_unit() * static_cast<std::size_t>(tile.unit_count));
}

// The start of the tile, if an earlier run has finished it.
bool Renderer::take_from_journal(Tile& tile, TileSchedule& schedule) {
  if (!options_.journal) return false;
  TileKey key = key_of(tile);
  const std::int64_t units =
      options_.journal->covered_units(key.pass, key.first_unit, key.sample_begin, key.sample_end);
  if (units <= 0 || (tile.sample_begin > 0 && units < tile.unit_count)) return false;
  if (tile.sample_begin == 0) schedule.cut(tile, units);
  key = key_of(tile);
  std::vector<unsigned char> bytes(bytes_per_unit() * static_cast<std::size_t>(tile.unit_count));
  if (!options_.journal->find(key, bytes_per_unit(), bytes.data())) return false;
  gather(tile, bytes.data());
  Counters counted, sum{};
  for (std::int64_t unit = key.first_unit; unit < key.first_unit + key.unit_count; ++unit)
    if (options_.journal->find(key_of_counters(key, unit), sizeof counted, counted.data()))
      std::transform(sum.begin(), sum.end(), counted.begin(), sum.begin(), std::plus<>());
  count(tile, sum);
  ++report_.tiles_found;
  tell_progress(tile);
  return true;
}

void Renderer::tell_progress(const Tile& tile) {
  if (!options_.progress) return;
  Progress now;
  const double of_pass = static_cast<double>(layout_.pixels) * (end_ - begin_);
  const double part = (static_cast<double>(tile.first_unit) +
                       static_cast<double>(tile.sample_end) / (end_ - begin_) * static_cast<double>(tile.unit_count)) /
                      static_cast<double>(layout_.units());
  now.fraction = (samples_done_ + part * of_pass) / (samples_done_ + std::max(of_pass, samples_ahead_));
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
      static_cast<void>(slots_[i].counted.release());  // the device may still write there
    }
  }
  for (Slot& slot : slots_) slot = Slot{};
  counted_ = {};
}

// False if it was cancelled.
bool Renderer::run_tiles(TileSchedule& schedule) {
  bool ready = false;
  for (;;) {
    try {
      if (!ready) allocate(schedule);
      ready = true;
      int index = 0;
      for (Tile tile; !cancelled() && schedule.next(tile);) {
        if (slots_[index].tile) collect(index, schedule);
        if (options_.journal && slots_[index ^ 1].tile && covered(tile)) collect(index ^ 1, schedule);
        if (take_from_journal(tile, schedule)) continue;
        submit(index, tile);
        index ^= 1;
      }
      for (int i : {index, index ^ 1})
        if (slots_[i].tile) collect(i, schedule);
      return units_done_ == layout_.units();
    } catch (const cl::Error& error) {
      drop_all();
      ready = false;
      if (!is_shortage(error.err()) || !schedule.shrink(units_done_)) throw;
    }
  }
}

}  // namespace nicol
