// Crystals in a uniform bright world cannot be seen either: the waves of a crystal share out all light and give it back unpolarized,
// whether they add as amplitudes or as intensities.
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

// Right-handed axes, the third one along c.
OpticFrame frame_along(const Vec3& c, const Vec3& about = {0.3, 0.8, -0.5}) {
  const Vec3 z = unit(c), x = unit(plus(about, scaled(-dot(about, z), z)));
  return {x, cross(z, x), z};
}

const OpticFrame tilted = frame_along({0.3, 0.5, 0.8});
const std::array<double, 3> calcite{1.6584, 1.6584, 1.4864}, aragonite{1.530, 1.681, 1.6855}, quartz{1.5442, 1.5442, 1.5533},
    topaz{1.6100, 1.6130, 1.6210};
// 21.7 deg/mm along the axis at 580 nm: g33 = rho n lambda/pi
const std::vector<double> quartz_gyration{-0.449 * 1.08e-4, -0.449 * 1.08e-4, 1.08e-4, 0, 0, 0};

struct Solid {
  std::string name;
  std::function<void(TestScene&)> fill;
};

const Solid solids[] = {
    {"calcite", [](TestScene& s) { s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_crystal(calcite, tilted)); }},
    {"aragonite", [](TestScene& s) { s.add_box({-8, -3, -5}, {8, 3, 5}, s.add_crystal(aragonite, tilted)); }},
    {"quartz", [](TestScene& s) { s.add_box({-8, -3, -5}, {8, 3, 5}, s.add_crystal(quartz, frame_along({0, 0, 1}), quartz_gyration)); }},
    {"circular waves, strong", [](TestScene& s) {
       const int medium = s.add_medium(1.52, 0, 1688);
       s.scene.media[medium].circular_waves = true;
       s.add_box({-8, -3, -5}, {8, 3, 5}, medium);
     }},
    {"calcite twin", [](TestScene& s) {
       const int a = s.add_box({-8, -8, -8}, {0, 8, 8}, s.add_crystal(calcite, tilted));
       const int b = s.add_box({0, -8, -8}, {8, 8, 8}, s.add_crystal(calcite, frame_along({-0.3, 0.5, 0.8})));
       s.join(Patch::Behind::cell_contact, a, x_high, b, x_low);
     }},
    {"topaz in calcite in glass", [](TestScene& s) {
       const int glass = s.add_box({-8, -8, -8}, {8, 8, 8}, s.add_medium(1.6));
       const int outer = s.add_box({-6, -6, -6}, {6, 5, 6}, s.add_crystal(calcite, tilted), glass);
       s.add_box({-2, -2, -2}, {2, 3, 2}, s.add_crystal(topaz, frame_along({1, 2, 3})), outer);
     }},
    {"quartz against aragonite across a gap", [](TestScene& s) {
       const int a = s.add_box({-8, -8, -8}, {0, 8, 8}, s.add_crystal(quartz, tilted, quartz_gyration));
       const int b = s.add_box({0, -8, -8}, {8, 8, 8}, s.add_crystal(aragonite, tilted));
       s.join(Patch::Behind::cell_gap, a, x_high, b, x_low);
     }},
};

}  // namespace

// Each solid in a world of radiance 1, for all kernels, with and without coherence. kappa: of the fields, first order in it.
template <class Look>
void in_bright_worlds(Look look) {
  for (const Kernels* kernels : all_kernels()) {
    for (const Solid& solid : solids) {
      for (const bool coherence : {false, true}) {
        CAPTURE(kernels->name);
        CAPTURE(solid.name);
        CAPTURE(coherence);
        TestScene scene;
        scene.scene.sky = {1};
        solid.fill(scene);
        scene.scene.settings.adc_bailout = 1e-3;
        scene.scene.settings.coherence = coherence;
        const double kappa = solid.name.find("quartz") == std::string::npos ? 0 : 3.5e-5;
        look(*kernels, solid.name, scene, kappa);
      }
    }
  }
}

TEST_CASE("a camera inside a crystal sees the same bright world") {
  in_bright_worlds([](const Kernels& kernels, const std::string&, TestScene& scene, double kappa) {
    scene.geometry.camera_cell = 1;
    scene.scene.settings.max_trace_level = 2000;
    std::vector<RayCase> rays = random_rays(16, 1, 17);
    for (RayCase& ray : rays) ray.position = {-7 + 0.01 * ray.position.x, 0.1 * ray.position.y, 0.1 * ray.position.z};
    Counters counters;
    for (const Light& light : kernels.follow_rays(scene.packed(kernels.lanes), rays, 0, counters)) {
      // light that total reflection keeps inside meets up to 2000 faces
      const int faces = light.cut_off > 0.5 ? 2000 : 40;
      CHECK(std::fabs(light.s0 + light.cut_off - 1) < 4 * faces * kernels.epsilon + 4 * kappa * kappa);
    }
    CHECK(counters.nan + counters.stack == 0);
  });
}

TEST_CASE("furnace with crystals: every ray brings 1, unpolarized, but for what was cut off") {
  in_bright_worlds([](const Kernels& kernels, const std::string& name, TestScene& scene, double kappa) {
    Counters counters;
    const auto lights = kernels.follow_rays(scene.packed(kernels.lanes), random_rays(200, 10, 7), 0, counters);
    double off = 0, polarized = 0;
    for (const Light& light : lights) {
      off = std::max(off, std::fabs(light.s0 + light.cut_off - 1));
      polarized = std::max(polarized, std::sqrt(light.s1 * light.s1 + light.s2 * light.s2 + light.s3 * light.s3) - light.cut_off);
    }
    MESSAGE(kernels.name << ", " << name << ": off " << off << ", polarized " << polarized << ", " << counters.segments
                         << " segments, " << counters.energy << " energy");
    CHECK(off < 300 * kernels.epsilon + 4 * kappa * kappa);
    CHECK(counters.nan == 0);
    CHECK(counters.stack == 0);
  });
}
