// Contacts are limits: what touches looks as what stands a billionth of a millimetre apart, and a seam as nothing.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

std::vector<RayCase> rays_at(int count, double ball_mm) {
  std::vector<RayCase> rays;
  Dice dice{4};
  for (int i = 0; i < count; ++i) {
    const Vec3 from = scaled(60, any_direction(3 * i + 1)), at = scaled(ball_mm * dice(), any_direction(3 * i + 2));
    rays.push_back({from, unit(plus(at, scaled(-1, from))), any_direction(3 * i + 3)});
  }
  return rays;
}

// Shares of rays that the two scenes do not show alike.
double unlike(const Kernels& kernels, TestScene one, TestScene other, double bound) {
  const auto rays = rays_at(400, 9);
  Counters counters;
  const auto a = kernels.follow_rays(one.packed(kernels.lanes), rays, 0, counters);
  const auto b = kernels.follow_rays(other.packed(kernels.lanes), rays, 0, counters);
  CHECK(counters.nan + counters.energy + counters.stack == 0);
  int different = 0;
  double brightest = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double allowed = bound + a[i].cut_off + b[i].cut_off;
    brightest = std::max(brightest, a[i].s0);
    different += !(std::fabs(a[i].s0 - b[i].s0) < allowed && std::fabs(a[i].s1 - b[i].s1) < allowed &&
                   std::fabs(a[i].s2 - b[i].s2) < allowed && std::fabs(a[i].s3 - b[i].s3) < allowed);
  }
  CHECK(brightest > 0.1);
  return different / static_cast<double>(rays.size());
}

// Something to see: a dim sky and lamps that break every symmetry.
TestScene lit() {
  TestScene s;
  s.scene.sky = {0.1};
  s.scene.settings.adc_bailout = 1e-7;
  const int slanted = s.add_polarizer(Polarizer::Kind::ideal, unit({1, 0.4, 0}), {0, 0, 1});
  s.add_sheet({3, 2, -30}, {0, 0, 1}, 25, 30, s.add_emission(1, slanted), {});
  s.add_sheet({-2, 5, 30}, {0, 0, 1}, 15, 12, s.add_emission(0.6), {});
  return s;
}

const double gap = 1e-9;
const std::vector<Plane> overlap{{{0, 1, 0}, 4}, {{0, -1, 0}, 4}, {{0, 0, 1}, 6}, {{0, 0, -1}, 6}};

}  // namespace

TEST_CASE("a solid cut in two by a seam looks whole") {
  for (const Kernels* kernels : all_kernels()) {
    TestScene whole = lit(), parts = lit();
    whole.add_box({-8, -8, -8}, {8, 8, 8}, whole.add_medium(1.52, 0, 40));
    const int glass = parts.add_medium(1.52, 0, 40);
    const int a = parts.add_box({-8, -8, -8}, {1, 8, 8}, glass), b = parts.add_box({1, -8, -8}, {8, 8, 8}, glass);
    parts.join(Patch::Behind::seam, a, x_high, b, x_low);
    CAPTURE(kernels->name);
    // in float a ray near an edge may take the other way; one in a hundred at most
    CHECK(unlike(*kernels, whole, parts, kernels->epsilon < 1e-10 ? 1e-9 : 1e-3) <= (kernels->epsilon < 1e-10 ? 0 : 0.01));
  }
}

TEST_CASE("optical contact of equal media is a seam") {
  for (const Kernels* kernels : {&double1, &double8}) {
    TestScene seam = lit(), contact = lit();
    for (TestScene* s : {&seam, &contact}) {
      const int glass = s->add_medium(1.52), a = s->add_box({-8, -8, -8}, {1, 8, 8}, glass), b = s->add_box({1, -8, -8}, {8, 8, 8}, glass);
      s->join(s == &seam ? Patch::Behind::seam : Patch::Behind::cell_contact, a, x_high, b, x_low);
    }
    CHECK(unlike(*kernels, seam, contact, 1e-9) == 0);
  }
}

TEST_CASE("a vanishing gap between solids") {
  for (const Kernels* kernels : {&double1, &double8}) {
    TestScene touching = lit(), apart = lit();
    for (TestScene* s : {&touching, &apart}) {
      const int glass = s->add_medium(1.52), other = s->add_medium(1.33);
      const int a = s->add_box({-8, -8, -6}, {0, 8, 6}, glass);
      const int b = s->add_box({s == &apart ? gap : 0, -4, -8}, {8, 4, 8}, other);
      if (s == &touching) s->join(Patch::Behind::cell_gap, a, x_high, b, x_low, overlap);
    }
    CAPTURE(kernels->name);
    CHECK(unlike(*kernels, touching, apart, 1e-6) < 0.005);
  }
}

TEST_CASE("a solid on a light, on one side of it and on part of it") {
  for (const Kernels* kernels : {&double1, &double8}) {
    for (const bool one_sided : {false, true}) {
      for (const double facing : {1.0, -1.0}) {
        TestScene touching = lit(), apart = lit();
        for (TestScene* s : {&touching, &apart}) {
          const int cube = s->add_box({-8, -8, -8}, {8, 8, 8}, s->add_medium(1.52));
          const int polarizer = s->add_polarizer(Polarizer::Kind::ideal, {0.6, 0.8, 0}, {0, 0, 1});
          const int sheet = s->add_sheet({0, 0, s == &touching ? -8 : -8 - gap}, {0, 0, facing}, 4, 5, s->add_emission(3, polarizer, one_sided), {});
          if (s == &touching) {
            s->cover(cube, z_low, sheet, {{{1, 0, 0}, 4}, {{-1, 0, 0}, 4}, {{0, 1, 0}, 5}, {{0, -1, 0}, 5}});
          }
        }
        CAPTURE(kernels->name);
        CAPTURE(one_sided);
        CAPTURE(facing);
        CHECK(unlike(*kernels, touching, apart, 1e-6) < 0.005);
      }
    }
  }
}

TEST_CASE("a solid on a polarizer that overhangs or covers a part") {
  for (const Kernels* kernels : {&double1, &double8}) {
    for (const auto kind : {Polarizer::Kind::ideal, Polarizer::Kind::calcite}) {
      for (const double half : {4.0, 12.0}) {
        TestScene touching = lit(), apart = lit();
        for (TestScene* s : {&touching, &apart}) {
          const int cube = s->add_box({-8, -8, -8}, {8, 8, 8}, s->add_medium(1.52));
          const int polarizer = s->add_polarizer(kind, {0.6, 0.8, 0}, {0, 0, 1});
          const int sheet = s->add_sheet({0, 0, s == &touching ? -8 : -8 - gap}, {0, 0, 1}, half, half, {}, polarizer);
          if (s == &apart) continue;
          if (half < 8) {
            s->cover(cube, z_low, sheet, {{{1, 0, 0}, half}, {{-1, 0, 0}, half}, {{0, 1, 0}, half}, {{0, -1, 0}, half}});
          } else {
            s->cover(cube, z_low, sheet);
          }
        }
        CAPTURE(kernels->name);
        CAPTURE(half);
        CHECK(unlike(*kernels, touching, apart, 1e-6) < 0.005);
      }
    }
  }
}

TEST_CASE("a polarizer between two solids, touching both") {
  for (const Kernels* kernels : {&double1, &double8}) {
    TestScene touching = lit(), apart = lit();
    for (TestScene* s : {&touching, &apart}) {
      const double off = s == &apart ? gap : 0;
      const int glass = s->add_medium(1.52);
      const int low = s->add_box({-8, -8, -8}, {8, 8, 0}, glass), high = s->add_box({-8, -8, 2 * off}, {8, 8, 8 + 2 * off}, glass);
      const int polarizer = s->add_polarizer(Polarizer::Kind::ideal, {0.6, 0.8, 0}, {0, 0, 1});
      const int sheet = s->add_sheet({0, 0, off}, {0, 0, 1}, 8, 8, {}, polarizer);
      if (s == &apart) continue;
      s->cover(low, z_high, sheet);
      s->cover(high, z_low, sheet);
    }
    CAPTURE(kernels->name);
    CHECK(unlike(*kernels, touching, apart, 1e-6) < 0.005);
  }
}
