// See accuracy_sweep.hpp.
#include "host/app/accuracy_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>

#include "host/accuracy/picture_error.hpp"
#include "host/app/accuracy_scenes.hpp"
#include "host/app/progress_bar.hpp"
#include "host/effects.hpp"

namespace nicol::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<Knob, 4> turned{Knob::wavelengths, Knob::depth, Knob::cut_off, Knob::precision};
constexpr double dearer = 4;  // the next value of samples, in time

struct Interrupted {};

// Whether the first setting is the better one in this knob.
bool more_accurate(Knob knob, const AccuracySetting& a, const AccuracySetting& b) {
  switch (knob) {
    case Knob::wavelengths: return a.lambda_nm.size() > b.lambda_nm.size();
    case Knob::depth: return a.max_trace_level > b.max_trace_level;
    case Knob::cut_off: return a.adc_bailout < b.adc_bailout;
    case Knob::precision: return a.real_double && !b.real_double;
    default: return false;
  }
}

// How many times the work of a plain picture, before anything is measured.
double relative_cost(const AccuracySetting& setting, const AccuracySetting& base) {
  constexpr double of_double = 2, of_adaptive = 8;
  const auto cost = [](const AccuracySetting& s) {
    return static_cast<double>(s.lambda_nm.size()) * (s.sample_error > 0 ? of_adaptive : s.samples) *
           (s.real_double ? of_double : 1);
  };
  return cost(setting) / cost(base);
}

class Sweeper {
 public:
  Sweeper(const AccuracyCommand& command, const LoadedScene& loaded, Device& device, const std::atomic<bool>& cancel,
          ProgressBar& bar)
      : command_(command), scenes_(loaded, command.options), device_(device), cancel_(cancel), bar_(bar) {
    base_ = base_setting(loaded.scene, command.device.real == "double");
  }

  Sweep run() {
    plan();
    try {
      make_reference();
      measure_base();
      for (const Knob knob : turned) turn(knob);
      turn_sampling();
      leave_out_effects();
      combine();
      for (int repeat = 1; repeat < command_.repeats; ++repeat)
        for (Measurement& m : sweep_.measurements) m.seconds.push_back(render_timed(m.setting).seconds);
    } catch (const Interrupted&) {
      sweep_.interrupted = true;
    }
    return std::move(sweep_);
  }

 private:
  bool wanted(Knob knob) const {
    return command_.knobs.empty() ||
           std::find(command_.knobs.begin(), command_.knobs.end(), knob_name(knob)) != command_.knobs.end();
  }

  std::vector<KnobValue> values_of(Knob knob) const {
    std::vector<KnobValue> values;
    if (!wanted(knob)) return values;
    values = knob_values(knob, base_, command_.most_samples, command_.reference_step_nm);
    if (knob == Knob::precision && !info(device_).has_fp64) values.clear();
    return values;
  }

  // What lies ahead, for the time that is left.
  void plan() {
    constexpr int combined_guess = 8;
    ahead_.assign(static_cast<std::size_t>(1 + (wanted(Knob::combined) ? combined_guess : 0)), base_);
    for (const Knob knob : turned)
      for (const KnobValue& value : values_of(knob)) ahead_.push_back(value.setting);
    for (const Knob knob : {Knob::samples, Knob::adaptive})
      for (const KnobValue& value : values_of(knob)) ahead_.push_back(value.setting);
    if (wanted(Knob::effects)) ahead_.insert(ahead_.end(), effects_of(scenes_.base()).size(), base_);
  }

  // As measured; else from the setting that is sampled alike, or from the first.
  double expected_seconds(const AccuracySetting& setting) const {
    if (sweep_.measurements.empty())
      return sweep_.reference.seconds / relative_cost(sweep_.reference.setting, setting);
    const Measurement* like = &sweep_.measurements.front();
    for (const Measurement& m : sweep_.measurements) {
      if (m.setting == setting) return m.median();
      if (m.setting.samples == setting.samples && m.setting.sample_error == setting.sample_error) like = &m;
    }
    return like->median() * relative_cost(setting, like->setting);
  }

  // Seconds of everything after the render in progress, repetitions included.
  double seconds_ahead() const {
    double seconds = 0;
    for (const AccuracySetting& setting : ahead_) seconds += expected_seconds(setting) * command_.repeats;
    for (const Measurement& m : sweep_.measurements)
      seconds += m.median() * (command_.repeats - static_cast<double>(m.seconds.size()));
    return seconds;
  }

  void tell(const Progress& of_render) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    Progress all = of_render;
    all.seconds = elapsed;
    all.seconds_left = of_render.seconds_left + ahead_seconds_;
    all.fraction = elapsed / std::max(elapsed + all.seconds_left, 1e-9);
    bar_.show(all);
  }

  struct Timed {
    Frame frame;
    double seconds = 0, samples_mean = 1, sampling = 0;
  };

  Timed render_timed(const AccuracySetting& setting, int most_samples = 0) {
    if (cancel_) throw Interrupted{};
    const auto planned = std::find(ahead_.begin(), ahead_.end(), setting);
    if (planned != ahead_.end()) ahead_.erase(planned);
    ahead_seconds_ = seconds_ahead();
    DeviceOptions device_options = command_.device;
    device_options.real = setting.real_double ? "double" : "float";
    RenderOptions options;
    options.kernel = kernel_options(device_options);
    options.samples = setting.samples;
    options.sample_error = setting.sample_error;
    if (most_samples > 0) options.most_samples = most_samples;
    options.cancel = &cancel_;
    options.progress = [this](const Progress& progress) { tell(progress); };
    const AccuracyScene scene = scenes_.at(setting);
    if (prepared_.insert({scene.features.mask, setting.real_double}).second)
      prepare_kernel(device_, scene.features.contents(), options.kernel);
    const PackedScene packed = pack(scene.scene, *scene.geometry, scene.features.mask, command_.options.width,
                                    command_.options.height, lanes_on(device_, options.kernel));
    RenderReport report;
    Timed timed;
    timed.frame = render(device_, packed, scene.scene.lambda_nm, scene.scene.weight_nm, options, report);
    if (report.interrupted) throw Interrupted{};
    timed.frame.exposure = scene.scene.settings.exposure;
    timed.seconds = report.seconds;
    timed.samples_mean = report.samples_mean;
    timed.sampling = report.sample_error;
    sweep_.device = report.device;
    return timed;
  }

  // The reference, and how good it is.
  void make_reference() {
    Reference& reference = sweep_.reference;
    reference.setting =
        reference_setting(base_, parse_relative_error(command_.reference_error), command_.reference_step_nm);
    reference.setting.real_double = info(device_).has_fp64;
    if (!info(device_).has_fp64)
      sweep_.notes.push_back("the device has no double precision: the reference is in float");
    Timed timed = render_timed(reference.setting, command_.reference_samples);
    reference.seconds = timed.seconds;
    reference.samples_mean = timed.samples_mean;
    reference.sampling = timed.sampling;
    if (reference.setting.lambda_nm != base_.lambda_nm) {
      const SpectralStep step = spectral_step(timed.frame);
      if (step.known) reference.spectral = step.xyz_rms;
    } else {
      sweep_.notes.push_back("the wavelengths are taken as they are: nothing is said about their step");
    }
    AccuracySetting plain = reference.setting;
    plain.lambda_nm = base_.lambda_nm;
    plain.samples = 1;
    plain.sample_error = 0;
    const Frame cut = render_timed(plain).frame, deeper = render_timed(beyond_reference(plain)).frame;
    reference.cut_off = picture_error(cut, deeper).rms();
    reference_frame_ = std::move(timed.frame);
    sweep_.has_reference = true;
  }

  // Renders once and appends.
  Timed measure(Knob knob, const std::string& text, const AccuracySetting& setting) {
    Timed timed = render_timed(setting);
    Measurement m;
    m.knob = knob;
    m.text = text;
    m.setting = setting;
    m.error = picture_error(timed.frame, reference_frame_);
    m.seconds = {timed.seconds};
    m.samples_mean = timed.samples_mean;
    sweep_.measurements.push_back(m);
    return timed;
  }

  void measure_base() { base_frame_ = measure(Knob::base, "as it is", base_).frame; }

  // Each value against the best of its knob, all else alike: what this knob alone errs.
  void turn(Knob knob) {
    const std::vector<KnobValue> values = values_of(knob);
    if (values.empty()) return;
    const Frame first = measure(knob, values[0].text, values[0].setting).frame;
    const Frame& best = more_accurate(knob, values[0].setting, base_) ? first : base_frame_;
    sweep_.base_alone[knob] = picture_error(base_frame_, best).rms();
    sweep_.measurements.back().alone = picture_error(first, best).rms();
    for (std::size_t i = 1; i < values.size(); ++i) {
      const Frame frame = measure(knob, values[i].text, values[i].setting).frame;
      sweep_.measurements.back().alone = picture_error(frame, best).rms();
    }
  }

  // Against the best sampled picture, whose own error counts too.
  void turn_sampling() {
    std::vector<std::pair<std::size_t, Frame>> frames;
    double error_of_best = 0;
    for (const Knob knob : {Knob::samples, Knob::adaptive}) {
      const std::vector<KnobValue> values = values_of(knob);
      for (std::size_t i = 0; i < values.size() && (i == 0 || !too_long(values, i)); ++i) {
        Timed timed = measure(knob, values[i].text, values[i].setting);
        error_of_best = std::isnan(timed.sampling) ? 0 : timed.sampling;
        frames.emplace_back(sweep_.measurements.size() - 1, std::move(timed.frame));
      }
    }
    if (frames.empty()) return;
    const auto alone = [&](const Frame& frame) {
      return std::hypot(picture_error(frame, frames.back().second).rms(), error_of_best);
    };
    sweep_.base_alone[Knob::samples] = sweep_.base_alone[Knob::adaptive] = alone(base_frame_);
    for (const auto& [place, frame] : frames) sweep_.measurements[place].alone = alone(frame);
  }

  bool too_long(const std::vector<KnobValue>& values, std::size_t next) {
    if (sweep_.measurements.back().median() * dearer <= command_.longest_seconds) return false;
    sweep_.notes.push_back(fmt::format("{}: nothing above {}, which would take longer than {:g} s (--longest)",
                                       knob_name(values[next].knob), values[next - 1].text, command_.longest_seconds));
    const auto left_out = [&](const AccuracySetting& setting) {
      return std::any_of(values.begin() + static_cast<std::ptrdiff_t>(next), values.end(),
                         [&](const KnobValue& value) { return value.setting == setting; });
    };
    ahead_.erase(std::remove_if(ahead_.begin(), ahead_.end(), left_out), ahead_.end());
    return true;
  }

  void leave_out_effects() {
    if (!wanted(Knob::effects)) return;
    for (const Effect& effect : effects_of(scenes_.base())) {
      AccuracySetting setting = base_;
      setting.without = effect.name;
      const Frame frame = measure(Knob::effects, fmt::format("{}: {}", effect.name, effect.without), setting).frame;
      sweep_.measurements.back().alone = picture_error(frame, base_frame_).rms();
    }
  }

  void combine() {
    if (!wanted(Knob::combined)) return;
    ahead_ = combined_settings(sweep_.measurements, sweep_.base_alone, sweep_.reference.own_error());
    const auto too_long = [&](const AccuracySetting& setting) {
      return expected_seconds(setting) > command_.longest_seconds;
    };
    ahead_.erase(std::remove_if(ahead_.begin(), ahead_.end(), too_long), ahead_.end());
    int number = 0;
    for (const AccuracySetting& setting : std::vector<AccuracySetting>(ahead_))
      measure(Knob::combined, fmt::format("number {}", ++number), setting);
  }

  const AccuracyCommand& command_;
  AccuracyScenes scenes_;
  Device& device_;
  const std::atomic<bool>& cancel_;
  ProgressBar& bar_;
  AccuracySetting base_;
  Sweep sweep_;
  Frame reference_frame_, base_frame_;
  std::set<std::pair<std::uint32_t, bool>> prepared_;
  std::vector<AccuracySetting> ahead_;
  double ahead_seconds_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Sweep run_sweep(const AccuracyCommand& command, const LoadedScene& loaded, Device& device,
                const std::atomic<bool>& cancel, ProgressBar& bar) {
  return Sweeper(command, loaded, device, cancel, bar).run();
}

}  // namespace nicol::app
