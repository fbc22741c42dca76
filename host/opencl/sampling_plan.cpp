#include "host/opencl/sampling_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace nicol {
namespace {

// Further samples are taken for granted to bring what the law says: a little less than the target is aimed at.
constexpr double aim = 0.9;

struct Candidate {
  double error2, samples, count;  // count: the wanted one but for a common factor, (e^2 n^1.5)^0.4
};

// The sum of squares with every pixel at factor * count samples.
double sum_of_squares_at(const std::vector<Candidate>& candidates, double factor, int most) {
  double sum = 0;
  for (const Candidate& c : candidates) {
    const double to = std::clamp(factor * c.count, c.samples, std::max(c.samples, static_cast<double>(most)));
    const double ratio = c.samples / to;
    sum += c.error2 * ratio * std::sqrt(ratio);
  }
  return sum;
}

}  // namespace

int next_count(int samples) { return samples <= 1 ? 5 : 2 * samples + 1; }

double root_mean_square(const std::vector<float>& values) {
  double sum = 0;
  for (const float v : values) sum += static_cast<double>(v) * static_cast<double>(v);
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<SamplePass> next_passes(const std::vector<float>& error, const std::vector<std::uint32_t>& samples,
                                    double target, int most) {
  if (root_mean_square(error) <= target) return {};
  const double allowed = aim * aim * target * target * static_cast<double>(error.size());
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double e = static_cast<double>(error[i]), n = samples[i];
    candidates.push_back({e * e, n, e > 0 ? std::pow(e * e * n * std::sqrt(n), 0.4) : 0});
  }
  double low = 1e-20, high = 1e30;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (sum_of_squares_at(candidates, middle, most) > allowed ? low : high) = middle;
  }
  std::map<std::uint32_t, SamplePass> by_count;
  for (std::size_t i = 0; i < error.size(); ++i) {
    // a step is taken when it does not go far beyond what is wanted
    if (!(high * candidates[i].count > 1.2 * samples[i]) || samples[i] >= static_cast<std::uint32_t>(most)) continue;
    by_count[samples[i]].pixels.push_back(static_cast<std::int32_t>(i));
  }
  std::vector<SamplePass> passes;
  for (auto& [count, pass] : by_count) {
    pass.begin = static_cast<int>(count);
    pass.end = std::min(most, next_count(pass.begin));
    passes.push_back(std::move(pass));
  }
  return passes;
}

}  // namespace nicol
