// One render of a packed scene: passes of samples, whose tiles are dealt by demand to the executors; what comes back is gathered, kept in
// the journal, told. One thread drives all of it.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "host/opencl/executor.hpp"
#include "host/opencl/gather.hpp"
#include "host/opencl/render.hpp"
#include "host/opencl/tiles.hpp"

namespace nicol {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Renderer {
 public:
  // lanes: of the packed scene, and so of all executors. report.shares has one entry for each executor.
  Renderer(std::vector<std::unique_ptr<TileExecutor>> executors, const PackedScene& scene, const RenderOptions& options, int lanes,
           Frame& frame, RenderReport& report);
  void run();

 private:
  // Units that an executor has in work.
  struct Range {
    Tile tile;                                     // all samples of the units
    int samples_done = 0;
    std::array<std::uint64_t, COUNTERS> counted{}; // of these samples
    DeviceShare traced;                            // of these: not found in the journal
  };

  // An executor and what it has to do.
  struct Worker {
    std::unique_ptr<TileExecutor> executor;
    std::size_t share = 0;                         // in report.shares
    std::optional<TileSchedule> schedule;          // of the pass; none before it takes part in it
    std::optional<Tile> next;                      // dealt, not launched
    std::deque<Range> ranges;
    double unit_sample_seconds = 0;                // of the pass before
    Clock::time_point last_collected{};
    std::deque<Clock::time_point> submitted;
  };

  // Samples [begin, end) of these pixels of the frame (null: all).
  bool run_pass(const std::vector<std::int32_t>* pixels, int begin, int end);
  bool run_tiles();
  void refine();
  void list_pixels(const std::vector<std::int32_t>* pixels);
  bool drive(std::size_t worker);
  bool begin(Worker& worker);
  bool feed(Worker& worker);
  bool next_tile(Worker& worker);
  std::int64_t alike_in_journal(const Tile& tile) const;
  static std::deque<Range>::iterator range_of(Worker& worker, const Tile& tile);
  void collect(Worker& worker);
  bool take_from_journal(Worker& worker, const Tile& tile);
  void keep_in_journal(const TracedTile& traced);
  void gathered(Worker& worker, const Tile& tile, const void* sums, const Counters& counted);
  void tell_tile(const Tile& tile);
  void give_back(Worker& worker);
  void lose(std::size_t worker, const DeviceError& error);
  bool alone() const { return workers_.size() == 1 && workers_.front().executor->here(); }
  TileKey key_of(const Tile& tile) const {
    return {report_.passes, tile.first_unit, tile.unit_count, begin_ + tile.sample_begin, begin_ + tile.sample_end};
  }
  std::size_t bytes_per_unit() const {
    return static_cast<std::size_t>(layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes) * scalar_bytes_;
  }
  void tell_progress();
  void tell_errors();
  double mean_radiance() const;
  bool cancelled() const { return options_.cancel && options_.cancel->load(); }
  bool give_up_waiting();

  const PackedScene& scene_;
  const RenderOptions& options_;
  Frame& frame_;
  RenderReport& report_;
  const std::size_t scalar_bytes_;
  ItemLayout layout_;                       // of the pass
  Gather gather_;
  std::vector<Worker> workers_;
  std::optional<UnitPool> pool_;            // of the pass
  std::vector<std::int32_t> listed_;        // pixels of the scene's picture in this pass; empty: all
  int begin_ = 0, end_ = 1;                 // samples of the pass
  std::int64_t units_done_ = 0;             // of the pass
  double unit_samples_done_ = 0;            // of the pass
  double samples_done_ = 0, samples_ahead_ = 0;  // pixels times samples: of whole passes, and expected of this and later ones
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> cancelled_at_;
};

}  // namespace nicol
