// One render of a packed scene: tiles in flight on two queues, so that the device always has the next one; passes of samples; tiles
// kept in the journal and found there.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/gather.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/render.hpp"
#include "host/opencl/tiles.hpp"
#include "kernels/abi.h"

namespace nicol {

using Clock = std::chrono::steady_clock;
using Counters = std::array<cl_uint, COUNTERS>;

inline double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Samples that every pixel gets.
inline int first_samples(const RenderOptions& options) {
  return options.positions.empty() ? std::max(1, options.samples) : static_cast<int>(options.positions.size());
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

}  // namespace nicol
