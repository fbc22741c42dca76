#include "host/opencl/tiles.hpp"

#include <algorithm>

namespace nicol {

namespace {
constexpr std::int64_t first_units = 64;
constexpr int growth = 4;   // at most, from tile to tile
}  // namespace

TileSchedule::TileSchedule(std::int64_t units, std::int64_t row_units, int samples, std::int64_t max_units,
                           double tile_seconds, double unit_sample_seconds)
    : units_(units), row_units_(row_units), max_units_(std::max<std::int64_t>(1, std::min(max_units, units))),
      wanted_units_(std::min(first_units, max_units_)), samples_(samples), tile_seconds_(tile_seconds),
      unit_sample_seconds_(unit_sample_seconds) {
  if (unit_sample_seconds > 0) wanted_units_ = units_in_time();
}

std::int64_t TileSchedule::size_at(std::int64_t first_unit) const {
  std::int64_t end = std::min(first_unit + std::clamp<std::int64_t>(wanted_units_, 1, max_units_), units_);
  if (row_units_ > 0 && end / row_units_ > first_unit / row_units_) end = end / row_units_ * row_units_;
  return end - first_unit;
}

bool TileSchedule::next(Tile& tile) {
  if (current_.unit_count > 0 && current_.sample_end < samples_) {
    current_.sample_begin = current_.sample_end;
  } else {
    current_.first_unit += current_.unit_count;
    if (current_.first_unit >= units_) return false;
    current_.unit_count = size_at(current_.first_unit);
    current_.sample_begin = 0;
  }
  current_.sample_end = std::min(current_.sample_begin + samples_per_launch, samples_);
  tile = current_;
  return true;
}

void TileSchedule::cut(Tile& tile, std::int64_t units) {
  if (units < tile.unit_count) current_.unit_count = tile.unit_count = units;
}

void TileSchedule::took(const Tile& tile, double seconds) {
  const double measured =
      seconds / (static_cast<double>(tile.unit_count) * (tile.sample_end - tile.sample_begin));
  // A cheap stretch (background) must not make the next tile too long: the estimate falls by half at most.
  unit_sample_seconds_ = std::max(measured, unit_sample_seconds_ / 2);
  wanted_units_ = std::min(units_in_time(), tile.unit_count * growth);
}

std::int64_t TileSchedule::units_in_time() const {
  const int launch_samples = std::min(samples_, samples_per_launch);
  const double wanted = tile_seconds_ / std::max(unit_sample_seconds_ * launch_samples, 1e-12);
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(wanted, static_cast<double>(max_units_))));
}

bool TileSchedule::shrink(std::int64_t first_unit) {
  if (max_units_ == 1) return false;
  max_units_ /= 2;
  wanted_units_ = std::min(wanted_units_, max_units_);
  current_ = {};
  current_.first_unit = first_unit;
  return true;
}

}  // namespace nicol
