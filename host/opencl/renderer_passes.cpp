// Passes of samples: every pixel first, then those where samples matter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/opencl/renderer.hpp"
#include "host/opencl/sampling_plan.hpp"

namespace nicol {
namespace {

// Rows are ends of tiles only where units are pixels or fill rows.
std::int64_t row_units_of(int width, const ItemLayout& layout) {
  return width % layout.pixels_per_unit() == 0 ? width / layout.pixels_per_unit() : 0;
}

// "a", or "2 x a; b".
std::string names_of(const std::vector<DeviceShare>& shares) {
  std::string names;
  for (auto share = shares.begin(); share != shares.end(); ++share) {
    const auto is_it = [&](const DeviceShare& other) { return other.device == share->device; };
    if (share->device.empty() || std::any_of(shares.begin(), share, is_it)) continue;
    const auto count = std::count_if(share, shares.end(), is_it);
    names += (names.empty() ? "" : "; ") + (count > 1 ? fmt::format("{} x ", count) : "") + share->device;
  }
  return names;
}

}  // namespace

bool Renderer::run_pass(const std::vector<std::int32_t>* pixels, int begin, int end) {
  begin_ = begin;
  end_ = end;
  units_done_ = 0;
  unit_samples_done_ = 0;
  list_pixels(pixels);
  gather_.begin_pass(pixels, begin, end);
  pool_.emplace(layout_.units(), pixels ? 0 : row_units_of(frame_.width, layout_));
  const bool whole = run_tiles();
  if (report_.passes++ == 0) report_.seconds_first_pass = seconds_since(start_);
  samples_done_ += static_cast<double>(units_done_) / static_cast<double>(layout_.units()) *
                   static_cast<double>(layout_.pixels) * (end - begin);
  return whole;
}

double Renderer::mean_radiance() const {
  double sum = 0;
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w)
    for (std::size_t p = 0; p < frame_.plane(); ++p) sum += static_cast<double>(frame_.component(0, w)[p]);
  return sum / static_cast<double>(frame_.lambda_nm.size()) / static_cast<double>(frame_.plane());
}

// Further samples where they matter, pass by pass.
void Renderer::refine() {
  gather_.estimate_errors();
  // Where edges are nearly everywhere, one sample a pixel and those of its neighbours miss too much.
  constexpr double everywhere = 0.5;
  if (end_ == 1 && gather_.part_at_edges() > everywhere && !run_pass(nullptr, 1, next_count(1))) {
    report_.interrupted = true;
    return;
  }
  for (;;) {
    gather_.estimate_errors();
    const double target = options_.sample_error * mean_radiance();
    const auto passes = next_passes(frame_.sample_error, frame_.samples, target, options_.most_samples);
    if (passes.empty()) {
      report_.sample_error_kept = root_mean_square(frame_.sample_error) <= target;
      return;
    }
    samples_ahead_ = 0;
    for (const SamplePass& pass : passes)
      samples_ahead_ += static_cast<double>(pass.pixels.size()) * (pass.end - pass.begin);
    for (const SamplePass& pass : passes) {
      const double before = samples_done_;
      if (!run_pass(&pass.pixels, pass.begin, pass.end)) {
        gather_.estimate_errors();
        report_.interrupted = true;
        return;
      }
      samples_ahead_ -= samples_done_ - before;
    }
  }
}

void Renderer::tell_errors() {
  report_.samples_mean = samples_done_ / static_cast<double>(frame_.plane());
  report_.mean_radiance = mean_radiance();
  double error = std::numeric_limits<double>::quiet_NaN();
  if (!frame_.sample_error.empty())
    error = root_mean_square(frame_.sample_error);
  else if (end_ > 1)
    error = gather_.halves_rms;
  report_.sample_error = report_.mean_radiance > 0 ? error / report_.mean_radiance : error;
}

void Renderer::run() {
  const int first = first_samples(options_);
  report_.interrupted = !run_pass(nullptr, 0, first);
  if (!report_.interrupted && options_.sample_error > 0) refine();
  if (!report_.interrupted && frame_.sample_error.empty()) gather_.estimate_errors();
  gather_.finish();
  report_.device = names_of(report_.shares);
  report_.seconds = seconds_since(start_);
  tell_errors();
  report_.cut_off_mean = gather_.cut_off_mean;
  report_.cut_off_worst = gather_.cut_off_worst;
}

}  // namespace nicol
