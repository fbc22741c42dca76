// The probe's kernel, compiled as C++ in double.
#include "tests/fuzz/native_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#define LANES 1
#define REAL_DOUBLE
namespace nicol::fuzz {
namespace {
#include "kernels/probe.h"
}

std::vector<double> solve_natively(const std::vector<double>& problems) {
  std::vector<double> answers;
  for (std::size_t at = 0; at + PROBE_SCALARS <= problems.size(); at += PROBE_SCALARS) {
    // of their exact sizes, so that reading or writing past them is seen
    const std::vector<scalar> problem(problems.begin() + static_cast<std::ptrdiff_t>(at),
                                      problems.begin() + static_cast<std::ptrdiff_t>(at + PROBE_SCALARS));
    std::vector<scalar> answer(ANSWER_SCALARS);
    solve_problem(problem.data(), answer.data());
    answers.insert(answers.end(), answer.begin(), answer.end());
  }
  return answers;
}

}  // namespace nicol::fuzz
