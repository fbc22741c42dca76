// Polarizers: Malus' law, the two ideal kinds off the normal, and the calcite plate against boundary problems.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/kernels/oracle_cases.hpp"
#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/uniaxial.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

StateAnswer state(const Kernels& kernels, const PackedScene& packed, int polarizer, Vec3 direction) {
  return kernels.passing_states(packed, {{polarizer, direction}})[0];
}

struct Bench {
  TestScene scene;
  PackedScene packed;
  explicit Bench(Polarizer::Kind kind, const std::vector<double>& azimuths_rad, int lanes) {
    for (const double a : azimuths_rad) scene.add_polarizer(kind, {std::cos(a), std::sin(a), 0}, {0, 0, 1});
    packed = scene.packed(lanes);
  }
};

}  // namespace

TEST_CASE("Malus' law, and three polarizers") {
  const nlohmann::json table = read_json("refs_malus.json");
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    for (const auto& row : table["rows"]) {
      const Bench bench(Polarizer::Kind::ideal, {0, radians(row["theta_deg"].get<double>())}, kernels->lanes);
      const StateAnswer one = state(*kernels, bench.packed, 0, {0, 0, -1}), two = state(*kernels, bench.packed, 1, {0, 0, -1});
      const double cosine = dot(one.axis, two.axis);
      CHECK(std::fabs(cosine * cosine / 2 - row["I"].get<double>()) < 4 * kernels->epsilon);
      CHECK(one.amplitude == 1);
    }
    for (const auto& row : table["three_polarisers"]) {
      const double middle = radians(row["mid_deg"].get<double>());
      const Bench bench(Polarizer::Kind::ideal_absorbing, {0, middle, pi / 2}, kernels->lanes);
      std::array<Vec3, 3> m;
      for (int i = 0; i < 3; ++i) m[i] = state(*kernels, bench.packed, i, {0, 0, -1}).axis;
      const double passed = dot(m[0], m[1]) * dot(m[1], m[2]);
      CHECK(std::fabs(passed * passed / 2 - row["I"].get<double>()) < 4 * kernels->epsilon);
    }
  }
}

TEST_CASE("off the normal, ideal keeps the transmission axis' projection, ideal_absorbing loses the absorption axis'") {
  for (const Kernels* kernels : all_kernels()) {
    CHECK(rc::check(kernels->name, [&](unsigned seed) {
      const Vec3 d = any_direction(seed);
      TestScene scene;
      const Vec3 a = unit({0.6, 0.8, 0});
      scene.add_polarizer(Polarizer::Kind::ideal, a, {0, 0, 1});
      scene.add_polarizer(Polarizer::Kind::ideal_absorbing, a, {0, 0, 1});
      const PackedScene packed = scene.packed(kernels->lanes);
      const Vec3 kept = state(*kernels, packed, 0, d).axis, left = state(*kernels, packed, 1, d).axis;
      const Vec3 lost = cross({0, 0, 1}, a);
      // a short projection has fewer digits
      const double kept_bound = 8 * kernels->epsilon / std::sqrt(1 - dot(a, d) * dot(a, d));
      const double left_bound = 8 * kernels->epsilon / std::sqrt(1 - dot(lost, d) * dot(lost, d));
      RC_ASSERT(std::fabs(dot(kept, d)) < kept_bound);
      RC_ASSERT(std::fabs(dot(left, d)) < left_bound);
      RC_ASSERT(std::fabs(dot(kept, cross(d, a))) < kept_bound);
      RC_ASSERT(std::fabs(dot(left, lost)) < left_bound);
      RC_ASSERT(std::fabs(dot(kept, kept) - 1) < 8 * kernels->epsilon);
      RC_ASSERT(std::fabs(dot(left, left) - 1) < 8 * kernels->epsilon);
    }));
  }
}

TEST_CASE("a calcite plate at normal incidence passes 4 n_o/(n_o + 1)^2 of the amplitude across its optic axis") {
  const double n_o = 1.6584;
  for (const Kernels* kernels : all_kernels()) {
    const Bench bench(Polarizer::Kind::calcite, {0.3}, kernels->lanes);
    for (const double z : {1.0, -1.0}) {
      const StateAnswer a = state(*kernels, bench.packed, 0, {0, 0, z});
      CHECK(a.amplitude == doctest::Approx(4 * n_o / ((n_o + 1) * (n_o + 1))).epsilon(8 * kernels->epsilon));
      CHECK(std::fabs(dot(a.axis, {std::cos(0.3), std::sin(0.3), 0})) == doctest::Approx(1).epsilon(4 * kernels->epsilon));
    }
  }
}

TEST_CASE("a calcite plate in the symmetry planes: the ordinary wave is s or p, Fresnel's formulas hold") {
  const double n_o = 1.6584, eps = n_o * n_o;
  for (const Kernels* kernels : all_kernels()) {
    const Bench bench(Polarizer::Kind::calcite, {0}, kernels->lanes);  // transmits x, optic axis y
    for (double degrees = 5; degrees < 90; degrees += 5) {
      CAPTURE(kernels->name);
      CAPTURE(degrees);
      const double p1 = std::cos(radians(degrees)), q = std::sin(radians(degrees)), p2 = std::sqrt(eps - q * q);
      // the ray leans along the optic axis: ordinary is s
      const StateAnswer s = state(*kernels, bench.packed, 0, {0, q, p1});
      CHECK(s.amplitude == doctest::Approx(4 * p1 * p2 / ((p1 + p2) * (p1 + p2))).epsilon(20 * kernels->epsilon));
      CHECK(std::fabs(s.axis.x) == doctest::Approx(1).epsilon(8 * kernels->epsilon));
      // the ray leans across it: ordinary is p
      const StateAnswer p = state(*kernels, bench.packed, 0, {q, 0, p1});
      CHECK(p.amplitude == doctest::Approx(4 * eps * p1 * p2 / ((eps * p1 + p2) * (eps * p1 + p2))).epsilon(20 * kernels->epsilon));
      CHECK(std::fabs(dot(p.axis, {p1, 0, -q})) == doctest::Approx(1).epsilon(8 * kernels->epsilon));
    }
  }
}

TEST_CASE("a calcite plate at any angle: both faces as 4x4 boundary problems; the faces are reciprocal") {
  for (const Kernels* kernels : all_kernels()) {
    CHECK(rc::check("calcite, " + kernels->name, [&](unsigned seed) {
      TestScene scene;
      const double azimuth = 6.28 * (seed % 997) / 997.0;
      const Vec3 a{std::cos(azimuth), std::sin(azimuth), 0}, normal{0, 0, 1};
      scene.add_polarizer(Polarizer::Kind::calcite, a, normal);
      Vec3 d = any_direction(seed);
      if (std::fabs(d.z) < 0.02) d.z = 0.02;
      d = unit(d);
      const StateAnswer plate = state(*kernels, scene.packed(kernels->lanes), 0, d);

      const Vec3 n{0, 0, d.z < 0 ? -1.0 : 1.0};
      const double q = std::hypot(d.x, d.y);
      const Vec3 t = q > 0 ? Vec3{d.x / q, d.y / q, 0} : Vec3{1, 0, 0}, u = cross(n, t), c = cross(normal, a);
      const UniaxialFace face{1.6584, 1.4864, q, std::fabs(d.z), {dot(c, t), dot(c, u), 0}};
      const auto in = into_ordinary(face), out = out_of_ordinary(face);
      // second face: its waves are those of the first, reversed, up to a sign of the ordinary field
      const Vec3 p = cross(u, d);
      const Vec3 m = plate.axis;
      const double bound = 200 * kernels->epsilon;
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          const Complex exact = out[i] * in[j];
          const double mine = plate.amplitude * dot(m, i == 0 ? u : p) * dot(m, j == 0 ? u : p);
          RC_ASSERT(std::abs(exact - mine) < bound);
        }
      }
      RC_ASSERT(std::abs(std::abs(in[0]) - std::abs(out[0])) < 1e-12);
      RC_ASSERT(std::abs(std::abs(in[1]) - std::abs(out[1])) < 1e-12);
    }));
  }
}

TEST_CASE("crossed calcite plates are dark at normal incidence, and leak off it") {
  for (const Kernels* kernels : all_kernels()) {
    const Bench bench(Polarizer::Kind::calcite, {0, pi / 2}, kernels->lanes);
    const auto leak = [&](Vec3 d) {
      return std::fabs(dot(state(*kernels, bench.packed, 0, d).axis, state(*kernels, bench.packed, 1, d).axis));
    };
    CHECK(leak({0, 0, -1}) < 4 * kernels->epsilon);
    CHECK(leak({0.5, 0, -1}) < 8 * kernels->epsilon);
    CHECK(leak({0.5, 0.5, -1}) > 0.05);
  }
}
