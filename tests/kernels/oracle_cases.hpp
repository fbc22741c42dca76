// Answers of the probe held to 60-digit solutions of faces, waves in the bulk and fields carried through it.
#pragma once
#include <nlohmann/json.hpp>

#include "tests/kernels/under_test.hpp"

namespace nicol::test {

nlohmann::json read_json(const std::string& file);  // from tests/kernels/data

// Errors of an answer, each with what it may be.
struct Judged {
  struct Error {
    std::string name;
    double off, allowed;
  };
  std::vector<Error> errors;
  void add(const std::string& name, double off, double allowed) { errors.push_back({name, off, allowed}); }
  bool good() const;
  double worst() const;  // largest share of what is allowed
  std::string text() const;
};

// allowed = floor + 20 epsilon sens: sens is the largest change of the output by a relative change of the input.
struct Precision {
  double floor, epsilon;
};
constexpr Precision in_double{1e-12, 2.2e-16}, in_float{5e-6, 1.2e-7};

// Totals always; single waves as far as the distance of their roots determines them.
Judged judge_face(const nlohmann::json& face, const Kernels& kernels, Precision precision);
Judged judge_bulk(const nlohmann::json& bulk, const Kernels& kernels, Precision precision);
Judged judge_propagation(const nlohmann::json& propagation, const Kernels& kernels, Precision precision);

}  // namespace nicol::test
