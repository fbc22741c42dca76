// Which pixels get further samples, so that the picture keeps to an error at the least cost. Knows nothing of OpenCL.
//
// With n samples the error of a pixel that an edge crosses goes as e(n) = e n^-3/4; the cheapest picture of a given sum of e^2
// has 1.5 e^2/n alike everywhere (Lagrange): n goes as e(1)^0.8. Pixels come to there in steps that about double, because estimates get
// better on the way. Test: tests/opencl/test_sampling.cpp.
#pragma once
#include <cstdint>
#include <vector>

namespace nicol {

// Samples [begin, end) of these pixels (ascending).
struct SamplePass {
  std::vector<std::int32_t> pixels;
  int begin = 0, end = 0;
};

// The sample counts that pixels go through: 1, 5, 11, 23, ...: odd, so that gradients cancel.
int next_count(int samples);

// error: estimate of each pixel's now; samples: what each has. target: for the root of the mean square of all. Empty when the
// estimates keep it, or nothing below `most` samples is left to do.
std::vector<SamplePass> next_passes(const std::vector<float>& error, const std::vector<std::uint32_t>& samples,
                                    double target, int most);

double root_mean_square(const std::vector<float>& values);

}  // namespace nicol
