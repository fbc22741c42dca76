#include "host/mpi/remote_executor.hpp"

#include <fmt/format.h>

namespace nicol {

RemoteExecutor::RemoteExecutor(Post& post, Peer& peer, double patience_s, Parcel job) : post_(post), peer_(peer), patience_s_(patience_s) {
  peer_.ready = false;
  peer_.traced.clear();
  peer_.failure.clear();
  ++peer_.epoch;
  post_.mail().send(peer_.rank, Message::job, std::move(job));
}

RemoteExecutor::~RemoteExecutor() {
  ++peer_.epoch;   // what still comes is void
  peer_.traced.clear();
  if (!peer_.lost) post_.mail().send(peer_.rank, Message::job_end, {});
}

// Throws what the rank has reported, or that it says nothing any more.
void RemoteExecutor::check() {
  post_.look();
  if (!peer_.failure.empty()) {
    const std::string failure = std::exchange(peer_.failure, "");
    if (peer_.shortage) throw ShortageError(failure);
    throw DeviceError(failure);
  }
  const double silent_s = std::chrono::duration<double>(Peer::Clock::now() - peer_.heard).count();
  if (in_flight_ == 0 || !peer_.traced.empty() || silent_s < patience_s_) return;
  peer_.lost = true;
  throw DeviceError(fmt::format("{} has not answered for {:.0f} s", peer_.place, silent_s));
}

bool RemoteExecutor::started() {
  check();
  return peer_.ready;
}

void RemoteExecutor::begin_pass(const std::vector<std::int32_t>& listed, int begin, int end) {
  post_.mail().send(peer_.rank, Message::pass, BytesOut().put(++peer_.epoch).put(begin).put(end).put_all(listed).take());
}

void RemoteExecutor::submit(const Tile& tile, std::int64_t most_units) {
  TileOrder order;
  order.epoch = peer_.epoch;
  order.most_units = most_units;
  order.tile = tile;
  if (in_flight_++ == 0) peer_.heard = Peer::Clock::now();
  post_.mail().send(peer_.rank, Message::tile, BytesOut().put(order).take());
}

bool RemoteExecutor::ready() {
  check();
  return !peer_.traced.empty();
}

TracedTile RemoteExecutor::collect() {
  const Parcel& bytes = peer_.traced.front();
  BytesIn in(bytes);
  const auto head = in.get<TracedHead>();
  TracedTile traced;
  traced.tile = head.tile;
  traced.counted = head.counted;
  traced.seconds = head.seconds;
  traced.sums = bytes.data() + sizeof head;
  return traced;
}

void RemoteExecutor::release() {
  peer_.traced.pop_front();
  --in_flight_;
}

void RemoteExecutor::drop() {
  peer_.traced.clear();
  peer_.failure.clear();
  in_flight_ = 0;
  if (!peer_.lost) post_.mail().send(peer_.rank, Message::drop, BytesOut().put(++peer_.epoch).take());
}

}  // namespace nicol
