// See measurements.hpp. Test: tests/accuracy/measurements_test.cpp.
#include "host/accuracy/measurements.hpp"

#include <algorithm>
#include <array>

namespace nicol {
namespace {

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

bool usable(const Measurement& m) {
  return has_command(m.setting) && !m.seconds.empty() && !std::isnan(m.error.rms());
}

// The place of the base, which every sweep has.
const Measurement* base_of(const std::vector<Measurement>& measurements) {
  for (const Measurement& m : measurements)
    if (m.knob == Knob::base && !m.seconds.empty()) return &m;
  return nullptr;
}

// Whether the first setting is the coarser one in this knob, which never costs more work.
bool coarser(Knob knob, const AccuracySetting& a, const AccuracySetting& b) {
  switch (knob) {
    case Knob::wavelengths: return a.lambda_nm.size() < b.lambda_nm.size();
    case Knob::depth: return a.max_trace_level < b.max_trace_level;
    case Knob::cut_off: return a.adc_bailout > b.adc_bailout;
    case Knob::precision: return !a.real_double && b.real_double;
    case Knob::samples: return a.samples < b.samples;
    case Knob::adaptive: return a.sample_error > b.sample_error;
    default: return false;
  }
}

// The coarsest value of a knob that errs less than `share` by itself; else its most accurate.
const AccuracySetting& pick(const std::vector<Measurement>& measurements, Knob knob, const Measurement& base,
                            const KnobErrors& base_alone, double share) {
  const auto known = base_alone.find(knob);
  if (known == base_alone.end()) return base.setting;
  const Measurement *coarsest = nullptr, *best = &base;
  double best_alone = known->second;
  const auto consider = [&](const Measurement& m, double alone) {
    if (alone <= share && (!coarsest || coarser(knob, m.setting, coarsest->setting))) coarsest = &m;
    if (alone < best_alone) {
      best_alone = alone;
      best = &m;
    }
  };
  consider(base, best_alone);
  for (const Measurement& m : measurements)
    if (m.knob == knob && usable(m)) consider(m, m.alone);
  return (coarsest ? coarsest : best)->setting;
}

// Every knob turned as far as `share` allows, samples by one of the two ways.
AccuracySetting combine(const std::vector<Measurement>& measurements, const Measurement& base,
                        const KnobErrors& base_alone, double share, Knob sampling) {
  const auto chosen = [&](Knob knob) -> const AccuracySetting& {
    return pick(measurements, knob, base, base_alone, share);
  };
  AccuracySetting setting = base.setting;
  setting.lambda_nm = chosen(Knob::wavelengths).lambda_nm;
  setting.max_trace_level = chosen(Knob::depth).max_trace_level;
  setting.adc_bailout = chosen(Knob::cut_off).adc_bailout;
  setting.real_double = chosen(Knob::precision).real_double;
  setting.samples = chosen(sampling).samples;
  setting.sample_error = chosen(sampling).sample_error;
  for (const Measurement& m : measurements)
    if (m.knob == Knob::effects && usable(m) && m.alone <= share && m.median() < base.median())
      setting.without = m.setting.without;
  return setting;
}

}  // namespace

double Measurement::fastest() const { return seconds.empty() ? NAN : sorted(seconds).front(); }
double Measurement::slowest() const { return seconds.empty() ? NAN : sorted(seconds).back(); }
double Measurement::median() const {
  if (seconds.empty()) return NAN;
  const std::vector<double> s = sorted(seconds);
  return (s[(s.size() - 1) / 2] + s[s.size() / 2]) / 2;
}

bool has_command(const AccuracySetting& setting) {
  return setting.without.empty() || setting.without == "polarization";
}

std::vector<std::size_t> pareto_front(const std::vector<Measurement>& measurements) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < measurements.size(); ++i)
    if (usable(measurements[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double t_a = measurements[a].median(), t_b = measurements[b].median();
    return t_a != t_b ? t_a < t_b : measurements[a].error.rms() < measurements[b].error.rms();
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || measurements[i].error.rms() < measurements[front.back()].error.rms()) front.push_back(i);
  return front;
}

std::vector<Target> usual_targets() {
  using Measure = Target::Measure;
  return {{Measure::rms, 0.01, "1 % RMS"},
          {Measure::rms, 0.001, "0.1 % RMS"},
          {Measure::rms, 0.0001, "0.01 % RMS"},
          {Measure::ciede_mean, 1, "CIEDE2000 below 1, mean"},
          {Measure::ciede_95, 1, "CIEDE2000 below 1, 95 % of the pixels"}};
}

double measured(const PictureError& error, Target::Measure measure) {
  switch (measure) {
    case Target::Measure::rms: return error.rms();
    case Target::Measure::ciede_mean: return error.ciede_mean;
    case Target::Measure::ciede_95: return error.ciede_95;
  }
  return NAN;
}

std::optional<std::size_t> cheapest(const std::vector<Measurement>& measurements, const Target& target,
                                    double own_error) {
  if (target.measure == Target::Measure::rms && target.limit < own_error) return std::nullopt;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement& m = measurements[i];
    if (!usable(m) || !(measured(m.error, target.measure) <= target.limit)) continue;
    if (!found || m.median() < measurements[*found].median()) found = i;
  }
  return found;
}

std::vector<AccuracySetting> combined_settings(const std::vector<Measurement>& measurements,
                                               const KnobErrors& base_alone, double least) {
  constexpr std::array<double, 5> targets{0.03, 0.01, 0.003, 0.001, 0.0003};
  // Of a target, for each knob: nearly all, should the others err little, or what leaves room for them.
  constexpr std::array<double, 2> shares{0.9, 0.4};
  std::vector<AccuracySetting> settings;
  const Measurement* base = base_of(measurements);
  if (!base) return settings;
  const auto known = [&](const AccuracySetting& setting) {
    return std::find(settings.begin(), settings.end(), setting) != settings.end() ||
           std::any_of(measurements.begin(), measurements.end(),
                       [&](const Measurement& m) { return m.setting == setting; });
  };
  for (const double target : targets)
    for (const double share : shares)
      for (const Knob how : {Knob::samples, Knob::adaptive}) {
        if (target < least) continue;
        const AccuracySetting setting = combine(measurements, *base, base_alone, share * target, how);
        if (!known(setting)) settings.push_back(setting);
      }
  return settings;
}

}  // namespace nicol
