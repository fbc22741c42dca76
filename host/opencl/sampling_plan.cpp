#include "host/opencl/sampling_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace nicol {
namespace {

// Further samples are taken for granted to bring what the law says: a little less than the target is aimed at.
constexpr double aim = 0.9;

struct Candidate {
  std::int32_t pixel;
  double error2, samples, count;  // count: the wanted one but for a common factor, (e^2 n^1.5)^0.4
};

// Pixels whose errors matter; what the others have together is in `rest`.
std::vector<Candidate> candidates_of(const std::vector<float>& error, const std::vector<std::uint32_t>& samples,
                                     double negligible2, double& rest) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double e2 = static_cast<double>(error[i]) * static_cast<double>(error[i]), n = samples[i];
    if (e2 > negligible2)
      candidates.push_back({static_cast<std::int32_t>(i), e2, n, std::pow(e2 * n * std::sqrt(n), 0.4)});
    else
      rest += e2;
  }
  return candidates;
}

// The sum of squares with every candidate at factor * count samples.
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
  constexpr double negligible = 0.02;  // part of what a pixel may have on average
  const double allowed2 = aim * aim * target * target;
  double rest = 0;
  const auto candidates = candidates_of(error, samples, negligible * allowed2, rest);
  const double allowed = allowed2 * static_cast<double>(error.size()) - rest;
  double low = 1e-12, high = 1e12;
  for (const Candidate& c : candidates) high = std::max(high, most / c.count);
  for (int i = 0; i < 40; ++i) {
    const double middle = std::sqrt(low * high);
    (sum_of_squares_at(candidates, middle, most) > allowed ? low : high) = middle;
  }
  std::map<std::uint32_t, SamplePass> by_count;
  for (const Candidate& c : candidates) {
    // a step is taken when it does not go far beyond what is wanted
    if (high * c.count > 1.2 * c.samples && c.samples < most)
      by_count[samples[static_cast<std::size_t>(c.pixel)]].pixels.push_back(c.pixel);
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
