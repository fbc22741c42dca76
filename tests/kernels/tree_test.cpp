// The tree of rays held to end-to-end references: a glass cube, an active slab, fig. 7's phase map, a rhomb.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/kernels/oracle_cases.hpp"
#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

constexpr double direct_only = 0.05;  // adc_bailout that drops every path with a reflection at a clear face

// Front face at z = 0, seen from +z, light of radiance 1 behind.
struct Slab {
  TestScene scene;
  Slab(double n, double depth_mm, double rotation_deg_per_mm, std::optional<int> light_polarizer_x) {
    const int medium = scene.add_medium(n, 0, rotation_deg_per_mm);
    scene.add_box({-500, -500, -depth_mm}, {500, 500, 0}, medium);
    std::optional<int> polarizer;
    if (light_polarizer_x) polarizer = scene.add_polarizer(Polarizer::Kind::ideal, {1, 0, 0}, {0, 0, 1});
    scene.add_sheet({0, 0, -depth_mm - 1}, {0, 0, 1}, 1000, 1000, scene.add_emission(1, polarizer), {});
  }
};

Light look(const Kernels& kernels, TestScene& scene, Vec3 from, Vec3 direction, Vec3 axis) {
  Counters counters;
  const PackedScene packed = scene.packed(kernels.lanes);
  const Light light = kernels.follow_rays(packed, {{from, direction, axis}}, 0, counters)[0];
  CHECK(counters.nan == 0);
  CHECK(counters.energy == 0);
  CHECK(counters.stack == 0);
  return light;
}

// Right circular by definition: facing the source, x right and y up, Re(E exp(-i w t)) runs clockwise.
double right_circular(Complex x, Complex y) {
  const Complex i(0, 1), later = std::exp(-i * 0.1);
  const double x0 = x.real(), y0 = y.real(), x1 = (x * later).real(), y1 = (y * later).real();
  const double turn = (x0 * y1 - y0 * x1) / std::sin(0.1);  // > 0 counter-clockwise; |x||y| sin of the phase
  return -2 * turn;
}

}  // namespace

TEST_CASE("a glass cube: Fresnel's transmission by angle and polarization; back-lit 2n/(n^2 + 1)") {
  const nlohmann::json table = read_json("refs_glass_cube.json");
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    const double bound = 40 * kernels->epsilon;
    for (const auto& row : table["rows"]) {
      const double angle = radians(row["theta_deg"].get<double>());
      CAPTURE(row["theta_deg"].get<double>());
      Slab direct(1.52, 16, 0, {}), all(1.52, 16, 0, {});
      direct.scene.scene.settings.max_trace_level = 3;  // two faces, and what comes after the second is dropped
      direct.scene.scene.settings.adc_bailout = direct_only;
      const Vec3 d{std::sin(angle), 0, -std::cos(angle)};
      if (angle < radians(60)) {  // beyond, a reflected path is too bright for direct_only
        const Light one = look(*kernels, direct.scene, {0, 0, 5}, d, {0, 1, 0});
        CHECK(std::fabs(one.s0 - row["T1_unpol"].get<double>()) < bound);
        CHECK(std::fabs(-one.s1 - row["T1_S1"].get<double>()) < bound);  // axis = s; the table's S1 is p minus s
      }
      const Light sum = look(*kernels, all.scene, {0, 0, 5}, d, {0, 1, 0});
      CHECK(std::fabs(sum.s0 - row["Tinc_unpol"].get<double>()) < bound + 3 * sum.cut_off);
    }
    Slab normal(1.52, 16, 0, {});
    const Light light = look(*kernels, normal.scene, {0, 0, 5}, {0, 0, -1}, {1, 0, 0});
    CHECK(std::fabs(light.s0 - table["normal_backlit"].get<double>()) < bound + light.cut_off);
  }
}

TEST_CASE("an active slab between polarizers, all reflections: I = T/2 cos^2(analyzer + phi), dextro turns clockwise") {
  const nlohmann::json file = read_json("refs_active_slab.json");
  for (const Kernels* kernels : all_kernels()) {
    for (const auto& table : file["tables"]) {
      const std::string medium = table["medium"].get<std::string>();
      const double depth = table["d_mm"].get<double>(), analyzer = radians(table["analyser_deg"].get<double>());
      for (const auto& row : table["rows"]) {
        CAPTURE(kernels->name);
        CAPTURE(medium);
        CAPTURE(row["nm"].get<double>());
        const double t = row["T_slab"].get<double>(), n = (1 + std::sqrt(1 - t * t)) / t;  // T = 2n/(n^2 + 1)
        Slab slab(n, depth, row["rotation_deg"].get<double>() / depth, 0);
        const Light light = look(*kernels, slab.scene, {0, 0, 5}, {0, 0, -1}, {1, 0, 0});
        const auto& stokes = row["stokes_before_analyser"];
        const double bound = 60 * kernels->epsilon * (1 + std::fabs(row["rotation_deg"].get<double>()) / 57) + light.cut_off;
        CHECK(std::fabs(light.s0 - stokes[0].get<double>()) < bound);
        CHECK(std::fabs(light.s1 - stokes[1].get<double>()) < bound);
        CHECK(std::fabs(light.s2 - stokes[2].get<double>()) < bound);
        CHECK(std::fabs(light.s3) < bound);
        const double through = (light.s0 + light.s1 * std::cos(2 * analyzer) + light.s2 * std::sin(2 * analyzer)) / 2;
        CHECK(std::fabs(through - row["I"].get<double>()) < bound);
      }
    }
  }
}

TEST_CASE("an absorbing slab: Beer's law between Fresnel's faces, all reflections") {
  const double n = 1.5, depth = 16;
  for (const double k : {1e-7, 1e-6, 1e-5}) {
    for (const Kernels* kernels : all_kernels()) {
      TestScene scene;
      scene.add_box({-500, -500, -depth}, {500, 500, 0}, scene.add_medium(n, k));
      scene.add_sheet({0, 0, -depth - 1}, {0, 0, 1}, 1000, 1000, scene.add_emission(1), {});
      const Light light = look(*kernels, scene, {0, 0, 5}, {0, 0, -1}, {1, 0, 0});
      const double passed = std::exp(-4 * pi * k / 580e-6 * depth), r = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
      const double expected = (1 - r) * (1 - r) * passed / (1 - r * r * passed * passed);
      CAPTURE(kernels->name);
      CAPTURE(k);
      // the flux between two waves in an absorbing medium, of order k^2, is nobody's
      CHECK(std::fabs(light.s0 - expected) < 40 * kernels->epsilon + 2 * k * k + light.cut_off);
    }
  }
}

TEST_CASE("right quartz turns the plane clockwise in the picture, whichever way the light runs") {
  for (const Kernels* kernels : all_kernels()) {
    Slab slab(1.0, 1, 30, 0);  // no reflections
    const Light light = look(*kernels, slab.scene, {0, 0, 5}, {0, 0, -1}, {1, 0, 0});
    // azimuth, counter-clockwise facing the source, x right and y up: from 0 to -30 degrees
    CHECK(0.5 * std::atan2(light.s2, light.s1) == doctest::Approx(radians(-30)).epsilon(10 * kernels->epsilon));
  }
}

TEST_CASE("fig. 7: 27009 degrees in a 16 mm cube, seen from 30, 50 and 100 mm") {
  const nlohmann::json file = read_json("refs_fig7_rotation.json");
  for (const Kernels* kernels : all_kernels()) {
    for (const auto& table : file["tables"]) {
      const double distance = table["camera_distance_mm"].get<double>();
      for (const bool analyzer_x : {true, false}) {
        Slab slab(1.52, 16, file["alpha_deg_per_mm"].get<double>(), 0);
        slab.scene.scene.settings.adc_bailout = direct_only / 2;  // weight is half behind the analyzer
        slab.scene.scene.camera.location = {0, 0, distance};
        slab.scene.scene.camera.direction = {0, 0, -distance};
        slab.scene.scene.camera.right = {17, 0, 0};
        slab.scene.scene.camera.up = {0, 17, 0};
        slab.scene.scene.camera.polarizer =
            slab.scene.add_polarizer(Polarizer::Kind::ideal, analyzer_x ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, {0, 0, 1});
        Counters counters;
        const auto picture = kernels->render(slab.scene.packed(kernels->lanes, 17, 17), counters);
        CHECK(counters.nan + counters.energy + counters.stack + counters.stokes == 0);
        double worst = 0;
        for (const auto& row : table["rows"]) {
          const int x = static_cast<int>(row[0].get<double>()) + 8, y = 8 - static_cast<int>(row[1].get<double>());
          const double mine = picture[y * 17 + x][0];
          // the reference's light is polarized with intensity 1, ours is half of unpolarized light
          worst = std::max(worst, std::fabs(2 * mine - row[analyzer_x ? 5 : 6].get<double>()));
        }
        CAPTURE(kernels->name);
        CAPTURE(distance);
        // float: 27009 degrees are 471 rad, the path length has 24 bits
        CHECK(worst < 1000 * kernels->epsilon);
        MESSAGE(kernels->name << " fig. 7 from " << distance << " mm: intensity off by up to " << worst);
      }
    }
  }
}

TEST_CASE("Fresnel's rhomb: two total reflections at 51.782 degrees make 45-degree light circular, of the right hand") {
  const double n = 1.49661, angle = radians(51.782);
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    TestScene scene;
    const int medium = scene.add_medium(n);
    // light runs along z through the end faces and meets the tilted sides, 16 mm apart, at `angle`
    const Vec3 side{std::sin(angle), 0, std::cos(angle)};
    scene.add_solid({{side, 8}, {scaled(-1, side), 8}, {{0, 0, -1}, 16}, {{0, 0, 1}, 16}, {{0, 1, 0}, 50}, {{0, -1, 0}, 50}},
                    {0, 0, 0}, 100, medium);
    const int polarizer = scene.add_polarizer(Polarizer::Kind::ideal, unit({1, 1, 0}), {0, 0, 1});
    scene.add_sheet({0, 0, -60}, {0, 0, 1}, 300, 300, scene.add_emission(2, polarizer), {});
    scene.scene.settings.adc_bailout = direct_only;
    // the camera looks along -z at the upper end face, where the twice reflected light comes out
    const Light light = look(*kernels, scene, {-3.0, 0, 60}, {0, 0, -1}, {1, 0, 0});
    const double t = 4 * n / ((n + 1) * (n + 1));
    CHECK(light.s0 == doctest::Approx(t * t).epsilon(1e-5));
    CHECK(std::fabs(light.s1) < 2e-4);
    CHECK(std::fabs(light.s2) < 2e-4);
    // textbook amplitudes: s along y; p along e_p = e_s x k, which is x before and after
    const double sine2 = std::sin(angle) * std::sin(angle), kappa = std::sqrt(sine2 - 1 / (n * n));
    const Complex i(0, 1), r_s = (std::cos(angle) - i * kappa) / (std::cos(angle) + i * kappa);
    const Complex r_p = (std::cos(angle) - n * n * i * kappa) / (std::cos(angle) + n * n * i * kappa);
    const double expected = right_circular(r_p * r_p / std::sqrt(2.0), r_s * r_s / std::sqrt(2.0));
    CHECK(std::fabs(expected) > 0.999);
    CHECK(light.s3 == doctest::Approx(expected * t * t).epsilon(1e-4));
    MESSAGE("rhomb: S3/S0 = " << light.s3 / light.s0);
  }
}
