// Faces of a 60-digit solver of the wave determinant, answered by the probe in double and float.
#include <doctest/doctest.h>

#include "tests/kernels/oracle_cases.hpp"

using namespace nicol::test;

namespace {

void hold(const char* file, const Kernels& kernels, double floor, double epsilon, std::size_t expected) {
  const nlohmann::json faces = read_json(file)["interface"];
  CHECK(faces.size() == expected);
  for (const nlohmann::json& face : faces) {
    const Judged judged = judge(face, kernels.solve_face(probe_problem(face)), floor, epsilon);
    INFO(face["id"].get<std::string>() << " " << face["tag"].get<std::string>() << ": " << judged.text());
    CHECK(judged.good());
  }
}

}  // namespace

TEST_CASE("the oracle's faces in double") { hold("faces.json", double1, 1e-12, 2.2e-16, 59); }
TEST_CASE("the oracle's faces in float") { hold("faces.json", float1, 5e-6, 1.2e-7, 59); }

// Incident flux taken from the given fields loses its digits there, and the branch of p2 is not Re p2^2's.
TEST_CASE("absorbing media at grazing and critical incidence, in double") { hold("faces_hard.json", double1, 1e-12, 2.2e-16, 12); }
TEST_CASE("absorbing media at grazing and critical incidence, in float") { hold("faces_hard.json", float1, 5e-6, 1.2e-7, 12); }
