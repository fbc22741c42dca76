#include "host/mpi/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "host/mpi/ranks.hpp"

namespace nicol {
namespace {

constexpr auto short_nap = std::chrono::microseconds(300), long_nap = std::chrono::microseconds(3000);
constexpr auto awake_for = std::chrono::seconds(1), sign_of_life_every = std::chrono::seconds(1);

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

int Server::run() {
  while (!ended_) {
    const bool heard = take_letters(), worked = work();
    if (heard || worked) {
      last_heard_ = Clock::now();
      continue;
    }
    const bool owes = !orders_.empty() || (executor_ && executor_->in_flight() > 0);
    if (owes && Clock::now() - last_said_ > sign_of_life_every) say(Message::alive, {});
    std::this_thread::sleep_for(Clock::now() - last_heard_ < awake_for ? short_nap : long_nap);
  }
  executor_.reset();
  say(Message::bye, {});
  while (!mail_.all_sent()) {
    mail_.receive();
    std::this_thread::sleep_for(short_nap);
  }
  return 0;
}

bool Server::take_letters() {
  bool any = false;
  for (auto letter = mail_.receive(); letter; letter = mail_.receive()) {
    take(*letter);
    any = true;
  }
  return any;
}

void Server::take(const Letter& letter) {
  BytesIn in(letter.bytes);
  switch (letter.what) {
    case Message::job: begin_job(letter); return;
    case Message::pass: {
      epoch_ = in.get<std::int64_t>();
      void_ = !executor_;
      const int begin = in.get<int>(), end = in.get<int>();
      const auto listed = in.get_all<std::vector<std::int32_t>>();
      try {
        if (executor_) executor_->begin_pass(listed, begin, end);
      } catch (const std::exception& error) {
        fail(error.what(), false);
      }
      return;
    }
    case Message::tile: {
      const auto order = in.get<TileOrder>();
      if (order.epoch == epoch_ && !void_) orders_.push_back(order);
      return;
    }
    case Message::drop:
      epoch_ = in.get<std::int64_t>();
      void_ = !executor_;
      orders_.clear();
      submitted_.clear();
      if (executor_) executor_->drop();
      return;
    case Message::job_end:
      orders_.clear();
      submitted_.clear();
      executor_.reset();
      return;
    case Message::end: ended_ = true; return;
    default: return;
  }
}

// A device is opened once, unless rank 0 wants another.
void Server::open_device_for(const JobMessage& job) {
  if (device_ && wanted_device_ == job.device) return;
  device_ = open_device(device_of_rank(job.device, on_node_));
  wanted_device_ = job.device;
}

void Server::begin_job(const Letter& letter) {
  executor_.reset();
  orders_.clear();
  submitted_.clear();
  try {
    job_ = read_job(letter.bytes, build_);
    epoch_ = job_.epoch;
    void_ = false;
    if (job_.build != build_)
      throw DeviceError("it runs another build of nicol than rank 0 (version or kernels differ): start the same on all machines");
    open_device_for(job_);
    BuildReport build;
    executor_ = open_executor(*device_, job_.scene, job_.options, build);
    const DeviceInfo& about = info(*device_);
    say(Message::ready, BytesOut().put(epoch_).put_all(place_).put_all(about.name).put(executor_->units_that_fit()).take());
  } catch (const std::exception& error) {
    executor_.reset();
    fail(error.what(), false);
  }
}

// Keeps the device fed, and sends what it has traced.
bool Server::work() {
  if (!executor_) return false;
  bool moved = false;
  try {
    for (; !orders_.empty() && executor_->room() > 0; orders_.pop_front(), moved = true) {
      executor_->submit(orders_.front().tile, orders_.front().most_units);
      submitted_.push_back(Clock::now());
    }
    if (executor_->in_flight() > 0 && executor_->ready()) {
      send_oldest();
      moved = true;
    }
  } catch (const ShortageError& error) {
    fail(error.what(), true);
  } catch (const std::exception& error) {
    fail(error.what(), false);
  }
  return moved;
}

void Server::send_oldest() {
  const TracedTile traced = executor_->collect();
  TracedHead head;
  head.epoch = epoch_;
  head.tile = traced.tile;
  head.seconds = std::max(1e-9, seconds(Clock::now() - std::max(last_traced_, submitted_.front())));
  head.counted = traced.counted;
  submitted_.pop_front();
  last_traced_ = Clock::now();
  const ItemLayout layout = item_layout(job_.scene, job_.options.kernel.lanes);
  const std::size_t scalar_bytes = job_.options.kernel.real_double ? sizeof(double) : sizeof(float);
  const std::int64_t values = traced.tile.unit_count * layout.items_per_unit() * OUT_COMPONENTS * layout.lanes;
  say(Message::traced, BytesOut().put(head).put_bytes(traced.sums, static_cast<std::size_t>(values) * scalar_bytes).take());
  executor_->release();
}

void Server::say(Message what, Parcel bytes) {
  mail_.send(0, what, std::move(bytes));
  last_said_ = Clock::now();
}

void Server::fail(const std::string& reason, bool shortage) {
  void_ = true;
  orders_.clear();
  submitted_.clear();
  if (executor_) executor_->drop();
  say(Message::failed, BytesOut().put(epoch_).put(shortage).put_all(fmt::format("{}: {}", place_, reason)).take());
}

}  // namespace nicol
