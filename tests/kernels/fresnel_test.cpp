// Reflection and refraction between transparent media: textbook identities, precision at the hard places.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol::test;

namespace {

// The case as the kernel's scalar holds it; delta in double from the rounded indices.
FresnelCase face_at(const Kernels& kernels, double n1, double n2, double cos_i) {
  n1 = kernels.round(n1);
  n2 = kernels.round(n2);
  return {kernels.round(n1 * cos_i), kernels.round((n2 - n1) * (n2 + n1)), kernels.round(n1 * n1)};
}

FresnelAnswer answer(const Kernels& kernels, const FresnelCase& face) { return kernels.fresnel({face})[0]; }

double off_one(const FresnelAnswer& a) {
  return std::max(std::fabs(std::norm(a.r_s) + a.t_s * a.t_s - 1), std::fabs(std::norm(a.r_p) + a.t_p * a.t_p - 1));
}

}  // namespace

TEST_CASE("normal incidence: ((n1 - n2)/(n1 + n2))^2, and r_p = -r_s") {
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    const FresnelAnswer a = answer(*kernels, face_at(*kernels, 1, 1.52, 1));
    CHECK(a.r_s.real() == doctest::Approx((1 - 1.52) / (1 + 1.52)).epsilon(4 * kernels->epsilon));
    CHECK(a.r_p.real() == doctest::Approx((1.52 - 1) / (1 + 1.52)).epsilon(4 * kernels->epsilon));
    CHECK(std::abs(a.r_p + a.r_s) < 4 * kernels->epsilon);
    CHECK(a.t_s * a.t_s == doctest::Approx(4 * 1.52 / (2.52 * 2.52)).epsilon(8 * kernels->epsilon));
  }
}

TEST_CASE("Brewster's angle: no p light comes back, the rays stand at right angles") {
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    const double angle = std::atan(1.52 / 1.0);
    const FresnelAnswer a = answer(*kernels, face_at(*kernels, 1, 1.52, std::cos(angle)));
    CHECK(std::abs(a.r_p) < 4 * kernels->epsilon);
    CHECK(std::abs(a.r_s) > 0.3);
    CHECK(a.p2 / 1.52 == doctest::Approx(std::sin(angle)).epsilon(8 * kernels->epsilon));
  }
}

TEST_CASE("critical angle: refraction ends where sin = n2/n1") {
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    const double critical = std::asin(1 / 1.52);
    CHECK_FALSE(answer(*kernels, face_at(*kernels, 1.52, 1, std::cos(critical - 1e-6))).total);
    CHECK(answer(*kernels, face_at(*kernels, 1.52, 1, std::cos(critical + 1e-6))).total);
  }
}

TEST_CASE("total reflection: |r| = 1 and Fresnel's phase, tan(delta/2) = cos sqrt(sin^2 - 1/n^2)/sin^2") {
  const double n = 1.51;
  for (const Kernels* kernels : all_kernels()) {
    for (double degrees = 42; degrees < 90; degrees += 1) {
      CAPTURE(kernels->name);
      CAPTURE(degrees);
      const double angle = degrees * pi / 180, sine2 = std::sin(angle) * std::sin(angle);
      const FresnelAnswer a = answer(*kernels, face_at(*kernels, n, 1, std::cos(angle)));
      CHECK(std::abs(std::abs(a.r_s) - 1) < 4 * kernels->epsilon);
      CHECK(std::abs(std::abs(a.r_p) - 1) < 4 * kernels->epsilon);
      CHECK(a.t_s == 0);
      CHECK(a.t_p == 0);
      const double half = std::atan(std::cos(angle) * std::sqrt(sine2 - 1 / (n * n)) / sine2);
      // exp(-i w t): p lags behind s
      CHECK(std::abs(std::arg(a.r_p / a.r_s) + 2 * half) < 40 * kernels->epsilon);
    }
  }
}

TEST_CASE("grazing incidence keeps its digits, down to 1e-7 rad") {
  for (const Kernels* kernels : all_kernels()) {
    for (double grazing = 1e-7; grazing < 1e-2; grazing *= 10) {
      CAPTURE(kernels->name);
      CAPTURE(grazing);
      const double p1 = std::sin(grazing), p2 = std::sqrt(p1 * p1 + 1.52 * 1.52 - 1);
      const FresnelAnswer a = answer(*kernels, face_at(*kernels, 1, 1.52, p1));
      CHECK(a.t_s * a.t_s == doctest::Approx(4 * p1 * p2 / ((p1 + p2) * (p1 + p2))).epsilon(10 * kernels->epsilon));
      CHECK(off_one(a) < 6 * kernels->epsilon);
    }
  }
}

TEST_CASE("media that match to 1e-7 reflect next to nothing, and exactly so") {
  for (const Kernels* kernels : {&double1, &double8}) {
    const double n1 = 1.5, n2 = 1.5 * (1 + 1e-7);
    const FresnelAnswer a = answer(*kernels, face_at(*kernels, n1, n2, 0.3));
    const double p1 = 0.45, delta = (n2 - n1) * (n2 + n1);
    CHECK(a.r_s.real() == doctest::Approx(-delta / (4 * p1 * p1)).epsilon(1e-5));
    CHECK(a.t_s == doctest::Approx(1).epsilon(1e-12));
  }
  const FresnelAnswer same = answer(float1, face_at(float1, 1.5, 1.5, 0.3));
  CHECK(std::abs(same.r_s) == 0);
  CHECK(std::abs(same.r_p) == 0);
  CHECK(same.t_s * same.t_s == doctest::Approx(1).epsilon(4 * float1.epsilon));
}

TEST_CASE("energy and Stokes' relations of a face looked at from both sides") {
  // r(2->1) = -r(1->2) and t is the same both ways (per root of flux)
  for (const Kernels* kernels : all_kernels()) {
    const double tolerance = kernels->epsilon < 1e-10 ? 1e-12 : 3e-6;
    CHECK(rc::check("a face, " + kernels->name, [&](unsigned a, unsigned b, unsigned c) {
      const auto unit = [](unsigned x) { return x / 4294967296.0; };
      const double n1 = 1 + 1.5 * unit(a * 2654435761u), n2 = 1 + 1.5 * unit(b * 2246822519u + 77u);
      const FresnelCase there = face_at(*kernels, n1, n2, 1e-6 + (1 - 1e-6) * unit(c * 3266489917u + 1u));
      const FresnelAnswer forth = answer(*kernels, there);
      RC_ASSERT(off_one(forth) <= tolerance);
      if (forth.total) return;
      const FresnelAnswer back = answer(*kernels, {forth.p2, -there.delta, there.eps1 + there.delta});
      // p1 comes back out of p2 only to rounding: the nearer to grazing or critical, the fewer digits
      const double p_least = std::min(there.p1, forth.p2);
      const double loss = 20 * kernels->epsilon * (1 + (2 * there.eps1 + std::fabs(there.delta)) / (p_least * p_least));
      RC_ASSERT(std::abs(back.r_s + forth.r_s) <= loss);
      RC_ASSERT(std::abs(back.r_p + forth.r_p) <= loss);
      RC_ASSERT(std::abs(back.t_s - forth.t_s) <= loss);
      RC_ASSERT(std::abs(back.t_p - forth.t_p) <= loss);
    }));
  }
}
