// Where further samples go, on made-up errors.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "host/opencl/samples.hpp"
#include "host/opencl/sampling_plan.hpp"

using namespace nicol;

namespace {

// A fifth of the pixels lie on edges of very different steps, the others are smooth.
std::vector<float> picture_of_edges(std::size_t pixels) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share;
  std::vector<float> error;
  for (std::size_t i = 0; i < pixels; ++i)
    error.push_back(static_cast<float>(share(random) < 0.2 ? 0.3 * std::pow(10.0, -3 * share(random)) : 1e-5));
  return error;
}

// What the law makes of the passes, and the samples that they take.
double follow_plan(std::vector<float> error, double target, int most, double& samples_taken) {
  std::vector<std::uint32_t> samples(error.size(), 1);
  for (int round = 0; round < 100; ++round) {
    const auto passes = next_passes(error, samples, target, most);
    if (passes.empty()) break;
    for (const SamplePass& pass : passes) {
      REQUIRE(pass.end > pass.begin);
      REQUIRE(pass.end <= most);
      for (const std::int32_t p : pass.pixels) {
        const auto i = static_cast<std::size_t>(p);
        REQUIRE(static_cast<int>(samples[i]) == pass.begin);
        error[i] *= static_cast<float>(std::pow(static_cast<double>(pass.begin) / pass.end, 0.75));
        samples[i] = static_cast<std::uint32_t>(pass.end);
      }
    }
  }
  samples_taken = 0;
  for (const std::uint32_t n : samples) samples_taken += n;
  return root_mean_square(error);
}

}  // namespace

TEST_CASE("the plan keeps what is asked for, for a part of what uniform samples take") {
  const auto error = picture_of_edges(10000);
  const double first = root_mean_square(error);
  for (const double target : {first / 3, first / 10, first / 100}) {
    CAPTURE(target);
    double taken = 0;
    CHECK(follow_plan(error, target, 100000, taken) <= target);
    const double uniform = std::pow(first / target, 4.0 / 3) * static_cast<double>(error.size());
    CHECK(taken < 0.5 * uniform);
  }
}

TEST_CASE("a picture that is good enough gets nothing, one that cannot be stops at the most samples") {
  const auto error = picture_of_edges(1000);
  const std::vector<std::uint32_t> samples(error.size(), 1);
  CHECK(next_passes(error, samples, 1.01 * root_mean_square(error), 4095).empty());
  double taken = 0;
  CHECK(follow_plan(error, 1e-9, 47, taken) > 1e-9);
  CHECK(taken == 47.0 * static_cast<double>(error.size()));
}

TEST_CASE("odd counts of samples see no gradient") {
  for (int count = 1; count < 800; count = next_count(count)) {
    CAPTURE(count);
    CHECK(count % 2 == 1);
    double x = 0, y = 0;
    for (const auto& [u, v] : pixel_samples(count)) {
      x += u - 0.5;
      y += v - 0.5;
    }
    CHECK(std::fabs(x) < 1e-12 * count);
    CHECK(std::fabs(y) < 1e-12 * count);
  }
}

TEST_CASE("a straight edge somewhere in the pixel: the error falls as n^-3/4") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share;
  for (int n : {5, 23, 95, 383}) {
    const auto samples = pixel_samples(n);
    double sum2 = 0;
    constexpr int edges = 2000;
    for (int edge = 0; edge < edges; ++edge) {
      const double angle = 2 * M_PI * share(random), c = std::cos(angle), s = std::sin(angle), d = (share(random) - 0.5) * 1.3;
      int in = 0, all_in = 0;
      for (const auto& [x, y] : samples) in += (x - 0.5) * c + (y - 0.5) * s <= d;
      constexpr int fine = 64;
      for (int i = 0; i < fine * fine; ++i) all_in += ((i % fine + 0.5) / fine - 0.5) * c + ((i / fine + 0.5) / fine - 0.5) * s <= d;
      const double off = static_cast<double>(in) / n - static_cast<double>(all_in) / (fine * fine);
      sum2 += off * off;
    }
    const double law = std::sqrt(sum2 / edges) * std::pow(n, 0.75);
    CAPTURE(n);
    CHECK(law > 0.2);
    CHECK(law < 0.5);
  }
}
