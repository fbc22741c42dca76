#include "host/preview/latest_job.hpp"

#include <utility>

namespace nicol::preview {

LatestJob::LatestJob(bool all_in_turn, std::function<void()> after)
    : all_in_turn_(all_in_turn), after_(std::move(after)), thread_([this] { run(); }) {}

LatestJob::~LatestJob() {
  {
    const std::lock_guard<std::mutex> held(lock_);
    stop_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void LatestJob::post(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> held(lock_);
    if (!all_in_turn_) next_.clear();
    next_.push_back(std::move(job));
  }
  news_.notify_all();
}

bool LatestJob::idle() const {
  const std::lock_guard<std::mutex> held(lock_);
  return !busy_ && next_.empty();
}

void LatestJob::run() {
  std::unique_lock<std::mutex> held(lock_);
  for (;;) {
    news_.wait(held, [&] { return stop_ || !next_.empty(); });
    if (stop_ && (!all_in_turn_ || next_.empty())) return;
    const auto job = std::move(next_.front());
    next_.pop_front();
    busy_ = true;
    held.unlock();
    job();
    held.lock();
    busy_ = false;
    if (!after_) continue;
    held.unlock();
    after_();
    held.lock();
  }
}

}  // namespace nicol::preview
