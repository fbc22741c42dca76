// The preview without its window: two panes that are read, rendered ever finer, read again when a file changes; and what is to be told
// of them. All functions are for one thread, that of the window; the work is done on others, which call `wake` when there is something new.
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host/effects.hpp"
#include "host/opencl/render.hpp"
#include "host/preview/controls.hpp"
#include "host/preview/difference.hpp"
#include "host/preview/input.hpp"
#include "host/preview/layout.hpp"
#include "host/preview/picture.hpp"
#include "host/preview/pixel_info.hpp"
#include "host/record/path_record.hpp"

namespace nicol::preview {

// An error or a warning in a scene's text.
struct Message {
  bool error = true;
  std::string file;
  int line = 0, column = 0;                             // 0: no place
  std::string text;                                     // the message alone
  std::string told;                                     // as the command line tells it, with line and caret
  std::vector<std::pair<int, std::string>> lines;       // number and text of the lines around it
};

// What reading a scene gave.
struct ReadResult {
  std::shared_ptr<const Scene> scene;                   // null: there are errors
  std::shared_ptr<const Geometry> geometry;
  std::vector<Message> messages;
  std::vector<std::string> files;                       // that were read or looked for
  bool choice_wanted = false;                           // settings that keep an error are still to be chosen
  bool real_double = false;                             // a kept error asks for double
  std::string chosen;                                   // settings that keep an error: what was chosen, or that they are still to be; else empty
};

struct PaneSource {
  std::string title;
  std::function<ReadResult(int width, int height)> read;
  // Reads and chooses the settings that keep the scene's error. Takes long; gives no files once `cancel` is set.
  std::function<ReadResult(int width, int height, Device& device, const std::atomic<bool>& cancel)> choose;
  std::function<std::shared_ptr<Device>()> open_device; // throws DeviceError
  KernelOptions kernel;
};

struct SessionOptions {
  PaneSource left;
  std::optional<PaneSource> right;                      // none: the right pane shows the left picture's polarization
  int width = 640, height = 480;                        // of the pictures
  bool keep_camera_shape = false;                       // the size becomes the largest within that of the shape of the left scene's camera
  int most_samples = 23;                                // per pixel, uniformly; then the work rests
};

// What a pane has done with its latest scene and look.
struct PaneStatus {
  std::string title, device, real;
  bool reading = false, working = false, done = false;
  bool specialised = false, building = false;           // kernel; one is being built on the side
  bool waits_for_kernel = false;                        // none is ready: the first is being built
  std::string kernel_failure;                           // why there is no specialised one; else empty
  int step = 0;                                         // see Picture
  double samples = 0;                                   // per pixel, of passes that are whole
  int passes = 0;
  double fraction = 0;                                  // of what is to be done until it rests
  double sample_error = 0;                              // RMS, relative to the mean radiance; NaN: not known yet
  double segments_per_second = 0;
  double seconds_to_first = 0;                          // from the request to the first coarse picture
  double pass_seconds = 0;                              // of one sample of every pixel; 0: not known yet
  double all_effects_pass_seconds = 0;                  // the same with no effect left out; 0: not known
  double cut_off_worst = 0;
  std::uint64_t counted_errors = 0;                     // NaN, energy, stack, Stokes
  std::vector<Effect> effects;                          // of the scene as read
  std::vector<std::string> without;                     // left out
  std::vector<Message> messages;                        // of the latest reading
  bool stale = false;                                   // the latest reading failed: the picture is of an earlier one
  std::string failure;                                  // device or memory: why there is no picture
  std::string chosen;
  std::vector<double> lambda_nm;
  double exposure = 1;                                  // the scene's
};

// What the ray of a pixel met, in words for the panel.
struct PixelPath {
  std::vector<std::string> effects;
  std::vector<std::string> cells;                       // "Calcite (box, line 12), 3 faces, weight 0.92"
  std::string ends;                                     // "light, sky"
};

class Session {
 public:
  Session(SessionOptions options, std::function<void()> wake);
  ~Session();                                           // stops the work and waits for it

  Controls controls;

  // To be called once a turn, after the controls may have changed: hands new looks to the work, takes up what it has done. True if
  // what is shown changed.
  bool update();

  bool two_renders() const;                             // the right pane is a render of its own
  bool compares() const;                                // two renders that are meant to look alike: what they differ by can be shown
  const PaneStatus& status(int pane) const;             // pane 1 is pane 0's where there is one render
  View shown_view(int pane) const;                      // with the scrubbed wavelength
  // What a pane shows now, and a number that changes with it. The right one: the difference, if that is to be shown. It is made on another
  // thread: what takes longer than a few milliseconds comes later, and `wake` is called.
  const Developed& developed(int pane) const;
  std::uint64_t developed_version(int pane) const;
  double display_factor(int pane) const;                // of developed().rgb: exposure, and the difference's amplification
  const Difference* difference() const;                 // null: not shown (yet), or there is one render only
  void finish_showing() const;                          // for scripts: waits until developed() and difference() are those of now
  std::vector<Ellipse> ellipses(int pane, int spacing) const;

  // Of pixel (x, y) of the picture in that pane, by the controls' view.
  std::optional<PixelInfo> pixel(int pane, int x, int y) const;
  // What its ray met; found on another thread: none until then, `wake` is called.
  std::optional<PixelPath> pixel_path(int pane, int x, int y);

  bool at_rest() const;                                 // all work that could be done is done, kernels included
  bool pictures_done() const;                           // the panes' pictures are
  void reload();                                        // reads the files again
  void turn_effect(int number, bool right_only);        // of the left pane's effects, 1, 2, ...: leaves it out, or takes it back
  void reset();                                         // camera, polarizers, effects, exposure, views as at the start
  void take_window_size(double pane_width, double pane_height);   // the pictures become as large as fits there

  // Saves what is shown or known; a line that says what was written or why not comes as notice().
  void save_picture(int pane);                          // SCENE-preview.png: the colours; false colours and the difference as shown
  void save_spectra(int pane);                          // SCENE-preview.exr
  void save_camera();                                   // SCENE-camera.inc
  std::string camera_sdl() const;                       // the same text
  std::string notice() const;                           // of the last few seconds; empty: none
  void tell(std::string notice);

 private:
  struct Parts;
  bool shows_latest() const;
  std::unique_ptr<Parts> parts_;
};

// Everything that can be done by a key, for the help, the keyboard and scripts.
struct Action {
  std::string name;       // "difference"
  std::string key;        // "d", "shift+r", "F2", "left", "["
  std::string help;
  std::function<void(Session&)> act;
};
const std::vector<Action>& actions();
// By key ("d", "shift+1") or by name; digits turn effects. False: there is none.
bool act_by_key(Session& session, const std::string& key);
bool act_by_name(Session& session, const std::string& name);

}  // namespace nicol::preview
