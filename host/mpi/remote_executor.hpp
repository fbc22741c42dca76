// An executor on another rank, as rank 0 sees it.
#pragma once
#include <chrono>
#include <deque>
#include <string>

#include "host/mpi/mail.hpp"

namespace nicol {

// What rank 0 knows of another rank.
struct Peer {
  using Clock = std::chrono::steady_clock;
  int rank = 0;
  std::string place;            // "rank 3 on node7"
  bool lost = false;
  bool gone = false;            // has said its last word
  bool ready = false;           // for the job
  std::string device;
  std::int64_t units_that_fit = 1;
  std::deque<Parcel> traced;     // of the epoch
  std::int64_t epoch = 0;
  std::string failure;          // "": none
  bool shortage = false;
  Clock::time_point heard = Clock::now();
};

class Post {
 public:
  virtual ~Post() = default;
  virtual Mail& mail() = 0;
  virtual void look() = 0;      // takes in what has come, from all peers
};

class RemoteExecutor : public TileExecutor {
 public:
  // patience_s: so long may a rank that owes something be silent.
  // job: of the epoch peer.epoch + 1.
  RemoteExecutor(Post& post, Peer& peer, double patience_s, Parcel job);
  ~RemoteExecutor() override;
  std::string name() const override { return peer_.device; }
  std::string place() const override { return peer_.place; }
  bool here() const override { return false; }
  bool started() override;
  void begin_pass(const std::vector<std::int32_t>& listed, int begin, int end) override;
  std::int64_t units_that_fit() const override { return peer_.units_that_fit; }
  int room() const override { return most_in_flight - in_flight_; }
  int in_flight() const override { return in_flight_; }
  void submit(const Tile& tile, std::int64_t most_units) override;
  bool ready() override;
  TracedTile collect() override;
  void release() override;
  void drop() override;

 private:
  static constexpr int most_in_flight = 4;   // two on the device, two on their way
  void check();

  Post& post_;
  Peer& peer_;
  const double patience_s_;
  int in_flight_ = 0;
};

}  // namespace nicol
