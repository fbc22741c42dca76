// A uniform bright world: whatever is transparent in it cannot be seen. Every ray brings exactly 1, unpolarized.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/kernels/random_rays.hpp"
#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

struct Furnace {
  std::string name;
  std::function<void(TestScene&)> fill;
};

const Furnace furnaces[] = {
    {"a glass cube", [](TestScene& s) { s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_medium(1.52)); }},
    {"an active diamond box", [](TestScene& s) { s.add_box({-8, -3, -5}, {8, 3, 5}, s.add_medium(2.42, 0, 1688)); }},
    {"three solids apart", [](TestScene& s) {
       const int glass = s.add_medium(1.6);
       s.add_box({-8, -8, -8}, {-2, 8, 8}, glass);
       s.add_box({-1, -8, -8}, {3, 8, 8}, s.add_medium(1.33));
       s.add_box({4, -8, -8}, {8, 8, 8}, glass);
     }},
    {"a cell in a cell in a cell", [](TestScene& s) {
       const int outer = s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_medium(1.33));
       const int middle = s.add_box({-5, -4, -5}, {4, 5, 5}, s.add_medium(1.8), outer);
       s.add_box({-2, -2, -2}, {2, 3, 2}, s.add_medium(1.2), middle);
       s.add_box({5, 5, 5}, {7, 7, 7}, s.add_medium(1), outer);
     }},
    {"two solids across a vanishing gap, partly", [](TestScene& s) {
       const int a = s.add_box({-8, -8, -8}, {0, 8, 8}, s.add_medium(1.52)), b = s.add_box({0, -4, -8}, {8, 4, 12}, s.add_medium(1.7));
       s.join(Patch::Behind::cell_gap, a, x_high, b, x_low,
              {{{0, 1, 0}, 4}, {{0, -1, 0}, 4}, {{0, 0, 1}, 8}, {{0, 0, -1}, 8}});
     }},
    {"two solids in optical contact, partly", [](TestScene& s) {
       const int a = s.add_box({-8, -8, -8}, {0, 8, 8}, s.add_medium(1.52)), b = s.add_box({0, -4, -8}, {8, 4, 12}, s.add_medium(1.7));
       s.join(Patch::Behind::cell_contact, a, x_high, b, x_low,
              {{{0, 1, 0}, 4}, {{0, -1, 0}, 4}, {{0, 0, 1}, 8}, {{0, 0, -1}, 8}});
     }},
    {"a solid of two parts", [](TestScene& s) {
       const int glass = s.add_medium(1.52), a = s.add_box({-8, -8, -8}, {0, 8, 8}, glass), b = s.add_box({0, -8, -8}, {8, 8, 8}, glass);
       s.join(Patch::Behind::seam, a, x_high, b, x_low);
     }},
    {"a cube that stands on a bright sheet, another sheet and a ring about", [](TestScene& s) {
       const int cube = s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_medium(1.52)), light = s.add_emission(1);
       s.cover(cube, z_low, s.add_sheet({0, 0, -8}, {0, 0, 1}, 20, 20, light, {}));
       s.add_sheet({0, 0, 12}, {0, 0, 1}, 3, 5, light, {});
       s.add_disc({0, 0, 14}, unit({0.2, 0.3, 1}), 9, 4, light, {});
     }},
    {"a cube on a bright ring", [](TestScene& s) {
       const int cube = s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_medium(1.52));
       const Ring ring{{0, 0, -8}, 6, 2};
       s.cover(cube, z_low, s.add_disc({0, 0, -8}, {0, 0, -1}, 6, 2, s.add_emission(1), {}), {}, &ring);
     }},
};

TestScene build(const Furnace& furnace) {
  TestScene scene;
  scene.scene.sky = {1};
  furnace.fill(scene);
  return scene;
}

}  // namespace

TEST_CASE("furnace: every ray brings 1, unpolarized, but for what was cut off; no counter counts") {
  for (const Kernels* kernels : all_kernels()) {
    for (const Furnace& furnace : furnaces) {
      for (const double adc_bailout : {1e-5, 1e-9}) {
        CAPTURE(kernels->name);
        CAPTURE(furnace.name);
        CAPTURE(adc_bailout);
        TestScene scene = build(furnace);
        scene.scene.settings.adc_bailout = adc_bailout;
        Counters counters;
        const int count = adc_bailout < 1e-6 ? 40 : 400;
        const auto lights = kernels->follow_rays(scene.packed(kernels->lanes), random_rays(count, 10, 7), 0, counters);
        double off = 0, polarized = 0;
        for (const Light& light : lights) {
          CHECK(std::isfinite(light.s0 + light.s1 + light.s2 + light.s3 + light.cut_off));
          off = std::max(off, std::fabs(light.s0 + light.cut_off - 1));
          polarized = std::max(polarized, std::sqrt(light.s1 * light.s1 + light.s2 * light.s2 + light.s3 * light.s3) - light.cut_off);
        }
        const double bound = 300 * kernels->epsilon;   // trees of 5e5 segments too: the sums are compensated
        CHECK(off < bound);
        CHECK(polarized < bound);
        CHECK(counters.nan == 0);
        CHECK(counters.energy == 0);
        CHECK(counters.stack == 0);
        CHECK(counters.segments > 40);
      }
    }
  }
}

TEST_CASE("furnace in float over 1e5 rays: no counter counts") {
  TestScene scene = build(furnaces[0]);
  scene.scene.settings.adc_bailout = 1e-5;
  Counters counters;
  const auto lights = float8.follow_rays(scene.packed(8), random_rays(100000, 10, 99), 0, counters);
  double off = 0;
  for (const Light& light : lights) off = std::max(off, std::fabs(light.s0 + light.cut_off - 1));
  MESSAGE("1e5 rays in float: S0 off by up to " << off << ", " << counters.segments << " segments");
  CHECK(off < 1e-4);
  CHECK(counters.nan == 0);
  CHECK(counters.energy == 0);
  CHECK(counters.stack == 0);
}
