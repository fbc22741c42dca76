// The Pareto front, the cheapest setting for a target, and what is combined, on measurements made by hand.
#include "host/accuracy/measurements.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace nicol;

Measurement made(std::vector<double> seconds, double rms, double ciede = 0) {
  Measurement m;
  m.setting.lambda_nm = {550};
  m.seconds = std::move(seconds);
  m.error.stokes_rms = rms;
  m.error.ciede_mean = ciede;
  m.error.ciede_95 = 2 * ciede;
  return m;
}

const Target one_percent{Target::Measure::rms, 0.01, ""};

}  // namespace

TEST_CASE("times of one setting") {
  const Measurement m = made({3, 1, 8}, 0);
  CHECK(m.fastest() == 1);
  CHECK(m.median() == 3);
  CHECK(m.slowest() == 8);
  CHECK(made({1, 2}, 0).median() == 1.5);
  CHECK(std::isnan(made({}, 0).median()));
}

TEST_CASE("the front holds what no other beats, by rising time") {
  const std::vector<Measurement> all{made({4}, 0.01), made({1}, 0.5), made({2}, 0.6), made({2}, 0.1),
                                     made({5}, 0.01), made({9}, 0)};
  CHECK(pareto_front(all) == std::vector<std::size_t>{1, 3, 0, 5});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("the front leaves out what was not rendered, is no number, or has no command") {
  std::vector<Measurement> all{made({2}, 0.1), made({}, 0), made({1}, NAN), made({1}, 0.01), made({1.5}, 0.05)};
  all[3].setting.without = "dispersion";
  all[4].setting.without = "polarization";
  CHECK(pareto_front(all) == std::vector<std::size_t>{4});
  CHECK(cheapest(all, one_percent, 0) == std::nullopt);
}

TEST_CASE("equals: the first stands for both") {
  CHECK(pareto_front({made({1}, 0.1), made({1}, 0.1)}) == std::vector<std::size_t>{0});
}

TEST_CASE("the cheapest that keeps a target, by median time") {
  const std::vector<Measurement> all{made({1}, 0.02, 0.4), made({3, 3, 3}, 0.01, 0.2), made({2, 9, 9}, 0.001, 0.6)};
  CHECK(cheapest(all, one_percent, 0) == 1);
  CHECK(cheapest(all, {Target::Measure::rms, 0.001, ""}, 0) == 2);
  CHECK(cheapest(all, {Target::Measure::rms, 0.0001, ""}, 0) == std::nullopt);
  CHECK(cheapest(all, {Target::Measure::ciede_mean, 0.5, ""}, 0) == 0);
  CHECK(cheapest(all, {Target::Measure::ciede_95, 0.5, ""}, 0) == 1);
}

TEST_CASE("nothing is said below the reference's own error, but colours need none so fine") {
  const std::vector<Measurement> all{made({1}, 1e-6, 0.1)};
  CHECK(cheapest(all, one_percent, 0.011) == std::nullopt);
  CHECK(cheapest(all, one_percent, 0.009) == 0);
  CHECK(cheapest(all, {Target::Measure::ciede_mean, 1, ""}, 0.011) == 0);
  Reference reference;
  reference.sampling = 0.003;
  reference.spectral = 0.004;
  reference.cut_off = 0.012;
  CHECK(reference.own_error() == doctest::Approx(0.013));
}

TEST_CASE("combined settings turn each knob as far as it alone allows") {
  std::vector<Measurement> all{made({10}, 0.05)};
  AccuracySetting base;
  base.lambda_nm = {400, 450, 500, 550, 600};
  base.max_trace_level = 20;
  base.adc_bailout = 1e-4;
  all[0].setting = base;
  const auto add = [&](Knob knob, double alone, const AccuracySetting& setting) {
    all.push_back(made({5}, 0.05));
    all.back().knob = knob;
    all.back().alone = alone;
    all.back().setting = setting;
  };
  AccuracySetting s = base;
  s.lambda_nm = {400, 500, 600};
  add(Knob::wavelengths, 0.008, s);
  s = base;
  for (const auto& [depth, alone] : {std::pair{4, 0.2}, {8, 0.003}, {40, 0.0}}) {
    s.max_trace_level = depth;
    add(Knob::depth, alone, s);
  }
  s = base;
  s.adc_bailout = 0.05;
  add(Knob::cut_off, 0.5, s);
  s = base;
  for (const auto& [samples, alone] : {std::pair{4, 0.008}, {16, 0.002}}) {
    s.samples = samples;
    add(Knob::samples, alone, s);
  }
  const KnobErrors at_base{{Knob::wavelengths, 0}, {Knob::depth, 1e-9}, {Knob::cut_off, 1e-9},
                           {Knob::precision, 1e-7}, {Knob::samples, 0.05}};
  const auto settings = combined_settings(all, at_base, 0.009);
  const auto there = [&](std::size_t wavelengths, int depth, int samples) {
    return std::any_of(settings.begin(), settings.end(), [&](const AccuracySetting& c) {
      return c.lambda_nm.size() == wavelengths && c.max_trace_level == depth && c.samples == samples &&
             c.adc_bailout == 1e-4;
    });
  };
  CHECK(there(3, 8, 4));    // 0.9 of 1 %
  CHECK(there(5, 8, 16));   // 0.4 of 1 %
  for (const auto& c : settings) {
    CHECK(c.max_trace_level != 4);
    CHECK_FALSE(c.real_double);
    for (const auto& m : all) CHECK_FALSE(c == m.setting);
  }
  CHECK(combined_settings(all, at_base, 1).empty());
  CHECK(combined_settings({}, at_base, 0).empty());
}
