// Turns: panes that share one thread, jobs and their ends, folders that are watched. On the OpenCL device.
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>

#include "host/app/preview_command.hpp"
#include "host/preview/file_watch.hpp"
#include "host/preview/latest_job.hpp"
#include "host/preview/pane.hpp"

namespace nicol::preview {
namespace {

namespace fs = std::filesystem;

// What another thread tells, waited for.
class Bell {
 public:
  void ring() {
    {
      const std::lock_guard<std::mutex> held(lock_);
      ++rung_;
    }
    news_.notify_all();
  }
  // So often as it has rung once no more comes.
  int settled() {
    constexpr std::chrono::milliseconds quiet{300};   // several times what a watch waits for
    std::unique_lock<std::mutex> held(lock_);
    for (int seen = -1; seen != rung_;) {
      seen = rung_;
      news_.wait_for(held, quiet, [&] { return rung_ != seen; });
    }
    return rung_;
  }
  bool rings(int times) {
    std::unique_lock<std::mutex> held(lock_);
    return news_.wait_for(held, std::chrono::seconds(60), [&] { return rung_ >= times; });
  }

 private:
  std::mutex lock_;
  std::condition_variable news_;
  int rung_ = 0;
};

SessionOptions two_panes(const std::string& change) {
  app::PreviewCommand command;
  command.scene = std::string(SCENES_FOLDER) + "/founding/fig5_active.pov";
  command.options.width = command.options.height = 32;
  command.options.wavelengths = "420:680:130";
  command.options.samples = 1;
  command.right = {change};
  command.size_given = true;
  return app::preview_session(command);
}

struct TwoPanes {
  explicit TwoPanes(const std::string& change) : options(two_panes(change)) {
    left.ask(look(0));
    right.ask(look(0));
  }
  static Look look(double yaw_rad) {
    Look look;
    look.width = look.height = 32;
    look.navigation.yaw_rad = yaw_rad;
    return look;
  }
  // The pane that the working thread would take: the more urgent one, of equals the one that had no turn last.
  Pane& next() {
    const int of_left = left.urgency(), of_right = right.urgency();
    had_turn = of_left < of_right || (of_left == of_right && had_turn != &left) ? &left : &right;
    return *had_turn;
  }
  static bool shows(const Pane& pane) { return pane.with_picture([](const Picture& p) { return p.step > 0; }); }
  static std::uint64_t version(const Pane& pane) { return pane.picture_version_now().value(); }

  SessionOptions options;
  std::atomic<bool> quit{false};
  Bell built;
  SideBuilder builder{[this] { left.kernels_changed(); right.kernels_changed(); }, [this] { built.ring(); }};
  Pane left{options.left, builder, options, quit}, right{*options.right, builder, options, quit};
  Pane* had_turn = nullptr;
};

TEST_CASE("both panes show something new while the mouse moves on and on") {
  TwoPanes panes("without rotation");
  for (int piece = 0; piece < 4000 && (!TwoPanes::shows(panes.left) || !TwoPanes::shows(panes.right)); ++piece) {
    if (std::min(panes.left.urgency(), panes.right.urgency()) == Pane::nothing) REQUIRE(panes.built.rings(1));
    panes.next().work();
  }
  REQUIRE(TwoPanes::shows(panes.left));
  REQUIRE(TwoPanes::shows(panes.right));
  const std::uint64_t left = TwoPanes::version(panes.left), right = TwoPanes::version(panes.right);
  for (int piece = 1; piece <= 40; ++piece) {   // another look after every piece of work
    panes.left.ask(TwoPanes::look(0.01 * piece));
    panes.right.ask(TwoPanes::look(0.01 * piece));
    panes.next().work();
    CHECK(TwoPanes::shows(panes.left));         // the one before stays until the next has come
  }
  CHECK(TwoPanes::version(panes.left) >= left + 9);
  CHECK(TwoPanes::version(panes.right) >= right + 9);
}

TEST_CASE("settings that keep an error are chosen after a first picture") {
  TwoPanes panes("error 1%");
  bool chosen = false, shown_first = false;
  for (int piece = 0; piece < 4000 && !chosen; ++piece) {
    if (std::min(panes.left.urgency(), panes.right.urgency()) == Pane::nothing) REQUIRE(panes.built.rings(1));
    panes.next().work();
    chosen = panes.right.status().chosen.find("after a first picture") == std::string::npos && !panes.right.status().chosen.empty();
    if (!chosen) shown_first = panes.left.status().step == 1 && panes.right.status().step == 1;
  }
  CHECK(chosen);
  CHECK(shown_first);
}

TEST_CASE("a pane that is stopped has nothing to do") {
  TwoPanes panes("without rotation");
  panes.right.stop();
  CHECK(panes.right.urgency() == Pane::nothing);
  panes.right.work();
  CHECK(panes.right.status().reading);
  CHECK_FALSE(panes.right.prepared());
}

TEST_CASE("when the end of a job is told, it is idle") {
  Bell ended;
  LatestJob* job = nullptr;
  std::atomic<int> idle{0};
  LatestJob made(false, [&] {
    idle += job->idle() ? 1 : 0;
    ended.ring();
  });
  job = &made;
  for (int i = 1; i <= 100; ++i) {
    made.post([] {});
    REQUIRE(ended.rings(i));
  }
  CHECK(idle == 100);
}

TEST_CASE("files are watched through folders that go and come, and beside others that are written all the time") {
  const fs::path folder = fs::temp_directory_path() / ("nicol_watch_" + std::to_string(getpid()));
  const auto write = [&](const char* name) { std::ofstream(folder / name) << "text\n"; };
  fs::create_directories(folder);
  write("a.pov");
  Bell changed;
  FileWatch watch([&] { changed.ring(); });
  watch.watch({(folder / "a.pov").string()}, false);
  CHECK(watch.failure() == "");
  write("a.pov");
  CHECK(changed.rings(1));

  int before = changed.settled();
  fs::remove_all(folder);
  CHECK(changed.rings(before + 1));
  before = changed.settled();
  fs::create_directories(folder);
  CHECK(changed.rings(before + 1));
  before = changed.settled();
  write("a.pov");
  CHECK(changed.rings(before + 1));
  before = changed.settled();

  std::atomic<bool> end{false};
  std::thread other([&] {
    while (!end) write("log.txt");
  });
  write("a.pov");
  CHECK(changed.rings(before + 1));
  end = true;
  other.join();
  fs::remove_all(folder);
}

}  // namespace
}  // namespace nicol::preview
