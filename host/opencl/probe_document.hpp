// The probe's JSON, problems in and answers out, whoever solves them.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace nicol {

// Problems of kernels/probe_abi.h, PROBE_SCALARS each; the answers, ANSWER_SCALARS each.
using ProbeSolver = std::function<std::vector<double>(const std::vector<double>& problems)>;

// JSON text in, JSON text out; device and real ("float", "double") are told in it. Throws std::runtime_error
// naming the case and member for malformed input.
std::string answer_document(const std::string& text, const std::string& device, const std::string& real,
                            const ProbeSolver& solve);

}  // namespace nicol
