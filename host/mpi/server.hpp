// A rank that traces for rank 0.
#pragma once
#include <chrono>
#include <deque>
#include <string>

#include "host/mpi/mail.hpp"

namespace nicol {

class Server {
 public:
  Server(int rank, int on_node, std::string place, std::string build)
      : rank_(rank), on_node_(on_node), place_(std::move(place)), build_(std::move(build)) {}

  // Until rank 0 ends it. The exit code.
  int run();

 private:
  using Clock = std::chrono::steady_clock;
  bool take_letters();
  void take(const Letter& letter);
  void begin_job(const Letter& letter);
  void open_device_for(const JobMessage& job);
  bool work();
  void send_oldest();
  void say(Message what, Parcel bytes);
  void fail(const std::string& reason, bool shortage);

  const int rank_, on_node_;
  const std::string place_, build_;
  Mail mail_;
  bool ended_ = false;
  std::string wanted_device_;
  std::shared_ptr<Device> device_;
  JobMessage job_;
  std::unique_ptr<TileExecutor> executor_;
  std::int64_t epoch_ = 0;
  bool void_ = false;                      // failed: what comes until the next epoch is void
  std::deque<TileOrder> orders_;
  std::deque<Clock::time_point> submitted_;
  Clock::time_point last_traced_{}, last_said_ = Clock::now(), last_heard_ = Clock::now();
};

}  // namespace nicol
