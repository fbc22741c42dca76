// Face problems of the oracle (isotropic, absorbing, active) as the probe takes them, and its answer judged.
#pragma once
#include <nlohmann/json.hpp>

#include "tests/kernels/under_test.hpp"

namespace nicol::test {

nlohmann::json read_json(const std::string& file);  // from tests/kernels/data

std::vector<double> probe_problem(const nlohmann::json& face);

// Errors of an answer, each with what it may be.
struct Judged {
  struct Error {
    std::string name;
    double off, allowed;
  };
  std::vector<Error> errors;
  bool good() const;
  std::string text() const;
};
// `floor` and `epsilon` as in the file's schema: allowed = floor + 20 epsilon sens.
Judged judge(const nlohmann::json& face, const std::vector<double>& answer, double floor, double epsilon);

}  // namespace nicol::test
