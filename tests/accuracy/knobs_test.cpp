// Which values of each knob are tried, and what they are held against.
#include "host/accuracy/knobs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace nicol;

AccuracySetting base_of(double from, double to, int steps) {
  AccuracySetting base;
  for (int i = 0; i <= steps; ++i) base.lambda_nm.push_back(from + (to - from) * i / steps);
  base.max_trace_level = 30;
  base.adc_bailout = 1e-3;
  return base;
}

std::vector<double> steps_nm(const AccuracySetting& base) {
  std::vector<double> steps;
  for (const auto& value : knob_values(Knob::wavelengths, base, 1, 3.2))
    steps.push_back(equal_step_nm(value.setting.lambda_nm));
  return steps;
}

bool holds_all(const std::vector<double>& some, const std::vector<double>& all) {
  return std::all_of(some.begin(), some.end(), [&](double a) {
    return std::any_of(all.begin(), all.end(), [&](double b) { return std::abs(a - b) < 1e-6; });
  });
}

}  // namespace

TEST_CASE("steps of wavelength are halved and doubled with both ends kept, and the reference is finer than all") {
  const AccuracySetting base = base_of(380, 780, 20);
  CHECK(steps_nm(base) == std::vector<double>{5, 10, 40, 80});
  const auto fine = reference_setting(base, 0.001, 3.2).lambda_nm;
  CHECK(equal_step_nm(fine) == doctest::Approx(2.5));
  for (const auto& value : knob_values(Knob::wavelengths, base, 1, 3.2)) {
    CHECK(value.setting.lambda_nm.front() == 380);
    CHECK(value.setting.lambda_nm.back() == 780);
    CHECK(holds_all(value.setting.lambda_nm, fine));
  }
  CHECK(holds_all(base.lambda_nm, fine));
  CHECK(equal_step_nm(reference_setting(base, 0.001, 30).lambda_nm) == doctest::Approx(10));
  CHECK(equal_step_nm(reference_setting(base, 0.001, 1e-3).lambda_nm) == doctest::Approx(1.25));
}

TEST_CASE("steps that do not halve are divided by what divides them") {
  const AccuracySetting base = base_of(400, 700, 15);
  for (const double step : steps_nm(base)) CHECK(std::fmod(300 / step + 1e-9, 1) < 1e-6);
  CHECK(holds_all(base.lambda_nm, reference_setting(base, 0.001, 3.2).lambda_nm));
}

TEST_CASE("one or two wavelengths, and lists of lines, are left as they are") {
  AccuracySetting lines;
  for (const std::vector<double>& list : {std::vector<double>{589.3}, {486.1, 656.3}, {404.7, 546.1, 578}}) {
    lines.lambda_nm = list;
    CHECK(knob_values(Knob::wavelengths, lines, 1, 3.2).empty());
    CHECK(reference_setting(lines, 0.001, 3.2).lambda_nm == list);
  }
}

TEST_CASE("every value changes its own knob alone") {
  AccuracySetting base = base_of(380, 780, 20);
  const auto put_back = [&](Knob knob, AccuracySetting s) {
    if (knob == Knob::wavelengths) s.lambda_nm = base.lambda_nm;
    if (knob == Knob::depth) s.max_trace_level = base.max_trace_level;
    if (knob == Knob::cut_off) s.adc_bailout = base.adc_bailout;
    if (knob == Knob::precision) s.real_double = base.real_double;
    if (knob == Knob::samples || knob == Knob::adaptive) {
      s.samples = base.samples;
      s.sample_error = base.sample_error;
    }
    return s;
  };
  for (const Knob knob :
       {Knob::wavelengths, Knob::depth, Knob::cut_off, Knob::precision, Knob::samples, Knob::adaptive}) {
    CAPTURE(knob_name(knob));
    const auto values = knob_values(knob, base, 64, 3.2);
    CHECK_FALSE(values.empty());
    for (const auto& value : values) {
      CHECK(value.knob == knob);
      CHECK_FALSE(value.text.empty());
      CHECK_FALSE(value.setting == base);
      CHECK(put_back(knob, value.setting) == base);
    }
  }
}

TEST_CASE("the most accurate comes first; samples the other way round, and not too many") {
  const AccuracySetting base = base_of(380, 780, 20);
  CHECK(knob_values(Knob::depth, base, 1, 3.2).front().setting.max_trace_level == 60);
  CHECK(knob_values(Knob::cut_off, base, 1, 3.2).front().setting.adc_bailout == 1e-3 / 4);
  CHECK(knob_values(Knob::cut_off, base, 1, 3.2).back().setting.adc_bailout == doctest::Approx(0.05));
  std::vector<int> samples;
  for (const auto& value : knob_values(Knob::samples, base, 100, 3.2)) samples.push_back(value.setting.samples);
  CHECK(samples == std::vector<int>{4, 16, 64});
}

TEST_CASE("knobs at their ends") {
  AccuracySetting base = base_of(380, 780, 20);
  base.max_trace_level = 4000;
  CHECK(knob_values(Knob::depth, base, 1, 3.2).front().setting.max_trace_level == 4096);
  base.max_trace_level = 1;
  for (const auto& value : knob_values(Knob::depth, base, 1, 3.2)) CHECK(value.setting.max_trace_level > 1);
  base.adc_bailout = 0;
  for (const auto& value : knob_values(Knob::cut_off, base, 1, 3.2)) CHECK(value.setting.adc_bailout > 0);
  CHECK(reference_setting(base, 0.001, 3.2).adc_bailout == 0);
  base.adc_bailout = 0.2;
  CHECK(knob_values(Knob::cut_off, base, 1, 3.2).size() == 1);
}

TEST_CASE("the reference is better in everything, and what lies beyond it is better still") {
  const AccuracySetting base = base_of(380, 780, 20), reference = reference_setting(base, 0.001, 3.2);
  CHECK(reference.real_double);
  CHECK(reference.max_trace_level == 60);
  CHECK(reference.adc_bailout < base.adc_bailout / 4);
  CHECK(reference.sample_error == 0.001);
  const AccuracySetting beyond = beyond_reference(reference);
  CHECK(beyond.max_trace_level > reference.max_trace_level);
  CHECK(beyond.adc_bailout < reference.adc_bailout);
}

TEST_CASE("wavelengths as the command line takes them") {
  CHECK(wavelengths_text({380, 400, 420}) == "380:420:20");
  CHECK(wavelengths_text({400, 402.5, 405}) == "400:405:2.5");
  CHECK(wavelengths_text({486.1, 656.3}) == "486.1,656.3");
  CHECK(wavelengths_text({404.7, 546.1, 578}) == "404.7,546.1,578");
  CHECK(wavelengths_text({589.3}) == "589.3");
}
