// One pane's work: its scene read, prepared as it is looked at, traced ever finer. `work()` is for one thread, that of the work; all else
// for any.
#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host/preview/look.hpp"
#include "host/preview/picture_sink.hpp"
#include "host/preview/session.hpp"
#include "host/preview/side_builder.hpp"
#include "host/preview/stages.hpp"

namespace nicol::preview {

class Pane {
 public:
  Pane(PaneSource source, SideBuilder& builder, const SessionOptions& options, const std::atomic<bool>& quit);

  void ask(const Look& look);             // in place of what is in work
  void ask_read();                        // reads its files again
  void stop();                            // for good: what is in work ends soon
  void yield();                           // something else is more urgent than a stage that takes long
  void kernels_changed() { look_for_kernel_ = true; }

  static constexpr int nothing = 1 << 20;
  int urgency() const;                    // of its next piece of work; lower first, `nothing`: there is none
  void work();                            // one piece, some tens of milliseconds where it can be cut

  PaneStatus status() const;
  std::vector<std::string> files() const;
  std::shared_ptr<const Prepared> prepared() const;
  std::shared_ptr<const Scene> scene() const;   // as read
  std::shared_ptr<Device> device() const;
  const KernelOptions& kernel() const { return source_.kernel; }

  // The picture, held still while `use` reads it.
  template <class Use>
  auto with_picture(Use use) const {
    const std::lock_guard<std::mutex> held(picture_lock_);
    return use(picture_);
  }
  std::mutex& picture_lock() const { return picture_lock_; }
  const Picture& picture() const { return picture_; }   // with picture_lock held
  std::optional<std::uint64_t> picture_version_now() const;   // none: it is being changed

 private:
  using Clock = std::chrono::steady_clock;

  void read();
  void take(ReadResult result);           // with lock_ held
  void choose_settings();                 // that keep an error
  void begin();                           // prepares the scene as it is to be looked at
  void resize_picture();
  KernelOptions wanted_kernel() const;
  void choose_kernel();
  void trace();                           // a chunk of the stage in work
  void trace_adaptively();
  void enter_stage();
  void finish_stage();
  void tell(const RenderReport& report);
  void time_pass();
  void time_kernel();                     // that came after the picture was done
  void note_pass(double seconds, bool specialised);
  void fail(const std::string& why);
  template <class Change>
  void update(Change change) {
    const std::lock_guard<std::mutex> held(lock_);
    change(status_);
  }
  bool first_stage() const { return stage_ == 0; }
  RenderOptions next_chunk(const Stage& stage) const;
  bool first_is_in_work() const { return tracing_ && first_stage() && !waits_for_kernel_; }
  bool choice_is_due() const { return choice_wanted_ && !waits_for_kernel_ && (!tracing_ || status_.step == 1); }   // with lock_ held
  bool is_given_up(Clock::time_point begun, int step) const;

  const PaneSource source_;
  SideBuilder& builder_;
  const SessionOptions& options_;
  const std::atomic<bool>& quit_;

  mutable std::mutex lock_;               // of what follows
  PaneStatus status_;
  std::optional<Look> wanted_;            // not begun yet
  std::optional<Look> look_;              // in work
  bool read_wanted_ = true, choice_wanted_ = false, stopped_ = false;
  Clock::time_point asked_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Geometry> geometry_;
  std::vector<std::string> files_;
  std::shared_ptr<const Prepared> prepared_;
  std::shared_ptr<Device> device_;
  std::atomic<bool> cancel_{false}, long_{false}, look_for_kernel_{false}, waits_for_kernel_{false}, tracing_{false};
  std::atomic<int> stage_{0};

  mutable std::mutex picture_lock_;
  Picture picture_;

  // of the working thread
  KernelOptions kernel_;
  bool real_double_ = false, specialised_ = false, timed_specialised_ = false;
  PictureSink sink_{picture_, picture_lock_};
  std::vector<Stage> stages_;
  std::vector<std::int32_t> pixels_;      // of the stage
  std::size_t at_ = 0;                    // the next of them
  double pixel_seconds_ = 0;              // of a sample; 0: not known
  double pass_seconds_ = 0, pass_samples_ = 0;
  double pixels_traced_ = 0, pixels_ahead_ = 0;
  unsigned pass_kernels_ = 0;             // that it was traced with: bit 0 generic, bit 1 specialised
  std::array<double, 2> all_effects_seconds_{};   // with every effect, by the generic and by the specialised kernel; 0: not known
};

}  // namespace nicol::preview
