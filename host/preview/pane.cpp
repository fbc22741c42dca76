#include "host/preview/pane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/channels.hpp"

namespace nicol::preview {
namespace {

constexpr int every_pixel_once = 8;   // an urgency: after the stages of one sample a pixel

bool fits(const Picture& picture, const Prepared& prepared) {
  return picture.frame.width == prepared.width && picture.frame.height == prepared.height &&
         picture.frame.lambda_nm == prepared.scene.lambda_nm;
}

}  // namespace

Pane::Pane(PaneSource source, SideBuilder& builder, const SessionOptions& options, const std::atomic<bool>& quit)
    : source_(std::move(source)), builder_(builder), options_(options), quit_(quit) {
  status_.title = source_.title;
  status_.reading = true;
  status_.sample_error = std::numeric_limits<double>::quiet_NaN();
}

void Pane::ask(const Look& look) {
  const std::lock_guard<std::mutex> held(lock_);
  if (!wanted_) asked_ = Clock::now();
  wanted_ = look;
  cancel_ = true;
}

void Pane::ask_read() {
  const std::lock_guard<std::mutex> held(lock_);
  read_wanted_ = true;
  status_.reading = true;
  cancel_ = true;
}

void Pane::yield() {
  if (long_) cancel_ = true;
}

void Pane::stop() {
  const std::lock_guard<std::mutex> held(lock_);
  stopped_ = cancel_ = true;
}

int Pane::urgency() const {
  const std::lock_guard<std::mutex> held(lock_);
  if (stopped_) return nothing;
  if (read_wanted_) return 0;
  if ((wanted_ && scene_) || first_is_in_work()) return 1;
  if (look_for_kernel_ && prepared_) return 2;
  if (choice_is_due()) return every_pixel_once;
  return tracing_ && !waits_for_kernel_ ? 2 + stage_ : nothing;
}

void Pane::work() {
  bool to_read = false, to_begin = false, to_choose = false;
  {
    const std::lock_guard<std::mutex> held(lock_);
    if (stopped_) return;
    to_read = read_wanted_;
    // What is seen first is finished: something new is seen even while the mouse moves on and on.
    to_begin = wanted_ && scene_ && !first_is_in_work();
    to_choose = choice_is_due();
    cancel_ = quit_.load();
  }
  long_ = false;
  try {
    if (to_read) return read();
    if (to_begin) return begin();
    if (look_for_kernel_.exchange(false)) {
      choose_kernel();
      time_kernel();
    }
    if (to_choose) return choose_settings();
    if (waits_for_kernel_ || !tracing_) return;
    if (stages_[static_cast<std::size_t>(stage_)].adaptive) trace_adaptively();
    else trace();
  } catch (const std::bad_alloc&) {
    fail("the memory does not suffice for this picture");
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

void Pane::fail(const std::string& why) {
  tracing_ = false;
  update([&](PaneStatus& s) {
    s.failure = why;
    s.working = s.reading = s.building = false;
    s.done = true;
    choice_wanted_ = false;
  });
}

void Pane::read() {
  std::shared_ptr<Device> device;
  int width = 0, height = 0;
  {
    const std::lock_guard<std::mutex> held(lock_);
    read_wanted_ = false;
    device = device_;
    const Look& look = wanted_ ? *wanted_ : look_ ? *look_ : Look{};
    width = look.width;
    height = look.height;
    if (scene_ || !wanted_) asked_ = Clock::now();
  }
  if (!device) device = source_.open_device();
  ReadResult result = source_.read(width, height);
  const std::lock_guard<std::mutex> held(lock_);
  device_ = device;
  status_.device = info(*device).name;
  take(std::move(result));
}

// One render after another; when something more urgent comes it is given up, and begun anew later.
void Pane::choose_settings() {
  const Look look = *look_;
  long_ = true;
  ReadResult result = source_.choose(look.width, look.height, *device_, cancel_);
  long_ = false;
  const std::lock_guard<std::mutex> held(lock_);
  if (!result.files.empty() && !read_wanted_) take(std::move(result));
}

void Pane::take(ReadResult result) {
  files_ = result.files;
  choice_wanted_ = result.choice_wanted;
  status_.reading = read_wanted_;
  status_.messages = std::move(result.messages);
  status_.stale = !result.scene;
  status_.failure.clear();
  if (!result.scene) {
    if (!scene_) status_.done = true;
    return;
  }
  scene_ = result.scene;
  geometry_ = result.geometry;
  real_double_ = result.real_double;
  status_.chosen = result.chosen;
  status_.effects = effects_of(*scene_);
  status_.lambda_nm = scene_->lambda_nm;
  status_.exposure = scene_->settings.exposure;
  status_.all_effects_pass_seconds = 0;
  all_effects_seconds_ = {};
  if (!wanted_ && look_) wanted_ = look_;
}

void Pane::begin() {
  Look look;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Geometry> geometry;
  {
    const std::lock_guard<std::mutex> held(lock_);
    look = *wanted_;
    wanted_.reset();
    scene = scene_;
    geometry = geometry_;
  }
  auto prepared = prepare(*scene, *geometry, look, lanes_on(*device_, wanted_kernel()));
  {
    const std::lock_guard<std::mutex> held(lock_);
    const bool same_features = prepared_ && prepared_->features == prepared->features;
    if (!same_features) pixel_seconds_ = 0;
    prepared_ = std::move(prepared);
    if (look_ && (look_->width != look.width || look_->height != look.height)) all_effects_seconds_ = {};
    look_ = look;
    status_.without.clear();
    for (const Effect& effect : status_.effects)
      if (look.without.count(effect.name) > 0) status_.without.push_back(effect.name);
    status_.failure.clear();
    status_.working = true;
    status_.done = false;
    status_.samples = status_.fraction = status_.pass_seconds = status_.all_effects_pass_seconds = 0;
    status_.passes = 0;
    status_.sample_error = std::numeric_limits<double>::quiet_NaN();
    status_.counted_errors = 0;
    status_.cut_off_worst = 0;
    status_.seconds_to_first = 0;
    status_.step = 0;
  }
  resize_picture();
  choose_kernel();
  const Settings& settings = prepared_->scene.settings;
  stages_ = stages(first_step(look.width, look.height, pixel_seconds_), std::max(settings.samples, options_.most_samples),
                   settings.sample_error > 0);
  pass_seconds_ = pass_samples_ = pixels_traced_ = 0;
  pass_kernels_ = 0;
  stage_ = 0;
  enter_stage();
  tracing_ = true;
}

void Pane::resize_picture() {
  const std::lock_guard<std::mutex> held(picture_lock_);
  const Scene& scene = prepared_->scene;
  const bool same_size = fits(picture_, *prepared_);
  sink_.begin_anew(same_size);
  if (!same_size) {
    const std::uint64_t version = picture_.version;
    picture_ = make_picture(prepared_->width, prepared_->height, scene.lambda_nm, scene.weight_nm);
    picture_.version = version + 1;
  }
  picture_.frame.exposure = scene.settings.exposure;
  picture_.brightest_radiance = brightest_radiance(scene);
}

KernelOptions Pane::wanted_kernel() const {
  KernelOptions wanted = source_.kernel;
  wanted.real_double = wanted.real_double || real_double_;
  return wanted;
}

void Pane::choose_kernel() {
  const KernelOptions wanted = wanted_kernel();
  const KernelChoice choice = builder_.choose(device_, prepared_->packed.contents(), wanted);
  kernel_ = choice.options;
  specialised_ = choice.specialised;
  waits_for_kernel_ = !choice.ready;
  update([&](PaneStatus& s) {
    s.real = wanted.real_double ? "double" : "float";
    s.specialised = choice.ready && choice.specialised;
    s.building = choice.building;
    s.waits_for_kernel = !choice.ready;
    s.kernel_failure = choice.failure;
  });
}

PaneStatus Pane::status() const {
  const std::lock_guard<std::mutex> held(lock_);
  PaneStatus status = status_;
  status.reading = read_wanted_ || status_.reading;
  return status;
}
std::vector<std::string> Pane::files() const {
  const std::lock_guard<std::mutex> held(lock_);
  return files_;
}
std::shared_ptr<const Prepared> Pane::prepared() const {
  const std::lock_guard<std::mutex> held(lock_);
  return prepared_;
}
std::shared_ptr<const Scene> Pane::scene() const {
  const std::lock_guard<std::mutex> held(lock_);
  return scene_;
}
std::shared_ptr<Device> Pane::device() const {
  const std::lock_guard<std::mutex> held(lock_);
  return device_;
}
std::optional<std::uint64_t> Pane::picture_version_now() const {
  const std::unique_lock<std::mutex> held(picture_lock_, std::try_to_lock);
  return held ? std::optional(picture_.version) : std::nullopt;
}

}  // namespace nicol::preview
