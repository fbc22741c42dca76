// See knobs.hpp. Test: tests/accuracy/knobs_test.cpp.
#include "host/accuracy/knobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nicol {
namespace {

constexpr int deepest = 4096;  // the most that max_trace_level may be
constexpr std::size_t most_wavelengths = 401;

// The range in `count` equal steps.
std::vector<double> range_nm(double from, double to, std::size_t count) {
  std::vector<double> lambda_nm;
  for (std::size_t i = 0; i <= count; ++i)
    lambda_nm.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  return lambda_nm;
}

// Into how many parts the reference divides the step.
std::size_t reference_division(const std::vector<double>& lambda_nm, double fine_nm) {
  const double step_nm = equal_step_nm(lambda_nm);
  const std::size_t steps = lambda_nm.size() - 1;
  if (step_nm == 0 || steps < 2) return 1;
  std::size_t division = 1;
  while ((division < 2 || step_nm / static_cast<double>(division) > fine_nm) &&
         2 * division * steps + 1 <= most_wavelengths)
    division *= 2;
  return division;
}

std::string step_text(const std::vector<double>& lambda_nm) {
  return fmt::format("{:.6g} nm", equal_step_nm(lambda_nm));
}

std::vector<KnobValue> wavelength_values(const AccuracySetting& base, double reference_step_nm) {
  std::vector<KnobValue> values;
  const std::size_t steps = base.lambda_nm.size() - 1;
  if (base.lambda_nm.size() < 3 || equal_step_nm(base.lambda_nm) == 0) return values;
  const auto add = [&](std::size_t count) {
    KnobValue value{Knob::wavelengths, "", base};
    value.setting.lambda_nm = range_nm(base.lambda_nm.front(), base.lambda_nm.back(), count);
    value.text = step_text(value.setting.lambda_nm);
    values.push_back(value);
  };
  const std::size_t finest = reference_division(base.lambda_nm, reference_step_nm) / 2;
  for (std::size_t division = finest; division > 1; division /= 2) add(steps * division);
  // About twice and four times the step, at least two steps.
  std::size_t last = 1;
  for (const std::size_t wanted : {2, 4}) {
    std::size_t factor = std::max(wanted, last + 1);
    while (factor < 2 * wanted && steps % factor != 0) ++factor;
    if (steps % factor != 0 || steps / factor < 2) continue;
    add(steps / factor);
    last = factor;
  }
  return values;
}

std::vector<KnobValue> depth_values(const AccuracySetting& base) {
  std::vector<KnobValue> values;
  const auto add = [&](int depth) {
    const bool there = depth == base.max_trace_level ||
                       (!values.empty() && values.back().setting.max_trace_level == depth);
    if (depth < 1 || there) return;
    KnobValue value{Knob::depth, fmt::format("{} faces", depth), base};
    value.setting.max_trace_level = depth;
    values.push_back(value);
  };
  for (const double factor : {2.0, 0.5, 0.25, 0.125, 0.0625})
    add(std::min(deepest, static_cast<int>(std::lround(base.max_trace_level * factor))));
  return values;
}

double one_digit(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  return std::round(value / decade) * decade;
}

std::vector<KnobValue> cut_off_values(const AccuracySetting& base) {
  constexpr double coarsest = 0.05, finest = 1e-6;
  constexpr int steps = 4;
  std::vector<KnobValue> values;
  const auto add = [&](double cut_off) {
    KnobValue value{Knob::cut_off, fmt::format("{:.2g}", cut_off), base};
    value.setting.adc_bailout = cut_off;
    values.push_back(value);
  };
  const double from = std::max(base.adc_bailout, finest);
  if (base.adc_bailout > 0) add(base.adc_bailout / 4);
  if (base.adc_bailout == 0) add(finest);
  if (from >= coarsest) return values;
  for (int i = 1; i <= steps; ++i)
    add(one_digit(from * std::pow(coarsest / from, i / static_cast<double>(steps))));
  return values;
}

std::vector<KnobValue> sample_values(const AccuracySetting& base, int most_samples) {
  std::vector<KnobValue> values;
  for (int samples = 1; samples <= most_samples; samples *= 4) {
    if (samples == base.samples && base.sample_error == 0) continue;
    KnobValue value{Knob::samples, fmt::format("{} sample{}", samples, samples == 1 ? "" : "s"), base};
    value.setting.samples = samples;
    value.setting.sample_error = 0;
    values.push_back(value);
  }
  return values;
}

std::vector<KnobValue> adaptive_values(const AccuracySetting& base) {
  std::vector<KnobValue> values;
  for (const double error : {0.1, 0.03, 0.01, 0.003, 0.001, 0.0003}) {
    if (error == base.sample_error) continue;
    KnobValue value{Knob::adaptive, fmt::format("to {:g} %", 100 * error), base};
    value.setting.sample_error = error;
    values.push_back(value);
  }
  return values;
}

std::vector<KnobValue> precision_values(const AccuracySetting& base) {
  KnobValue value{Knob::precision, base.real_double ? "float" : "double", base};
  value.setting.real_double = !base.real_double;
  return {value};
}

}  // namespace

const char* knob_name(Knob knob) {
  switch (knob) {
    case Knob::base: return "scene";
    case Knob::wavelengths: return "wavelengths";
    case Knob::depth: return "depth";
    case Knob::cut_off: return "cut-off";
    case Knob::samples: return "samples";
    case Knob::adaptive: return "adaptive";
    case Knob::precision: return "precision";
    case Knob::effects: return "without";
    case Knob::combined: return "combined";
  }
  return "";
}

bool AccuracySetting::operator==(const AccuracySetting& other) const {
  return lambda_nm == other.lambda_nm && max_trace_level == other.max_trace_level &&
         adc_bailout == other.adc_bailout && samples == other.samples && sample_error == other.sample_error &&
         real_double == other.real_double && without == other.without;
}

std::vector<KnobValue> knob_values(Knob knob, const AccuracySetting& base, int most_samples,
                                   double reference_step_nm) {
  switch (knob) {
    case Knob::wavelengths: return wavelength_values(base, reference_step_nm);
    case Knob::depth: return depth_values(base);
    case Knob::cut_off: return cut_off_values(base);
    case Knob::samples: return sample_values(base, most_samples);
    case Knob::adaptive: return adaptive_values(base);
    case Knob::precision: return precision_values(base);
    default: return {};
  }
}

AccuracySetting reference_setting(const AccuracySetting& base, double sample_error, double reference_step_nm) {
  AccuracySetting reference = base;
  const std::size_t division = reference_division(base.lambda_nm, reference_step_nm);
  if (division > 1)
    reference.lambda_nm =
        range_nm(base.lambda_nm.front(), base.lambda_nm.back(), division * (base.lambda_nm.size() - 1));
  reference.max_trace_level = std::min(deepest, 2 * base.max_trace_level);
  reference.adc_bailout = base.adc_bailout / 8;
  reference.samples = std::max(base.samples, 4);
  reference.sample_error = sample_error;
  reference.real_double = true;
  return reference;
}

AccuracySetting beyond_reference(const AccuracySetting& reference) {
  AccuracySetting beyond = reference;
  beyond.max_trace_level = std::min(deepest, 2 * reference.max_trace_level);
  beyond.adc_bailout = reference.adc_bailout / 4;
  return beyond;
}

double equal_step_nm(const std::vector<double>& lambda_nm) {
  if (lambda_nm.size() < 2) return 0;
  const double step_nm = (lambda_nm.back() - lambda_nm.front()) / static_cast<double>(lambda_nm.size() - 1);
  constexpr double same_step = 1e-6;
  for (std::size_t i = 1; i < lambda_nm.size(); ++i)
    if (std::fabs(lambda_nm[i] - lambda_nm[i - 1] - step_nm) > same_step * step_nm) return 0;
  return step_nm;
}

std::string wavelengths_text(const std::vector<double>& lambda_nm) {
  const double step_nm = equal_step_nm(lambda_nm);
  if (step_nm > 0 && lambda_nm.size() > 2)
    return fmt::format("{:.10g}:{:.10g}:{:.10g}", lambda_nm.front(), lambda_nm.back(), step_nm);
  std::vector<std::string> list;
  for (const double nm : lambda_nm) list.push_back(fmt::format("{:.10g}", nm));
  return fmt::format("{}", fmt::join(list, ","));
}

}  // namespace nicol
