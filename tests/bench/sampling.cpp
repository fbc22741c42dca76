#include "tests/bench/sampling.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "host/accuracy/picture_error.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/pack.hpp"

namespace nicol::bench {
namespace {

constexpr int reference_samples = 1023;

struct Try {
  std::string name;
  int samples = 1;
  double target = 0;
  double error = 0, samples_mean = 0;
  std::vector<double> cpu_s;
  double median_s() const {
    auto sorted = cpu_s;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Sampler {
 public:
  Sampler(const std::string& scene, int size) : size_(size) {
    engine::SceneOptions options;
    options.width = options.height = size;
    options.wavelengths = "380:771:17";
    loaded_ = engine::load_scene(scene, options);
    if (!loaded_) throw std::runtime_error(scene + " does not load");
    device_ = open_device("");
  }

  Frame render_once(int samples, double target, RenderReport& report) {
    Scene& scene = loaded_->scene;
    scene.settings.sample_error = target;
    const Features features = decide_features(scene, loaded_->geometry);
    RenderOptions options;
    options.samples = samples;
    options.sample_error = target;
    return render(*device_, pack(scene, loaded_->geometry, features.mask, size_, size_, lanes_on(*device_, options.kernel)),
                  scene.lambda_nm, scene.weight_nm, options, report);
  }

  void run(Try& what, const Frame& reference) {
    RenderReport report;
    const double start = cpu_seconds();
    const Frame frame = render_once(what.samples, what.target, report);
    what.cpu_s.push_back(cpu_seconds() - start);
    what.error = picture_error(frame, reference).stokes_rms;
    what.samples_mean = report.samples_mean;
  }

 private:
  int size_;
  std::unique_ptr<engine::LoadedScene> loaded_;
  std::shared_ptr<Device> device_;
};

// The least time from which on all that take longer keep the error, too.
double seconds_to(std::vector<Try> tries, double error) {
  std::sort(tries.begin(), tries.end(), [](const Try& a, const Try& b) { return a.median_s() < b.median_s(); });
  double seconds = NAN;
  for (auto t = tries.rbegin(); t != tries.rend() && t->error <= error; ++t) seconds = t->median_s();
  return seconds;
}

}  // namespace

int compare_sampling(const std::string& scene, int size, int rounds) {
  Sampler sampler(scene, size);
  RenderReport report;
  fmt::print("{}, {}x{}, 24 wavelengths; the reference has {} samples a pixel\n", scene, size, size, reference_samples);
  std::fflush(stdout);
  const Frame reference = sampler.render_once(reference_samples, 0, report);
  std::vector<Try> uniform, adaptive;
  for (int n : {1, 3, 5, 7, 9, 11, 15, 19, 23, 31, 39, 47, 63, 79, 95, 127, 159, 191, 255})
    uniform.push_back({fmt::format("{} samples", n), n, 0, 0, 0, {}});
  for (double target = 0.06; target > 0.0007; target /= std::sqrt(2.0))
    adaptive.push_back({fmt::format("to {:.2g} %", 100 * target), 1, target, 0, 0, {}});
  for (int round = 0; round <= rounds; ++round) {
    for (auto* tries : {&uniform, &adaptive})
      for (Try& t : *tries) {
        sampler.run(t, reference);
        if (round == 0) t.cpu_s.clear();
      }
  }
  fmt::print("{:<14} {:>12} {:>12} {:>10}\n", "", "samples", "RMS error", "CPU s");
  for (const auto* tries : {&uniform, &adaptive})
    for (const Try& t : *tries)
      fmt::print("{:<14} {:>12.2f} {:>10.3f} % {:>10.3f}\n", t.name, t.samples_mean, 100 * t.error, t.median_s());
  for (const double error : {0.01, 0.001})
    fmt::print("to {:g} %: uniform {:.3f} s, where they matter {:.3f} s: {:.1f} times faster\n", 100 * error,
               seconds_to(uniform, error), seconds_to(adaptive, error),
               seconds_to(uniform, error) / seconds_to(adaptive, error));
  return 0;
}

}  // namespace nicol::bench
