// Faces of optically active media: energy and reciprocity of their circular waves.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/kernels/under_test.hpp"

using namespace nicol::test;

namespace {

double unit(unsigned x) { return x / 4294967296.0; }

// A face with random media (active, or not in a quarter of the cases each) and incidence.
ActiveCase any_face(unsigned a, unsigned b, unsigned c, unsigned d) {
  ActiveCase face{};
  face.n1 = 1 + 1.5 * unit(a * 2654435761u);
  face.n2 = 1 + 1.5 * unit(b * 2246822519u + 77u);
  face.kappa1 = d % 4 == 0 ? 0 : 5.4e-3 * (unit(c * 668265263u + 5u) - 0.5);
  face.kappa2 = d / 4 % 4 == 0 ? 0 : 5.4e-3 * (unit(d * 374761393u + 9u) - 0.5);
  face.wave = static_cast<int>(d / 16 % 2);
  face.p1 = (1e-3 + (1 - 1e-3) * unit(d * 3266489917u + 1u)) * (face.n1 - std::fabs(face.kappa1));
  return face;
}

}  // namespace

TEST_CASE("energy at active faces: R + T = 1, and the four waves share it out") {
  for (const Kernels* kernels : all_kernels()) {
    const double tolerance = kernels->epsilon < 1e-10 ? 1e-12 : 3e-6;
    CHECK(rc::check("energy, " + kernels->name, [&](unsigned a, unsigned b, unsigned c, unsigned d) {
      const ActiveCase face = any_face(a, b, c, d);
      const ActiveAnswer answer = kernels->active_face({face})[0];
      // the flux that comes in is a difference of two products, good to epsilon n/p1
      const double allowed = tolerance * (1 + 0.02 / (face.p1 * face.p1));
      RC_ASSERT(std::fabs(answer.r + answer.t - 1) <= allowed);
      RC_ASSERT(std::fabs(answer.power[0] + answer.power[1] + answer.power[2] + answer.power[3] - 1) <= allowed);
    }));
  }
}

TEST_CASE("reciprocity: wave i to wave j passes what j to i passes") {
  CHECK(rc::check([](unsigned a, unsigned b, unsigned c, unsigned d) {
    const ActiveCase there = any_face(a, b, c, d);
    const ActiveAnswer forth = double1.active_face({there})[0];
    const auto index = [](double n, double kappa, int wave) { return wave == 0 ? n - kappa : n + kappa; };
    const double k1 = index(there.n1, there.kappa1, there.wave);
    for (int wave = 0; wave < 2; ++wave) {
      const double k2 = index(there.n2, there.kappa2, wave), squared = there.p1 * there.p1 + (k2 - k1) * (k2 + k1);
      if (squared < 1e-6) continue;
      const ActiveCase here{there.n2, there.kappa2, there.n1, there.kappa1, std::sqrt(squared), wave};
      const ActiveAnswer back = double1.active_face({here})[0];
      RC_ASSERT(std::fabs(forth.power[2 + wave] - back.power[2 + there.wave]) < 1e-10);
    }
    // reflection: from wave i into wave j of the same medium
    const int other = 1 - there.wave;
    const double k3 = index(there.n1, there.kappa1, other), squared = there.p1 * there.p1 + (k3 - k1) * (k3 + k1);
    if (squared < 1e-6) return;
    ActiveCase from_other = there;
    from_other.wave = other;
    from_other.p1 = std::sqrt(squared);
    RC_ASSERT(std::fabs(forth.power[other] - double1.active_face({from_other})[0].power[there.wave]) < 1e-10);
  }));
}

TEST_CASE("normal incidence: an active face reflects as its mean index says, and swaps the hands") {
  for (const Kernels* kernels : all_kernels()) {
    for (const int wave : {0, 1}) {
      const double kappa = 2.72e-3, k1 = wave == 0 ? 1.52 - kappa : 1.52 + kappa;
      const ActiveAnswer answer = kernels->active_face({{1.52, kappa, 1, 0, k1, wave}})[0];
      CHECK(answer.r == doctest::Approx(std::pow(0.52 / 2.52, 2)).epsilon(20 * kernels->epsilon));
      CHECK(answer.power[1 - wave] == doctest::Approx(answer.r).epsilon(40 * kernels->epsilon));
    }
  }
}
