#include "host/opencl/tiles.hpp"

#include <algorithm>

namespace nicol {

namespace {
constexpr std::int64_t first_units = 64;
constexpr int growth = 4;                 // at most, from tile to tile
constexpr std::int64_t least_shared = 16; // units: less is not worth a launch
}  // namespace

UnitPool::UnitPool(std::int64_t units, std::int64_t row_units) : row_units_(row_units), left_(units) {
  if (units > 0) ranges_[0] = units;
}

Tile UnitPool::take(std::int64_t wanted) {
  Tile tile;
  if (ranges_.empty()) return tile;
  const auto [first, count] = *ranges_.begin();
  std::int64_t end = first + std::clamp<std::int64_t>(wanted, 1, count);
  if (row_units_ > 0 && end / row_units_ > first / row_units_) end = end / row_units_ * row_units_;
  tile.first_unit = first;
  tile.unit_count = end - first;
  left_ -= tile.unit_count;
  ranges_.erase(ranges_.begin());
  if (tile.unit_count < count) ranges_[end] = count - tile.unit_count;
  return tile;
}

void UnitPool::give_back(std::int64_t first_unit, std::int64_t unit_count) {
  if (unit_count <= 0) return;
  left_ += unit_count;
  auto next = ranges_.upper_bound(first_unit);
  if (next != ranges_.end() && first_unit + unit_count == next->first) {
    unit_count += next->second;
    next = ranges_.erase(next);
  }
  if (next != ranges_.begin()) {
    const auto before = std::prev(next);
    if (before->first + before->second == first_unit) {
      before->second += unit_count;
      return;
    }
  }
  ranges_[first_unit] = unit_count;
}

TileSchedule::TileSchedule(UnitPool& pool, int samples, std::int64_t max_units, double tile_seconds, double unit_sample_seconds)
    : pool_(&pool), max_units_(std::max<std::int64_t>(1, std::min(max_units, pool.left()))),
      wanted_units_(std::min(first_units, max_units_)), samples_(samples), tile_seconds_(tile_seconds),
      unit_sample_seconds_(unit_sample_seconds) {
  if (unit_sample_seconds > 0) wanted_units_ = units_in_time();
}

bool TileSchedule::next(Tile& tile, int sharers) {
  if (current_.unit_count > 0 && current_.sample_end < samples_) {
    current_.sample_begin = current_.sample_end;
  } else {
    std::int64_t wanted = std::clamp<std::int64_t>(wanted_units_, 1, max_units_);
    if (sharers > 1) wanted = std::min(wanted, std::max(least_shared, pool_->left() / (2 * sharers)));
    current_ = pool_->take(wanted);
    if (current_.unit_count == 0) return false;
  }
  current_.sample_end = std::min(current_.sample_begin + samples_per_launch, samples_);
  tile = current_;
  return true;
}

void TileSchedule::cut(Tile& tile, std::int64_t units) {
  if (units >= tile.unit_count) return;
  pool_->give_back(tile.first_unit + units, tile.unit_count - units);
  current_.unit_count = tile.unit_count = units;
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

bool TileSchedule::shrink() {
  if (max_units_ == 1) return false;
  max_units_ /= 2;
  wanted_units_ = std::min(wanted_units_, max_units_);
  return true;
}

}  // namespace nicol
