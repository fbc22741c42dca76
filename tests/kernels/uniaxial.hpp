// Faces between vacuum and a uniaxial crystal, solved as 4x4 boundary problems in complex double: an answer to
// hold polarizer.h to that shares no line with it.
#pragma once
#include <array>

#include "tests/kernels/under_test.hpp"

namespace nicol::test {

struct UniaxialFace {
  double n_o, n_e;
  double q;                    // tangential wave vector, along t; vacuum index 1
  double p;                    // cosine of incidence: given, for 1 - q^2 loses its digits at grazing
  std::array<double, 3> axis;  // optic axis in (t, u, N), N from vacuum into the crystal
};

// Amplitude per root of flux of the ordinary wave made by (s, p) light of unit amplitude: E = u, and h = u.
std::array<Complex, 2> into_ordinary(const UniaxialFace& face);
// (s, p) amplitudes per root of flux behind the second face (N from the crystal into vacuum) of an ordinary
// wave of unit flux that meets it.
std::array<Complex, 2> out_of_ordinary(const UniaxialFace& face);

}  // namespace nicol::test
