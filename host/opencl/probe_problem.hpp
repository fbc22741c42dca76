// A problem of the probe's JSON schema as the numbers of kernels/probe_abi.h.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/opencl/probe_medium.hpp"

namespace nicol {

struct ProbeProblem {
  std::string id;
  std::vector<double> scalars;  // PROBE_SCALARS
  ProbeMedium media[2];         // bulk and propagation: the first
  Vector normal{};              // bulk and propagation
};

// Media constants (brackets included) are prepared in double. Throw std::runtime_error that names case and member.
ProbeProblem read_face(const nlohmann::json& face, std::size_t position);
ProbeProblem read_bulk(const nlohmann::json& bulk, std::size_t position);
ProbeProblem read_propagation(const nlohmann::json& propagation, std::size_t position);

}  // namespace nicol
