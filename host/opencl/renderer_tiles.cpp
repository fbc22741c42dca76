// The tiles of one pass: dealt, collected, kept, found.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "host/opencl/renderer.hpp"

namespace nicol {
namespace {

constexpr double patience_after_cancel_s = 0.5;   // with executors elsewhere

// What a tile counted goes with its first unit, as a pass of its own.
TileKey key_of_counters(TileKey tile, std::int64_t unit) {
  tile.pass = -1 - tile.pass;
  tile.first_unit = unit;
  tile.unit_count = 1;
  return tile;
}

}  // namespace

Renderer::Renderer(std::vector<std::unique_ptr<TileExecutor>> executors, const PackedScene& scene, const RenderOptions& options,
                   int lanes, Frame& frame, RenderReport& report)
    : scene_(scene), options_(options), frame_(frame), report_(report),
      scalar_bytes_(options.kernel.real_double ? sizeof(double) : sizeof(float)), layout_(item_layout(scene, lanes)),
      gather_(scene, lanes, frame) {
  for (auto& executor : executors) {
    workers_.emplace_back();
    workers_.back().share = report_.shares.size();
    report_.shares.emplace_back();
    workers_.back().executor = std::move(executor);
  }
}

// The pixels of the scene's picture that the kernel is to trace.
void Renderer::list_pixels(const std::vector<std::int32_t>* pixels) {
  const std::vector<std::int32_t>& base = options_.pixels;
  listed_.clear();
  if (!pixels) {
    listed_ = base;
  } else {
    for (const std::int32_t p : *pixels) listed_.push_back(base.empty() ? p : base[static_cast<std::size_t>(p)]);
  }
  layout_ = item_layout(scene_, layout_.lanes, static_cast<std::int64_t>(listed_.size()));
}

// True once the executor takes part in the pass.
bool Renderer::begin(Worker& worker) {
  if (worker.schedule) return true;
  if (!worker.executor->started()) return false;
  report_.shares[worker.share].device = worker.executor->name();
  report_.shares[worker.share].place = worker.executor->place();
  worker.executor->begin_pass(listed_, begin_, end_);
  worker.schedule.emplace(*pool_, end_ - begin_, worker.executor->units_that_fit(), options_.tile_seconds, worker.unit_sample_seconds);
  return true;
}

// From a tile's first unit on: how many units have the same of their samples in the journal.
std::int64_t Renderer::alike_in_journal(const Tile& tile) const {
  std::int64_t units = tile.unit_count;
  TileKey key = key_of(tile);
  for (key.sample_begin = begin_; key.sample_begin < end_; key.sample_begin = key.sample_end) {
    key.sample_end = std::min(key.sample_begin + TileSchedule::samples_per_launch, end_);
    const std::int64_t there = options_.journal->covered_units(key.pass, key.first_unit, key.sample_begin, key.sample_end);
    const std::int64_t missing = options_.journal->missing_units(key.pass, key.first_unit, key.sample_begin, key.sample_end);
    units = std::min(units, std::max(there, missing));
  }
  return units;
}

// Deals the next launch.
bool Renderer::next_tile(Worker& worker) {
  if (worker.next) return true;
  Tile tile;
  if (!worker.schedule->next(tile, static_cast<int>(workers_.size()))) return false;
  if (tile.sample_begin == 0) {
    if (options_.journal) worker.schedule->cut(tile, alike_in_journal(tile));
    worker.ranges.emplace_back();
    worker.ranges.back().tile = tile;
  }
  worker.next = tile;
  return true;
}

// Gives the executor tiles as long as it takes them. False if there was nothing to give.
bool Renderer::feed(Worker& worker) {
  bool fed = false;
  while (worker.executor->room() > 0 && !cancelled() && next_tile(worker)) {
    const Tile tile = *worker.next;
    const bool found = options_.journal && [&] {
      const TileKey key = key_of(tile);
      return options_.journal->covered_units(key.pass, key.first_unit, key.sample_begin, key.sample_end) >= tile.unit_count;
    }();
    if (found && worker.ranges.back().samples_done < tile.sample_begin) return fed;  // samples before these are in flight
    if (!(found && take_from_journal(worker, tile))) {
      worker.executor->submit(tile, worker.schedule->max_units());
      worker.submitted.push_back(Clock::now());
    }
    worker.next.reset();
    fed = true;
  }
  return fed;
}

std::deque<Renderer::Range>::iterator Renderer::range_of(Worker& worker, const Tile& tile) {
  return std::find_if(worker.ranges.begin(), worker.ranges.end(),
                      [&](const Range& range) { return range.tile.first_unit == tile.first_unit; });
}

void Renderer::collect(Worker& worker) {
  const TracedTile traced = worker.executor->collect();
  const Clock::time_point since = std::max(worker.last_collected, worker.submitted.front());
  worker.submitted.pop_front();
  worker.schedule->took(traced.tile, traced.seconds > 0 ? traced.seconds : seconds_since(since));
  worker.last_collected = Clock::now();
  if (report_.tiles++ == 0) report_.seconds_to_first_tile = seconds_since(start_);
  for (DeviceShare* share : {&range_of(worker, traced.tile)->traced, &report_.shares[worker.share]}) {
    ++share->tiles;
    share->segments += traced.counted[COUNT_SEGMENTS];
  }
  keep_in_journal(traced);
  gathered(worker, traced.tile, traced.sums, traced.counted);
  worker.executor->release();
}

// Counted for good when all samples of the units are done: what is given back before that starts anew.
void Renderer::gathered(Worker& worker, const Tile& tile, const void* sums, const Counters& counted) {
  if (options_.kernel.real_double)
    gather_.add(tile, static_cast<const double*>(sums));
  else
    gather_.add(tile, static_cast<const float*>(sums));
  const auto range_at = range_of(worker, tile);
  Range& range = *range_at;
  range.samples_done = tile.sample_end;
  unit_samples_done_ += static_cast<double>(tile.unit_count) * (tile.sample_end - tile.sample_begin);
  for (std::size_t i = 0; i < COUNTERS; ++i) range.counted[i] += counted[i];
  if (tile.sample_end == end_ - begin_) {
    report_.nan_count += range.counted[COUNT_NAN];
    report_.energy_count += range.counted[COUNT_ENERGY];
    report_.stack_count += range.counted[COUNT_STACK];
    report_.stokes_count += range.counted[COUNT_STOKES];
    report_.fallback_count += range.counted[COUNT_FALLBACK];
    report_.segments += range.counted[COUNT_SEGMENTS];
    units_done_ += tile.unit_count;
    worker.ranges.erase(range_at);
    tell_tile(tile);
  }
  tell_progress();
}

void Renderer::tell_tile(const Tile& tile) {
  if (!options_.tile) return;
  const std::vector<std::int32_t> pixels = gather_.pixels_of(tile);
  options_.tile(frame_, pixels.data(), pixels.size());
}

void Renderer::keep_in_journal(const TracedTile& traced) {
  if (!options_.journal || seconds_since(start_) < options_.journal_after_seconds) return;
  const TileKey key = key_of(traced.tile);
  options_.journal->add(key_of_counters(key, key.first_unit), traced.counted.data(), sizeof(Counters));
  options_.journal->add(key, traced.sums, bytes_per_unit() * static_cast<std::size_t>(traced.tile.unit_count));
}

// False if the file cannot be read there.
bool Renderer::take_from_journal(Worker& worker, const Tile& tile) {
  const TileKey key = key_of(tile);
  std::vector<unsigned char> bytes(bytes_per_unit() * static_cast<std::size_t>(tile.unit_count));
  if (!options_.journal->find(key, bytes_per_unit(), bytes.data())) return false;
  Counters counted, sum{};
  for (std::int64_t unit = key.first_unit; unit < key.first_unit + key.unit_count; ++unit)
    if (options_.journal->find(key_of_counters(key, unit), sizeof counted, counted.data()))
      std::transform(sum.begin(), sum.end(), counted.begin(), sum.begin(), std::plus<>());
  ++report_.tiles_found;
  gathered(worker, tile, bytes.data(), sum);
  return true;
}

void Renderer::tell_progress() {
  if (!options_.progress) return;
  Progress now;
  const double of_pass = static_cast<double>(layout_.pixels) * (end_ - begin_);
  const double part = unit_samples_done_ / (static_cast<double>(layout_.units()) * (end_ - begin_));
  now.fraction = (samples_done_ + part * of_pass) / (samples_done_ + std::max(of_pass, samples_ahead_));
  now.seconds = seconds_since(start_);
  now.seconds_left = now.fraction > 0 ? now.seconds * (1 - now.fraction) / now.fraction : 0;
  now.segments_per_second = static_cast<double>(report_.segments) / std::max(now.seconds, 1e-9);
  options_.progress(now);
}

// What is in flight is lost, and all units that it has in work will be dealt again: nobody's share holds them twice. After cancelling
// they stay in its share, being kept in the journal.
void Renderer::give_back(Worker& worker) {
  worker.executor->drop();
  for (const Range& range : worker.ranges) {
    gather_.forget(range.tile.first_unit);
    unit_samples_done_ -= static_cast<double>(range.tile.unit_count) * range.samples_done;
    pool_->give_back(range.tile.first_unit, range.tile.unit_count);
    if (cancelled()) continue;
    report_.shares[worker.share].tiles -= range.traced.tiles;
    report_.shares[worker.share].segments -= range.traced.segments;
  }
  worker.ranges.clear();
  worker.submitted.clear();
  worker.next.reset();
  if (worker.schedule) worker.schedule->restart();
}

// The others do without it.
void Renderer::lose(std::size_t index, const DeviceError& error) {
  const bool had_work = !workers_[index].ranges.empty();
  give_back(workers_[index]);
  report_.notes.push_back(fmt::format("{}\n  {}", error.what(),
                                      !had_work              ? "The picture is rendered without it."
                                      : workers_.size() == 2 ? "Its tiles went to the other device."
                                                             : "Its tiles went to the others."));
  workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
}

// False if nothing has moved. Throws what the last executor fails with.
bool Renderer::drive(std::size_t index) {
  Worker& worker = workers_[index];
  try {
    if (!begin(worker)) return false;
    const bool fed = feed(worker);
    if (worker.executor->in_flight() == 0 || (alone() ? fed : !worker.executor->ready())) return fed;
    collect(worker);
    return true;
  } catch (const ShortageError& error) {
    give_back(worker);
    if (worker.schedule && worker.schedule->shrink()) return true;
    if (workers_.size() == 1) throw;
    lose(index, error);
  } catch (const DeviceError& error) {
    if (workers_.size() == 1) {
      give_back(worker);
      throw;
    }
    lose(index, error);
  }
  return true;
}

// After cancelling, what is in flight elsewhere may not come any more.
bool Renderer::give_up_waiting() {
  if (!cancelled()) return false;
  if (!cancelled_at_) cancelled_at_ = Clock::now();
  return seconds_since(*cancelled_at_) > patience_after_cancel_s &&
         std::none_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.executor->here() && w.executor->in_flight() > 0; });
}

// False if it was cancelled.
bool Renderer::run_tiles() {
  for (;;) {
    bool moved = false;
    for (std::size_t i = 0; i < workers_.size();) {
      const std::size_t before = workers_.size();
      moved = drive(i) || moved;
      if (workers_.size() == before) ++i;
    }
    const bool busy =
        std::any_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.executor->in_flight() > 0; });
    if (units_done_ == layout_.units() || (cancelled() && !busy) || give_up_waiting()) break;
    if (!moved) std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
  for (Worker& worker : workers_) {
    if (!worker.ranges.empty()) give_back(worker);
    if (worker.schedule) worker.unit_sample_seconds = worker.schedule->unit_sample_seconds();
    worker.schedule.reset();
  }
  return units_done_ == layout_.units();
}

}  // namespace nicol
