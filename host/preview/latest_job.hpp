// A thread that does the newest of what it is asked (what was asked before and is not begun yet is dropped), or all of it in turn.
#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace nicol::preview {

class LatestJob {
 public:
  // `after` is called from the thread after each job, when idle() tells that it is done.
  explicit LatestJob(bool all_in_turn = false, std::function<void()> after = {});
  ~LatestJob();                          // waits for the job in work, and for all in turn; else what waits is dropped
  void post(std::function<void()> job);  // must not throw
  bool idle() const;

 private:
  void run();
  mutable std::mutex lock_;
  std::condition_variable news_;
  std::deque<std::function<void()>> next_;
  const bool all_in_turn_;
  const std::function<void()> after_;
  bool busy_ = false, stop_ = false;
  std::thread thread_;
};

}  // namespace nicol::preview
