// Cuts a picture into launches that take about the same time. Knows nothing of OpenCL.
#pragma once
#include <cstdint>

namespace nicol {

// A launch: units (pixels, or blocks of `lanes` pixels) first_unit .. first_unit + unit_count, samples begin .. end.
struct Tile {
  std::int64_t first_unit = 0, unit_count = 0;
  int sample_begin = 0, sample_end = 0;
};

class TileSchedule {
 public:
  // Launches hold at most this many samples of a pixel. Fixed, so that sums of samples round alike
  // whatever the tiles.
  static constexpr int samples_per_launch = 16;

  // unit_sample_seconds: what a sample of a unit may be expected to take (0: not known).
  // row_units: units in a row of the picture; tiles end with rows where they hold a whole one. 0: do not mind rows.
  TileSchedule(std::int64_t units, std::int64_t row_units, int samples, std::int64_t max_units, double tile_seconds,
               double unit_sample_seconds = 0);

  // The next launch: all samples of some units, then further units. False at the end of the picture.
  bool next(Tile& tile);

  // The tile that next() gave holds no more than its first units; samples not begun yet.
  void cut(Tile& tile, std::int64_t units);

  // What `tile` took decides the size of those to come.
  void took(const Tile& tile, double seconds);

  // After a shortage of memory: goes back to `first_unit` with tiles of half the size. False if they cannot shrink.
  bool shrink(std::int64_t first_unit);

  std::int64_t max_units() const { return max_units_; }
  double unit_sample_seconds() const { return unit_sample_seconds_; }

 private:
  std::int64_t size_at(std::int64_t first_unit) const;
  std::int64_t units_in_time() const;

  std::int64_t units_, row_units_, max_units_, wanted_units_;
  int samples_;
  double tile_seconds_, unit_sample_seconds_ = 0;
  Tile current_;
};

}  // namespace nicol
