// Cuts a picture into launches that take about the same time, for one executor or several. Knows nothing of OpenCL.
#pragma once
#include <cstdint>
#include <map>

namespace nicol {

// A launch: units (pixels, or blocks of `lanes` pixels) first_unit .. first_unit + unit_count, samples begin .. end.
struct Tile {
  std::int64_t first_unit = 0, unit_count = 0;
  int sample_begin = 0, sample_end = 0;
};

// The units of a pass that nobody has in work.
class UnitPool {
 public:
  // row_units: units in a row of the picture; ranges end with rows where they hold a whole one. 0: do not mind rows.
  UnitPool(std::int64_t units, std::int64_t row_units);

  // The first `wanted` units at most, as a tile without samples; unit_count 0: there are none.
  Tile take(std::int64_t wanted);
  void give_back(std::int64_t first_unit, std::int64_t unit_count);
  std::int64_t left() const { return left_; }

 private:
  std::map<std::int64_t, std::int64_t> ranges_;   // first unit: count; no two touch
  std::int64_t row_units_, left_;
};

// The launches of one executor.
class TileSchedule {
 public:
  // Launches hold at most this many samples of a pixel. Fixed, so that sums of samples round alike
  // whatever the tiles.
  static constexpr int samples_per_launch = 16;

  // unit_sample_seconds: what a sample of a unit may be expected to take (0: not known).
  TileSchedule(UnitPool& pool, int samples, std::int64_t max_units, double tile_seconds, double unit_sample_seconds = 0);

  // The next launch: all samples of some units, then further units of the pool. False if there are none at present.
  // sharers: executors that take from the pool; tiles get smaller towards its end, so that all end together.
  bool next(Tile& tile, int sharers = 1);

  // The tile that next() gave holds no more than its first units; samples not begun yet.
  void cut(Tile& tile, std::int64_t units);

  // What `tile` took decides the size of those to come.
  void took(const Tile& tile, double seconds);

  // What next() gave has been given back to the pool.
  void restart() { current_ = {}; }

  // After a shortage of memory: tiles of half the size. False if they cannot shrink.
  bool shrink();

  std::int64_t max_units() const { return max_units_; }
  double unit_sample_seconds() const { return unit_sample_seconds_; }

 private:
  std::int64_t units_in_time() const;

  UnitPool* pool_;
  std::int64_t max_units_, wanted_units_;
  int samples_;
  double tile_seconds_, unit_sample_seconds_ = 0;
  Tile current_;
};

}  // namespace nicol
