// Tracing, chunk by chunk and stage by stage.
#include <algorithm>
#include <cmath>

#include "host/opencl/samples.hpp"
#include "host/preview/pane.hpp"

namespace nicol::preview {
namespace {

constexpr double chunk_seconds = 0.06, tile_seconds = 0.015;
constexpr std::size_t smallest_chunk = 2048;

std::uint64_t errors_in(const RenderReport& report) {
  return report.nan_count + report.energy_count + report.stack_count + report.stokes_count;
}

}  // namespace

void Pane::enter_stage() {
  const Stage& stage = stages_[static_cast<std::size_t>(stage_)];
  pixels_.clear();
  if (!stage.adaptive) pixels_ = pixels_of(stage, first_stage(), prepared_->width, prepared_->height);
  at_ = 0;
  if (!first_stage()) return;
  pixels_ahead_ = 0;
  const double plane = static_cast<double>(prepared_->width) * prepared_->height;
  for (const Stage& s : stages_) pixels_ahead_ = std::max(pixels_ahead_, plane * s.sample_end);
}

// The first stage is given up for another look only where it takes long and a coarser one would not.
bool Pane::is_given_up(Clock::time_point begun, int step) const {
  constexpr std::chrono::milliseconds patience{300};
  const std::lock_guard<std::mutex> held(lock_);
  return quit_ || stopped_ || (wanted_ && step < coarsest_step && Clock::now() - begun > patience);
}

// The stage's next pixels: the first stage at once, else what fits a chunk.
RenderOptions Pane::next_chunk(const Stage& stage) const {
  std::size_t count = pixels_.size() - at_;
  if (!first_stage() && pixel_seconds_ > 0) {
    const double fits = std::min(chunk_seconds / (pixel_seconds_ * (stage.sample_end - stage.sample_begin)), 1e9);
    count = std::min(count, std::max(smallest_chunk, static_cast<std::size_t>(fits)));
  }
  RenderOptions options;
  options.kernel = kernel_;
  options.tile_seconds = tile_seconds;
  const auto positions = pixel_samples(stage.sample_end);
  options.positions.assign(positions.begin() + stage.sample_begin, positions.end());
  options.pixels.assign(pixels_.begin() + static_cast<std::ptrdiff_t>(at_), pixels_.begin() + static_cast<std::ptrdiff_t>(at_ + count));
  return options;
}

void Pane::trace() {
  const Stage stage = stages_[static_cast<std::size_t>(stage_)];
  const int samples = stage.sample_end - stage.sample_begin;
  RenderOptions options = next_chunk(stage);
  const std::size_t count = options.pixels.size();
  std::atomic<bool> given_up{false};
  double traced = 0;   // part of it
  const auto begun = Clock::now();
  if (first_stage())
    options.progress = [&](const Progress& now) {
      traced = now.fraction;
      given_up = is_given_up(begun, stage.step);
    };
  options.cancel = first_stage() ? &given_up : &cancel_;
  RenderReport report;
  const Scene& scene = prepared_->scene;
  const Frame part = render(*device_, prepared_->packed, scene.lambda_nm, scene.weight_nm, options, report);
  if (report.interrupted) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    if (first_stage() && traced > 0) pixel_seconds_ = seconds / (traced * static_cast<double>(count));
    tracing_ = tracing_ && !first_stage();
    return;
  }
  sink_.expect(options.pixels.data(), count, samples, stage.step);
  sink_.write(part);
  at_ += count;
  pixels_traced_ += static_cast<double>(count) * samples;
  pixel_seconds_ = report.seconds / (static_cast<double>(count) * samples);
  pass_seconds_ += report.seconds;
  pass_samples_ += static_cast<double>(count) * samples;
  pass_kernels_ |= specialised_ ? 2 : 1;
  tell(report);
  if (at_ == pixels_.size()) finish_stage();
}

void Pane::tell(const RenderReport& report) {
  update([&](PaneStatus& s) {
    s.segments_per_second = static_cast<double>(report.segments) / std::max(report.seconds, 1e-9);
    s.counted_errors += errors_in(report);
    s.cut_off_worst = std::max(s.cut_off_worst, report.cut_off_worst);
    s.fraction = std::min(1.0, pixels_traced_ / std::max(pixels_ahead_, 1.0));
  });
}

// What a sample of every pixel takes, set against what it takes with every effect, by a kernel of the same kind.
void Pane::note_pass(double seconds, bool specialised) {
  double& all_effects = all_effects_seconds_[specialised];
  update([&](PaneStatus& s) {
    s.pass_seconds = seconds;
    if (s.without.empty()) all_effects = seconds;
    s.all_effects_pass_seconds = all_effects;
  });
}

void Pane::time_pass() {
  const double plane = static_cast<double>(prepared_->width) * prepared_->height;
  timed_specialised_ = pass_samples_ >= plane && pass_kernels_ == 2;
  if (timed_specialised_ || (pass_samples_ >= plane && pass_kernels_ == 1)) note_pass(pass_seconds_ * plane / pass_samples_, timed_specialised_);
  pass_seconds_ = pass_samples_ = 0;
  pass_kernels_ = 0;
}

void Pane::time_kernel() {
  if (tracing_ || !specialised_ || timed_specialised_ || waits_for_kernel_) return;
  constexpr int grid = 4;
  RenderOptions options;
  options.kernel = kernel_;
  options.cancel = &cancel_;
  options.pixels = pixels_of({grid, 0, 1, false}, true, prepared_->width, prepared_->height);
  RenderReport report;
  render(*device_, prepared_->packed, prepared_->scene.lambda_nm, prepared_->scene.weight_nm, options, report);
  if (report.interrupted) return;
  timed_specialised_ = true;
  const double plane = static_cast<double>(prepared_->width) * prepared_->height;
  note_pass(report.seconds * plane / static_cast<double>(options.pixels.size()), true);
}

void Pane::finish_stage() {
  const Stage stage = stages_[static_cast<std::size_t>(stage_)];
  {
    const std::lock_guard<std::mutex> held(picture_lock_);
    picture_.step = stage.step;
  }
  const double mean = mean_radiance_of(picture_);   // only this thread changes the picture
  const double change2 = sink_.take_change2();
  {
    const std::lock_guard<std::mutex> held(picture_lock_);
    picture_.mean_radiance = mean;
    ++picture_.version;
  }
  const bool whole = stage.step == 1;
  if (whole) time_pass();
  update([&](PaneStatus& s) {
    if (first_stage()) s.seconds_to_first = std::chrono::duration<double>(Clock::now() - asked_).count();
    s.step = stage.step;
    if (!whole) return;
    s.samples = stage.sample_end;
    ++s.passes;
    if (stage.sample_begin == 0 || mean <= 0) return;
    // The error of n samples goes as n^-3/4 (sampling_plan.hpp); the mean of n became that of m: its change is what both are off by.
    const double values = static_cast<double>(prepared_->width) * prepared_->height * static_cast<double>(prepared_->scene.lambda_nm.size());
    const double ratio = static_cast<double>(stage.sample_end) / stage.sample_begin;
    s.sample_error = std::sqrt(change2 / values) / mean / std::sqrt(std::pow(ratio, 1.5) - 1);
  });
  if (static_cast<std::size_t>(++stage_) < stages_.size()) return enter_stage();
  tracing_ = false;
  update([](PaneStatus& s) {
    s.working = false;
    s.done = true;
    s.fraction = 1;
  });
  time_kernel();
}

// To the scene's sampling error: one render of the whole picture, samples where they matter.
void Pane::trace_adaptively() {
  RenderOptions options;
  options.kernel = kernel_;
  options.tile_seconds = tile_seconds;
  options.cancel = &cancel_;
  options.sample_error = prepared_->scene.settings.sample_error;
  options.progress = [&](const Progress& now) { update([&](PaneStatus& s) { s.fraction = now.fraction; }); };
  PackedScene packed = pack(prepared_->scene, prepared_->geometry, prepared_->features | path_signatures_bit(), prepared_->width,
                            prepared_->height, lanes_on(*device_, kernel_));
  options.kernel.generic = true;   // signatures are an effect of the kernel: the specialised one has them not
  long_ = true;
  RenderReport report;
  Frame frame = render(*device_, packed, prepared_->scene.lambda_nm, prepared_->scene.weight_nm, options, report);
  long_ = false;
  if (report.interrupted) return;
  sink_.write_whole(std::move(frame));
  sink_.take_change2();
  tell(report);
  finish_stage();
  update([&](PaneStatus& s) {
    s.samples = report.samples_mean;
    s.passes += report.passes - 1;
    s.sample_error = report.sample_error;
  });
}

}  // namespace nicol::preview
