#pragma once
#include <vector>

namespace nicol::fuzz {

// A ProbeSolver without a device.
std::vector<double> solve_natively(const std::vector<double>& problems);

}  // namespace nicol::fuzz
