// A face problem of the oracle's JSON schema as the numbers of kernels/probe_abi.h.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace nicol {

struct ProbeProblem {
  std::string id;
  std::string unsupported;        // why the kernels do not trace it; "" if they do
  std::vector<double> scalars;    // PROBE_SCALARS
  bool absorbs[2] = {false, false};  // medium 1, medium 2
};

// Media constants (brackets included) are prepared in double. Throws std::runtime_error that names case and member.
ProbeProblem read_problem(const nlohmann::json& face, std::size_t position);

}  // namespace nicol
