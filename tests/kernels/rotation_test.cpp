// Optical rotation: the phase of up to 1e7 degrees, its sense, and what a way there and back does.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/kernels/under_test.hpp"

using namespace nicol::test;

namespace {

constexpr long double pi = 3.14159265358979323846264338327950288L;

// The angle between the answer and a phase given in turns, in degrees.
double off_degrees(Complex answer, long double turns) {
  const long double rest = turns - std::rint(turns);
  const std::complex<long double> exact = std::polar<long double>(1, 2 * pi * rest);
  return static_cast<double>(std::arg(std::complex<long double>(answer) / exact) * 180 / pi);
}

Complex turned(const Kernels& kernels, double turns_per_mm, double depth_mm) {
  return kernels.rotation({{turns_per_mm, depth_mm}})[0];
}

}  // namespace

TEST_CASE("27008.17 degrees and 1e7 degrees keep their fraction of a turn") {
  for (const Kernels* kernels : all_kernels()) {
    for (const double total_deg : {27008.17, 1e7, -27008.17, 21.7}) {
      for (const double depth_mm : {16.0, 1.0, 15.731, 0.125}) {
        CAPTURE(kernels->name);
        CAPTURE(total_deg);
        CAPTURE(depth_mm);
        const double depth = kernels->round(depth_mm), turns_per_mm = total_deg / 360 / depth_mm;
        const Complex answer = turned(*kernels, turns_per_mm, depth);
        const long double exact = static_cast<long double>(turns_per_mm) * depth;
        // float: two floats of turns; 1e-5 degrees at 27000. double: the rounding of turns_per_mm itself
        const double bound = kernels->epsilon > 1e-10 ? 1e-5 + 1e-12 * std::fabs(total_deg) : 1e-13 + 5e-16 * std::fabs(total_deg);
        CHECK(std::fabs(off_degrees(answer, exact)) < bound + (kernels->epsilon > 1e-10 ? 3e-5 : 5e-14));
        CHECK(std::abs(answer) == doctest::Approx(1).epsilon(4 * kernels->epsilon));
      }
    }
  }
}

TEST_CASE("quarter turns come out exactly") {
  for (const Kernels* kernels : all_kernels()) {
    const Complex quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int k = -8; k <= 8; ++k) {
      CAPTURE(kernels->name);
      CAPTURE(k);
      CHECK(turned(*kernels, 0.25 * k, 1) == quarters[((k % 4) + 4) % 4]);
    }
  }
}

TEST_CASE("ways add up, and left undoes right") {
  for (const Kernels* kernels : all_kernels()) {
    CHECK(rc::check("composition, " + kernels->name, [&](unsigned a, unsigned b) {
      const double one = (a % 1048576) / 65536.0, two = (b % 1048576) / 65536.0;  // exact in float, as is the sum
      const double turns_per_mm = 1688.0625 / 360;
      const Complex product = turned(*kernels, turns_per_mm, one) * turned(*kernels, turns_per_mm, two);
      RC_ASSERT(std::abs(product - turned(*kernels, turns_per_mm, one + two)) < 16 * kernels->epsilon + 1e-15 * 200);
      RC_ASSERT(std::abs(turned(*kernels, turns_per_mm, one) * turned(*kernels, -turns_per_mm, one) - 1.0) < 8 * kernels->epsilon);
    }));
  }
}
