// Launches the trace kernel over the picture: two queues in turn, so that the device always has the next tile.
#include "host/opencl/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <functional>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/binary_cache.hpp"
#include "host/opencl/gather.hpp"
#include "host/opencl/kernel_source.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/samples.hpp"
#include "host/opencl/sampling_plan.hpp"
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
  for (cl_uint i = 0; i < 7; ++i) kernel.setArg(i, empty);
  for (cl_uint i = 7; i < 12; ++i) kernel.setArg(i, cl_int{0});
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

void check_sampling(const PackedScene& scene, const RenderOptions& options) {
  const std::int64_t plane = static_cast<std::int64_t>(scene.width) * scene.height;
  for (const std::int32_t p : options.pixels)
    if (p < 0 || p >= plane) throw std::invalid_argument(fmt::format("pixel {} is not in the picture", p));
  if (options.sample_error > 0 && ((scene.features & path_signatures_bit()) == 0 || !options.positions.empty() || !options.pixels.empty()))
    throw std::invalid_argument("a sampling error can be kept only in whole pictures of scenes with path signatures");
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
    std::unique_ptr<Counters> counted = std::make_unique<Counters>();
    std::optional<Tile> tile;
  };

  // Samples [begin, end) of these pixels of the frame (null: all).
  bool run_pass(const std::vector<std::int32_t>* pixels, int begin, int end);
  bool run_tiles(TileSchedule& schedule);
  void refine();
  void list_pixels(const std::vector<std::int32_t>* pixels);
  void allocate(const TileSchedule& schedule);
  void submit(int slot, const Tile& tile);
  void collect(int slot, TileSchedule& schedule);
  bool covered(const Tile& tile) const {
    return options_.journal->covered_units(report_.passes, tile.first_unit, begin_ + tile.sample_begin, begin_ + tile.sample_end) > 0;
  }
  bool take_from_journal(Tile& tile, TileSchedule& schedule);
  void keep_in_journal(const Tile& tile, const Slot& slot);
  void gather(const Tile& tile, const void* sums);
  void count(const Tile& tile, const Counters& counted);
  TileKey key_of(const Tile& tile) const {
    return {report_.passes, tile.first_unit, tile.unit_count, begin_ + tile.sample_begin, begin_ + tile.sample_end};
  }
  std::size_t bytes_per_unit() const { return static_cast<std::size_t>(out_values(1)) * scalar_bytes_; }
  void drop_all();
  void tell_progress(const Tile& tile);
  void tell_errors();
  double mean_radiance() const;
  bool cancelled() const { return options_.cancel && options_.cancel->load(); }
  std::int64_t out_values(std::int64_t units) const {
    return units * layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes;
  }
  std::int64_t units_that_fit() const;

  Device& device_;
  const PackedScene& scene_;
  const RenderOptions& options_;
  Frame& frame_;
  RenderReport& report_;
  const int local_size_;
  const std::size_t scalar_bytes_;
  ItemLayout layout_;                       // of the pass
  const std::vector<std::array<double, 2>> samples_;
  Gather gather_;
  cl::Kernel& kernel_;
  cl::Buffer ints_, reals_, tables_, sample_points_, listed_;
  std::int64_t listed_count_ = 0;
  std::array<Slot, 2> slots_;
  std::array<std::uint64_t, COUNTERS> counted_{};  // of the samples so far of the units in work
  int begin_ = 0, end_ = 1;                 // samples of the pass
  std::int64_t units_done_ = 0;             // of the pass
  double unit_sample_seconds_ = 0;          // of the pass before
  double samples_done_ = 0, samples_ahead_ = 0;  // pixels times samples: of whole passes, and expected of this and later ones
  Clock::time_point start_ = Clock::now(), last_collected_ = start_;
};

int first_samples(const RenderOptions& options) {
  return options.positions.empty() ? std::max(1, options.samples) : static_cast<int>(options.positions.size());
}

std::vector<std::array<double, 2>> samples_of(const RenderOptions& options) {
  if (!options.positions.empty()) return options.positions;
  const int first = first_samples(options);
  return pixel_samples(options.sample_error > 0 ? std::max(first, options.most_samples) : first);
}

// Rows are ends of tiles only where units are pixels or fill rows.
std::int64_t row_units_of(int width, const ItemLayout& layout) {
  return width % layout.pixels_per_unit() == 0 ? width / layout.pixels_per_unit() : 0;
}

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
  if (tile.sample_end == end_ - begin_) units_done_ = tile.first_unit + tile.unit_count;
}

// What a tile counted goes with its first unit, as a pass of its own.
TileKey key_of_counters(TileKey tile, std::int64_t unit) {
  tile.pass = -1 - tile.pass;
  tile.first_unit = unit;
  tile.unit_count = 1;
  return tile;
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

bool Renderer::run_pass(const std::vector<std::int32_t>* pixels, int begin, int end) {
  begin_ = begin;
  end_ = end;
  units_done_ = 0;
  list_pixels(pixels);
  gather_.begin_pass(pixels, begin, end);
  TileSchedule schedule(layout_.units(), pixels ? 0 : row_units_of(frame_.width, layout_), end - begin, units_that_fit(),
                        options_.tile_seconds, unit_sample_seconds_);
  const bool whole = run_tiles(schedule);
  unit_sample_seconds_ = schedule.unit_sample_seconds();
  if (report_.passes++ == 0) report_.seconds_first_pass = seconds_since(start_);
  samples_done_ += static_cast<double>(units_done_) / static_cast<double>(layout_.units()) *
                   static_cast<double>(layout_.pixels) * (end - begin);
  return whole;
}

double Renderer::mean_radiance() const {
  double sum = 0;
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w)
    for (std::size_t p = 0; p < frame_.plane(); ++p) sum += static_cast<double>(frame_.component(0, w)[p]);
  return sum / static_cast<double>(frame_.lambda_nm.size()) / static_cast<double>(frame_.plane());
}

// Further samples where they matter, pass by pass.
void Renderer::refine() {
  gather_.estimate_errors();
  // Where edges are nearly everywhere, one sample a pixel and those of its neighbours miss too much.
  constexpr double everywhere = 0.5;
  if (end_ == 1 && gather_.part_at_edges() > everywhere && !run_pass(nullptr, 1, next_count(1))) {
    report_.interrupted = true;
    return;
  }
  for (;;) {
    gather_.estimate_errors();
    const double target = options_.sample_error * mean_radiance();
    const auto passes = next_passes(frame_.sample_error, frame_.samples, target, options_.most_samples);
    if (passes.empty()) {
      report_.sample_error_kept = root_mean_square(frame_.sample_error) <= target;
      return;
    }
    samples_ahead_ = 0;
    for (const SamplePass& pass : passes)
      samples_ahead_ += static_cast<double>(pass.pixels.size()) * (pass.end - pass.begin);
    for (const SamplePass& pass : passes) {
      const double before = samples_done_;
      if (!run_pass(&pass.pixels, pass.begin, pass.end)) {
        gather_.estimate_errors();
        report_.interrupted = true;
        return;
      }
      samples_ahead_ -= samples_done_ - before;
    }
  }
}

void Renderer::tell_errors() {
  report_.samples_mean = samples_done_ / static_cast<double>(frame_.plane());
  report_.mean_radiance = mean_radiance();
  double error = std::numeric_limits<double>::quiet_NaN();
  if (!frame_.sample_error.empty())
    error = root_mean_square(frame_.sample_error);
  else if (end_ > 1)
    error = gather_.halves_rms;
  report_.sample_error = report_.mean_radiance > 0 ? error / report_.mean_radiance : error;
}

void Renderer::run() {
  const int first = first_samples(options_);
  report_.interrupted = !run_pass(nullptr, 0, first);
  if (!report_.interrupted && options_.sample_error > 0) refine();
  if (!report_.interrupted && frame_.sample_error.empty()) gather_.estimate_errors();
  gather_.finish();
  report_.seconds = seconds_since(start_);
  tell_errors();
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
  check_sampling(scene, options);
  Frame frame = options.pixels.empty() ? make_frame(scene, scene.width, scene.height, lambda_nm, weight_nm)
                                       : make_frame(scene, static_cast<int>(options.pixels.size()), 1, lambda_nm, weight_nm);
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

std::string render_identity(const Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
                            const RenderOptions& options) {
  std::string data;
  const auto put = [&data](const auto& values) {
    data.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    data += ';';
  };
  put(scene.ints);
  put(scene.reals);
  put(scene.tables);
  put(scene.mixing);
  put(lambda_nm);
  put(options.positions);
  put(options.pixels);
  const DeviceInfo& about = info(device);
  return fmt::format("{} {} x {}, {} channels, features {:#x}{}, {} samples, error {:.17g} by {}; {} {} lanes of {}; kernels {}; {}",
                     hash_text(data), scene.width, scene.height, scene.channels, scene.features,
                     options.kernel.generic ? " generic" : "", options.samples, options.sample_error, options.most_samples,
                     fmt::format("{} {} {}", about.name, about.version, about.driver), lanes_on(device, options.kernel), options.kernel.real_double ? "double" : "float",
                     hash_text(expand_includes("trace.cl")), OUT_COMPONENTS);
}

BuildReport prepare_kernel(Device& device, std::uint32_t features, const KernelOptions& options) {
  const auto kernel = trace_kernel(device, features, options);
  keep(*kernel);
  return kernel->report;
}

}  // namespace nicol
