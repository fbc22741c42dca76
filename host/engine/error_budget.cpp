#include "host/engine/error_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host/accuracy/picture_error.hpp"
#include "host/engine/render_summary.hpp"
#include "host/engine/spot_check.hpp"

namespace nicol::engine {
namespace {

constexpr int most_pixels = 4096, least_pixels = 64;
constexpr double part_of_time = 0.05;  // of the picture's time, for each check
constexpr double least_seconds = 0.1;
// One sample against so many, on few enough pixels to take a quarter of the picture's time.
constexpr int fine_samples = 9, pixels_per_check = 4 * fine_samples;

// As many pixels as the time allows.
int pixels_to_check(int width, int height, const RenderReport& report) {
  const double samples = std::max(1.0, report.samples_mean) * width * height;
  const double seconds_per_sample = report.seconds / samples;
  const double allowed = std::max(least_seconds, part_of_time * report.seconds) / std::max(seconds_per_sample, 1e-12);
  const int most = std::min(most_pixels, width * height);
  return std::clamp(static_cast<int>(std::min<double>(allowed, most)), std::min(least_pixels, most), most);
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

// How much longer a variant took; below that the machine's noise tells more than the work.
std::string times_text(const RenderReport& variant, const RenderReport& base) {
  constexpr double measurable_s = 0.02;
  if (std::min(variant.seconds, base.seconds) < measurable_s) {
    const double work = ratio(static_cast<double>(variant.segments), static_cast<double>(base.segments));
    return variant.real == base.real ? fmt::format("{:.2f} x the segments", work) : "more time";
  }
  return fmt::format("{:.2f} x the time", ratio(variant.seconds, base.seconds));
}

class Budget {
 public:
  Budget(const LoadedScene& loaded, int width, int height, Device& device, const RenderOptions& options,
         const Frame& frame, const RenderReport& report)
      : loaded_(loaded), options_(options), frame_(frame), report_(report), device_(device),
        check_(loaded.scene, loaded.geometry, loaded.features.mask, width, height, device, options.kernel,
               pixels_to_check(width, height, report)) {
    check_.cancel = options.cancel;
  }

  ErrorBudget run() {
    base_ = check({});
    add(cut_off());
    add(spectral());
    add(sampling());
    add(rounding());
    add(solids());
    add(counters());
    budget_.pixels = check_.pixels();
    budget_.rms = std::sqrt(sum2_);
    budget_.stopped = stopped();
    return std::move(budget_);
  }

 private:
  bool stopped() const { return options_.cancel && options_.cancel->load(); }

  void add(BudgetLine line) {
    if (std::isfinite(line.rms)) sum2_ += line.rms * line.rms;
    budget_.lines.push_back(std::move(line));
  }

  SpotPicture check(const Variant& variant) {
    SpotPicture picture = check_.render(variant);
    budget_.seconds += picture.report.seconds + picture.report.build.seconds;
    return picture;
  }

  // Relative to the picture's mean radiance.
  double off(const SpotPicture& a, const SpotPicture& b) const {
    const double of_reference = picture_error(a.frame, b.frame).stokes_rms;
    return report_.mean_radiance > 0 ? of_reference * b.report.mean_radiance / report_.mean_radiance : of_reference;
  }

  BudgetLine cut_off() {
    BudgetLine line;
    line.source = "cut-off";
    const double bright = ratio(brightest_radiance(loaded_.scene), report_.mean_radiance);
    const std::string bound =
        fmt::format("bound: mean {:.2g}, worst pixel {:.2g}", report_.cut_off_mean * bright, report_.cut_off_worst * bright);
    const Settings& s = loaded_.scene.settings;
    Variant finer;
    finer.adc_bailout = std::max(s.adc_bailout, 1e-12) / 10;
    finer.max_trace_level = std::min(2 * s.max_trace_level, 4096);
    line.detail = bound;
    if (stopped()) return line;
    const SpotPicture picture = check(finer);
    line.seconds = picture.report.seconds;
    line.rms = off(base_, picture);
    line.price = fmt::format("adc_bailout {:g} and max_trace_level {}: {}", finer.adc_bailout, finer.max_trace_level,
                             times_text(picture.report, base_.report));
    return line;
  }

  BudgetLine spectral() const {
    BudgetLine line;
    line.source = "spectral step";
    if (frame_.lambda_nm.size() == 1) {
      line.rms = 0;
      line.detail = "one wavelength is all there is";
      return line;
    }
    const SpectralStep step = spectral_step(frame_);
    if (!step.known) {
      line.detail = "not known: " + step.reason;
      return line;
    }
    line.rms = step.xyz_rms;
    line.detail = fmt::format("of XYZ; CIEDE2000 mean {:.2g}, 95 % below {:.2g}, worst {:.2g}", step.ciede_mean, step.ciede_95,
                              step.ciede_worst);
    line.price = "half the step, a quarter of it: twice the wavelengths";
    return line;
  }

  BudgetLine sampling() {
    BudgetLine line;
    line.source = "sampling";
    if (!frame_.samples.empty() || report_.samples_mean > 3) {
      line.rms = report_.sample_error;
      line.seconds = report_.seconds - (report_.passes > 1 ? report_.seconds_first_pass : 0);
      line.detail = report_.passes > 1
                        ? fmt::format("{}, {} in the first pass, more where faces or waves change", samples_text(report_.samples_mean),
                                      options_.samples)
                        : fmt::format("{}: {}", samples_text(report_.samples_mean),
                                      frame_.samples.empty() ? "half the difference of their halves"
                                                             : "from each pixel's spread and its neighbours");
    } else if (!stopped()) {
      const int few = std::min(check_.pixels(), std::max(least_pixels, frame_.width * frame_.height / pixels_per_check));
      const SpotCheck fewer(loaded_.scene, loaded_.geometry, loaded_.features.mask, frame_.width, frame_.height, device_,
                            options_.kernel, few);
      Variant as_rendered, finer;
      as_rendered.samples = options_.samples;
      finer.samples = fine_samples;
      const SpotPicture same = fewer.render(as_rendered), picture = fewer.render(finer);
      line.seconds = same.report.seconds + picture.report.seconds;
      budget_.seconds += line.seconds;
      line.rms = off(same, picture);
      line.detail = fmt::format("{} against {}, on {} pixels", samples_text(report_.samples_mean), fine_samples, fewer.pixels());
    }
    line.price = "half of it: 2.5 x the samples where edges are";
    return line;
  }

  BudgetLine rounding() {
    BudgetLine line;
    line.source = "rounding";
    if (options_.kernel.real_double) {
      line.rms = 0;
      line.detail = "double";
      return line;
    }
    if (!info(device_).has_fp64) {
      line.detail = "not known: this device has no fp64 to hold float against";
      return line;
    }
    if (stopped()) return line;
    Variant exact;
    exact.real_double = true;
    const SpotPicture picture = check(exact);
    line.rms = off(base_, picture);
    line.seconds = picture.report.seconds;
    line.detail = fmt::format("float against double, worst {:.2g}", picture_error(base_.frame, picture.frame).stokes_max);
    line.price = "double precision: " + times_text(picture.report, base_.report);
    return line;
  }

  static BudgetLine solids() {
    BudgetLine line;
    line.source = "solids";
    line.rms = 0;
    line.detail = "flat faces, built exactly: nothing is tessellated";
    return line;
  }

  BudgetLine counters() const {
    BudgetLine line;
    line.source = "counted";
    const bool clean = report_.nan_count + report_.energy_count + report_.stack_count + report_.stokes_count == 0;
    if (clean) line.rms = 0;
    line.detail = fmt::format("not a number {}, energy off 1 {}, full stacks {}, unphysical Stokes {}{}", report_.nan_count,
                              report_.energy_count, report_.stack_count, report_.stokes_count,
                              clean ? "" : ": see the warnings");
    return line;
  }

  const LoadedScene& loaded_;
  const RenderOptions& options_;
  const Frame& frame_;
  const RenderReport& report_;
  Device& device_;
  SpotCheck check_;
  SpotPicture base_;
  ErrorBudget budget_;
  double sum2_ = 0;
};

std::string size_text(const BudgetLine& line) { return std::isfinite(line.rms) ? fmt::format("{:.2g}", line.rms) : "?"; }

}  // namespace

ErrorBudget error_budget(const LoadedScene& loaded, int width, int height, Device& device, const RenderOptions& options,
                         const Frame& frame, const RenderReport& report) {
  return Budget(loaded, width, height, device, options, frame, report).run();
}

std::string budget_text(const ErrorBudget& budget) {
  std::string text = fmt::format("error, RMS relative to the mean radiance ({} pixels checked in {:.2f} s)\n", budget.pixels,
                                 budget.seconds);
  const auto out = std::back_inserter(text);
  for (const BudgetLine& line : budget.lines) {
    fmt::format_to(out, "  {:<14}{:>8}  {:>7.2f} s  {}", line.source, size_text(line), line.seconds, line.detail);
    if (!line.price.empty()) fmt::format_to(out, "; {}", line.price);
    text += '\n';
  }
  fmt::format_to(out, "  {:<14}{:>8.2g}{}\n", "together", budget.rms, budget.stopped ? ", as far as it was looked into" : "");
  return text;
}

std::vector<std::pair<std::string, std::string>> budget_notes(const ErrorBudget& budget) {
  std::vector<std::pair<std::string, std::string>> notes;
  for (const BudgetLine& line : budget.lines)
    notes.emplace_back("error." + line.source, fmt::format("{} in {:.3g} s; {}{}{}", size_text(line), line.seconds, line.detail,
                                                            line.price.empty() ? "" : "; ", line.price));
  notes.emplace_back("error.together", fmt::format("{:.3g}, RMS relative to the mean radiance", budget.rms));
  return notes;
}

}  // namespace nicol::engine
