// 60-digit solutions of the wave determinant, all classes of media and pairs of them, answered by the probe in double
// and float.
#include <doctest/doctest.h>

#include "tests/kernels/oracle_cases.hpp"

using namespace nicol::test;

namespace {

using Judge = Judged (*)(const nlohmann::json&, const Kernels&, Precision);

void hold(const char* file, const char* kind, Judge judge, const Kernels& kernels, Precision precision,
    std::size_t expected) {
  const nlohmann::json cases = read_json(file)[kind];
  CHECK(cases.size() == expected);
  for (const nlohmann::json& one : cases) {
    const Judged judged = judge(one, kernels, precision);
    INFO(one["id"].get<std::string>() << " " << one.value("tag", "") << ": " << judged.text());
    CHECK(judged.good());
  }
}

}  // namespace

TEST_CASE("faces in double") { hold("vectors.json", "interface", judge_face, double1, in_double, 300); }
TEST_CASE("faces in float") { hold("vectors.json", "interface", judge_face, float1, in_float, 300); }
TEST_CASE("waves in the bulk in double") { hold("vectors.json", "bulk", judge_bulk, double1, in_double, 60); }
TEST_CASE("waves in the bulk in float") { hold("vectors.json", "bulk", judge_bulk, float1, in_float, 60); }
TEST_CASE("a field carried through crystals in double") { hold("vectors.json", "propagation", judge_propagation,
    double1, in_double, 24); }
TEST_CASE("a field carried through crystals in float") { hold("vectors.json", "propagation", judge_propagation,
    float1, in_float, 24); }

// Incident flux taken from the given fields loses its digits there, and the branch of p2 is not Re p2^2's.
TEST_CASE("absorbing media at grazing and critical incidence, in double") {
  hold("faces_hard.json", "interface", judge_face, double1, in_double, 12);
}
TEST_CASE("absorbing media at grazing and critical incidence, in float") {
  hold("faces_hard.json", "interface", judge_face, float1, in_float, 12);
}
