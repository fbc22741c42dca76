// The inside of a session: panes, the thread that works for them, and what was made of their pictures. For session*.cpp only.
#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <thread>

#include "host/preview/file_watch.hpp"
#include "host/preview/latest_job.hpp"
#include "host/preview/pane.hpp"
#include "host/preview/session.hpp"

namespace nicol::preview {

struct Session::Parts {
  Parts(SessionOptions session_options, const Controls& controls, std::function<void()> wake_window);
  ~Parts();

  // ---- work ----
  void run();                                   // the working thread
  std::shared_ptr<Pane> most_urgent();          // among equals the one that had no turn last
  void rest();                                  // nothing to do: kernels are kept for the next start
  void notify();                                // there is something to do
  void set_panes(std::vector<std::shared_ptr<Pane>> panes);
  std::vector<std::shared_ptr<Pane>> panes() const;
  void ask(int pane, const Look& look);

  // ---- what the window's thread keeps ----
  Look look_of(const Controls& controls, bool right) const;
  void sync_panes(const Controls& controls);
  void take_first_scene(Controls& controls);
  bool wants_right(const Controls& controls) const;
  void tell(std::string text);

  // What a pane is to show: a picture, or the difference of two.
  struct ToShow {
    std::shared_ptr<const Pane> of, other;      // other: null but for a difference
    View view;
    bool same_kind(const ToShow& o) const;      // but for the pictures' versions
  };
  struct Shown {
    ToShow what;
    std::uint64_t picture = 0, other = 0;       // their versions
    Developed developed;
    Difference difference;
    std::chrono::steady_clock::time_point at;
  };
  struct Showing {
    Shown now;                                  // of the window's thread
    std::uint64_t version = 0;
    std::optional<Shown> next;                  // with show_lock
    bool in_work = false;                       // with show_lock
  };
  bool show(std::size_t pane, const ToShow& what);   // true: what is shown is the latest; else that is begun
  void take_next(Showing& own);
  void make_shown(std::size_t pane, const ToShow& what);

  struct Ellipses {
    std::weak_ptr<const Pane> of;
    std::uint64_t picture = 0;
    View view;
    int spacing = 0;
    std::vector<Ellipse> found;
  };
  struct Pixel {
    std::weak_ptr<const Pane> of;
    std::optional<PixelInfo> info;
  };
  struct Path {
    std::shared_ptr<const Prepared> prepared;
    int x = -1, y = -1;
    std::size_t wavelength = 0;
    std::optional<PixelPath> found;
    std::shared_ptr<std::atomic<bool>> given_up;   // tells the job that looks for it
  };

  const SessionOptions options;
  const std::function<void()> wake;
  Controls at_start;
  std::atomic<bool> quit{false};
  mutable std::mutex panes_lock;
  std::condition_variable news;
  std::vector<std::shared_ptr<Pane>> panes_;
  const Pane* had_turn = nullptr;               // of the working thread
  std::uint64_t requests = 0;                   // with panes_lock
  std::atomic<std::uint64_t> pieces{0};         // of work done
  std::atomic<bool> resting{false};
  std::uint64_t pieces_seen = 0;
  std::array<std::optional<Look>, 2> asked;
  std::array<PaneStatus, 2> status;
  std::mutex show_lock;
  std::condition_variable shown_news;
  std::array<Showing, 2> showing;
  std::array<Ellipses, 2> ellipses;
  std::array<Pixel, 2> pixels;
  bool first_scene_taken = false;
  std::vector<std::string> watched;
  bool watched_any_new = false;
  mutable std::mutex path_lock;
  std::array<Path, 2> path;
  mutable std::mutex notice_lock;
  std::string notice;
  std::chrono::steady_clock::time_point notice_until;

  // threads, ended in the opposite order
  SideBuilder builder;
  std::array<LatestJob, 2> witness;             // of the left and the right pane
  std::array<LatestJob, 2> shower;
  LatestJob saver{true};
  FileWatch watch;
  std::thread worker;
};

}  // namespace nicol::preview
