// Plates of crystal before a polarized light, against closed forms: rotation along the axis of quartz, wave plates with all their
// reflections, walk-off, plates turned over, and crystals that are hardly birefringent.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

constexpr double lambda_mm = 580e-6;

OpticFrame frame_along(const Vec3& c, const Vec3& about) {
  const Vec3 z = unit(c), x = unit(plus(about, scaled(-dot(about, z), z)));
  return {x, cross(z, x), z};
}

// A plate across z before a light polarized along `axis`; seen from above along -z with the picture's x to the right.
struct Bench {
  TestScene scene;
  int medium = 0;
  explicit Bench(double pixel_mm = 0.01) {
    scene.scene.settings.adc_bailout = 1e-12;
    scene.scene.camera.orthographic = true;
    scene.scene.camera.right = {pixel_mm, 0, 0};
    scene.scene.camera.up = {0, pixel_mm, 0};
    scene.scene.camera.location = {0, 0, 100};
  }
  void light(const Vec3& axis) {
    const int polarizer = scene.add_polarizer(Polarizer::Kind::ideal, axis, {0, 0, 1});
    scene.add_sheet({0, 0, -50}, {0, 0, 1}, 40, 40, scene.add_emission(2, polarizer), {});   // 1 passes
  }
  void plate(int of, double thickness_mm) { scene.add_box({-30, -30, 0}, {30, 30, thickness_mm}, of); }
  // What one pixel brings that looks down on the plate, its cones sampled as the scene says.
  double cone(const Kernels& kernels, const Vec3& from) {
    scene.scene.camera.location = plus(from, {-0.005, -0.005, 0});
    scene.scene.camera.direction = {0, 0, -1};
    Counters counters;
    const auto picture = kernels.render(scene.packed(kernels.lanes), counters);
    CHECK(counters.nan + counters.energy + counters.stack == 0);
    return picture.front()[0];
  }
  Light look(const Kernels& kernels, const Vec3& direction = {0, 0, -1}, const Vec3& from = {1e300, 0, 0}) {
    Counters counters;
    const Vec3 x = unit(plus({1, 0, 0}, scaled(-direction.x, direction)));
    const Vec3 position = from.x < 1e299 ? from : scaled(-60, direction);
    const std::vector<RayCase> rays(kernels.lanes, RayCase{position, direction, x});
    const Light light = kernels.follow_rays(scene.packed(kernels.lanes), rays, 0, counters).front();
    CHECK(counters.nan + counters.energy + counters.stack == 0);
    return light;
  }
};

double degrees(double rad) { return rad * 180 / pi; }
double azimuth_deg(const Light& l) { return degrees(std::atan2(l.s2, l.s1) / 2); }

const std::array<double, 3> quartz{1.54425, 1.54425, 1.55336}, calcite{1.65835, 1.65835, 1.48640};
std::vector<double> gyration_of(double rho_deg_per_mm, double n_o) {
  const double g33 = radians(rho_deg_per_mm) * n_o * lambda_mm / pi;
  return {-0.449 * g33, -0.449 * g33, g33, 0, 0, 0};
}

}  // namespace

TEST_CASE("quartz along its axis turns light clockwise for the receiver by rho d, and nothing else") {
  for (const Kernels* kernels : all_kernels()) {
    for (const double rho : {21.724, -21.724}) {
      CAPTURE(kernels->name);
      CAPTURE(rho);
      Bench bench;
      bench.light({1, 0, 0});
      bench.plate(bench.scene.add_crystal(quartz, frame_along({0, 0, 1}, {1, 0, 0}), gyration_of(rho, quartz[0])), 3);
      const Light l = bench.look(*kernels);
      double turned = azimuth_deg(l) + 3 * rho;   // clockwise: the azimuth falls
      turned -= 180 * std::rint(turned / 180);
      CHECK(std::fabs(turned) < (kernels->epsilon > 1e-10 ? 2e-3 : 1e-6));
      const double r = std::pow((quartz[0] - 1) / (quartz[0] + 1), 2);
      const double kappa = 3.5e-5;   // fields are first order in it
      CHECK(std::fabs(l.s0 - (1 - r) / (1 + r)) < 4 * kappa * kappa + 100 * kernels->epsilon);
      CHECK(std::hypot(l.s1, l.s2) == doctest::Approx(l.s0).epsilon(1e-5));   // still linear
    }
  }
}

// kappa = rho lambda/2 pi: 300 deg/mm give 4.8e-4.
TEST_CASE("circular waves of an isotropic medium turn light by rho d; out of a prism they leave at two angles") {
  const double rho = 300, n = 1.52, kappa = rho / 360 * lambda_mm;
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    Bench bench;
    bench.light({1, 0, 0});
    const int medium = bench.scene.add_medium(n, 0, rho);
    bench.scene.scene.media[medium].circular_waves = true;
    bench.plate(medium, 3.1);
    const Light l = bench.look(*kernels);
    double turned = azimuth_deg(l) + 3.1 * rho;
    turned -= 180 * std::rint(turned / 180);
    CHECK(std::fabs(turned) < (kernels->epsilon > 1e-10 ? 5e-3 : 1e-6));
    const double r = std::pow((n - 1) / (n + 1), 2);
    CHECK(std::fabs(l.s0 - (1 - r) / (1 + r)) < 300 * kernels->epsilon);   // one impedance for both
    // a prism of 30 degrees, entered along z: sin(30 + deviation) = (n +- kappa)/2, a bright half-plane far away
    Bench prism(2);   // a pixel of 0.01 mm could not tell their angles apart: it would spread them by lambda/pixel
    const int wedge = prism.scene.add_medium(n, 0, rho);
    prism.scene.scene.media[wedge].circular_waves = true;
    const double far_mm = 2000, up = std::cos(pi / 6), across = std::sin(pi / 6);
    prism.scene.add_solid({{{0, 0, 1}, 10}, {{-1, 0, 0}, 10}, {{1, 0, 0}, 10}, {{0, -1, 0}, 10}, {{0, 1, 0}, 10},
                           {{across, 0, -up}, 0}}, {0, 0, 5}, 30, wedge);
    const auto lands_mm = [&](double index) { return far_mm * std::tan(std::asin(index / 2) - pi / 6); };
    const double left = lands_mm(n + kappa), right = lands_mm(n - kappa);
    REQUIRE(std::fabs(left - right) > 1);
    const auto seen = [&](double edge) {   // the part of the light that lands beyond the edge, along x
      Bench copy = prism;
      copy.scene.add_sheet({-edge - 2000, 0, -far_mm}, {0, 0, 1}, 2000, 500, copy.scene.add_emission(1), {});
      return copy.look(*kernels, {0, 0, -1}, {0, 0, 60});
    };
    const Light both = seen(right - 0.3), one = seen((left + right) / 2), none = seen(left + 0.3);
    CHECK(both.s0 > 0.85);
    CHECK(one.s0 == doctest::Approx(both.s0 / 2).epsilon(0.02));
    CHECK(std::fabs(one.s3) > 0.99 * one.s0);   // one circular wave alone
    CHECK(none.s0 < 0.05);
  }
}

// Order m passes the plate 2m + 1 times: amplitudes T_j R_j^m exp(i (2m + 1) k0 n_j d) of the two waves, at normal incidence.
TEST_CASE("a wave plate between polarizers at 45 degrees, all reflections included") {
  const double n[2] = {quartz[0], quartz[2]};
  for (const double thickness_mm : {0.0159, 0.032, 0.1}) {
    Bench bench;
    bench.light(unit({1, 1, 0}));
    bench.plate(bench.scene.add_crystal(quartz, frame_along({1, 0, 0}, {0, 1, 0})), thickness_mm);
    double s[4] = {0, 0, 0, 0};
    for (int m = 0; m < 40; ++m) {
      std::complex<double> amplitude[2];
      for (int j = 0; j < 2; ++j) {
        const double root = (n[j] - 1) / (n[j] + 1), phase = (2 * m + 1) * 2 * pi * (n[j] - n[0]) * thickness_mm / lambda_mm;
        // each reflection inside comes with the sign of -root, twice per order
        amplitude[j] = std::polar((1 - root * root) * std::pow(root * root, m), phase) / std::sqrt(2.0);
      }
      const std::complex<double> x = amplitude[1], y = amplitude[0];   // e along x
      s[0] += std::norm(x) + std::norm(y);
      s[1] += std::norm(x) - std::norm(y);
      s[2] += 2 * (std::conj(x) * y).real();
      s[3] += -2 * (std::conj(x) * y).imag();   // > 0 right circular
    }
    for (const Kernels* kernels : all_kernels()) {
      CAPTURE(kernels->name);
      CAPTURE(thickness_mm);
      const Light l = bench.look(*kernels);
      const double bound = kernels->epsilon > 1e-10 ? 2e-5 : 1e-9;
      CHECK(std::fabs(l.s0 - s[0]) < bound);
      CHECK(std::fabs(l.s1 - s[1]) < bound);
      CHECK(std::fabs(l.s2 - s[2]) < bound);
      CHECK(std::fabs(l.s3 - s[3]) < bound);
    }
  }
}

// An active biaxial plate turned over about x has Q J^T Q, Q = diag(1, -1): polarizer and analyzer change places. The waves'
// fields are first order in the gyration: what is left is of order g^2.
TEST_CASE("a plate turned over: light Qb through it, seen at Qa, is light a, seen at b") {
  const OpticFrame frame = frame_along({0.3, 0.5, 0.8}, {1, 0.2, 0});
  OpticFrame turned;
  for (int i = 0; i < 3; ++i) turned[i] = {frame[i].x, -frame[i].y, -frame[i].z};
  const std::array<double, 3> n{1.610, 1.613, 1.621};
  const std::vector<double> g{2e-4, 1e-4, -3e-4, 1e-4, 0, 5e-5};
  const auto seen = [&](const Kernels& kernels, const OpticFrame& axes, double light_deg, double analyzer_deg) {
    Bench bench(0.05);
    bench.light({std::cos(radians(light_deg)), std::sin(radians(light_deg)), 0});
    bench.plate(bench.scene.add_crystal(n, axes, g), 0.7);
    const Light l = bench.look(kernels);
    return (l.s0 + l.s1 * std::cos(2 * radians(analyzer_deg)) + l.s2 * std::sin(2 * radians(analyzer_deg))) / 2;
  };
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    for (const auto& [a, b] : {std::pair{0.0, 30.0}, {20.0, 110.0}, {75.0, -40.0}}) {
      const double one = seen(*kernels, frame, a, b), other = seen(*kernels, turned, -b, -a);
      CHECK(std::fabs(one - other) < (kernels->epsilon > 1e-10 ? 1e-4 : 3e-7));
    }
  }
}

TEST_CASE("a crystal that is hardly birefringent is like glass, with and without coherence") {
  for (const Kernels* kernels : all_kernels()) {
    Bench glass;
    glass.light(unit({1, 0.4, 0}));
    glass.plate(glass.scene.add_medium(1.6), 2);
    const Vec3 direction = unit({0.3, -0.2, -1});
    const Light expected = glass.look(*kernels, direction);
    double last = 1;
    for (const double change : {1e-2, 1e-4, 1e-6, 1e-8, 0.0}) {
      for (const bool biaxial : {false, true}) {
        CAPTURE(kernels->name);
        CAPTURE(change);
        CAPTURE(biaxial);
        Bench bench;
        bench.light(unit({1, 0.4, 0}));
        const std::array<double, 3> n{1.6, biaxial ? 1.6 + change / 3 : 1.6, 1.6 + change};
        const int crystal = bench.scene.add_crystal(n, frame_along({0.3, 0.5, 0.8}, {1, 0, 0}));
        bench.scene.scene.media[crystal].symmetry = biaxial ? Medium::Symmetry::biaxial : Medium::Symmetry::uniaxial;
        bench.plate(crystal, 2);
        const Light l = bench.look(*kernels, direction);
        const double off = std::hypot(l.s1 - expected.s1, l.s2 - expected.s2, l.s3 - expected.s3);
        // what the retardance changes of the state, and through T_s - T_p of the intensity
        const double retardance = 2 * pi * change * 2.2 / lambda_mm;
        CHECK(std::fabs(l.s0 - expected.s0) < change + 0.02 * std::min(1.0, retardance) + 100 * kernels->epsilon);
        CHECK(off < 2 * retardance + 300 * kernels->epsilon);
        last = off;
      }
    }
    CHECK(last < 300 * kernels->epsilon);
  }
}

// The extraordinary ray of calcite cut at 45 degrees to its axis leaves d tan(walk-off) aside, tan = (no^2 - ne^2)/(ne^2 + no^2): a
// knife edge right behind the plate. The axis leans to +x going up; the extraordinary ray of a negative crystal leans away from it.
TEST_CASE("walk-off of calcite at 45 degrees: where the two images of an edge lie") {
  const double no2 = calcite[0] * calcite[0], ne2 = calcite[2] * calcite[2];
  const double shift = 10 * (no2 - ne2) / (ne2 + no2);
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    Bench bench;
    bench.plate(bench.scene.add_crystal(calcite, frame_along({1, 0, 1}, {0, 1, 0})), 10);
    bench.scene.add_sheet({-20, 0, -1e-3}, {0, 0, 1}, 20, 40, bench.scene.add_emission(1), {});   // bright where x < 0
    const auto at = [&](double x) { return bench.look(*kernels, {0, 0, -1}, {x, 0, 60}); };
    const Light both = at(-1.001 * shift), one = at(-0.999 * shift), still_one = at(-1e-3 * shift), none = at(1e-3 * shift);
    CHECK(both.s0 > 0.85);
    CHECK(std::fabs(both.s1) < 0.1);
    for (const Light& ordinary : {one, still_one}) {
      CHECK(ordinary.s0 > 0.4);
      CHECK(ordinary.s1 < -0.95 * ordinary.s0);   // across the plane of the axis
    }
    CHECK(none.s0 < 0.05);
  }
}

// A pixel wider than the walk-off cannot tell the two images apart; one a little narrower sees a share of each.
TEST_CASE("nothing jumps between waves that are told apart and waves that are not") {
  double last = -1;
  for (double pixel_mm = 0.5; pixel_mm < 8; pixel_mm *= 1.05) {
    Bench bench(pixel_mm);
    bench.light(unit({1, 1, 0}));
    bench.plate(bench.scene.add_crystal(calcite, frame_along({1, 0, 1}, {0, 1, 0})), 10.00013);
    const Light l = bench.look(double1);
    const double analyzed = (l.s0 + l.s2) / 2;
    if (last >= 0) CHECK(std::fabs(analyzed - last) < 0.05);
    last = analyzed;
  }
}

// At a binormal of aragonite the ray of a wave is anywhere on a cone of 1.9035 degrees (1.530, 1.681, 1.6855; tan = sqrt((nb^2 - na^2)
// (nc^2 - nb^2))/(na nc)), each azimuth with a polarization of its own.
TEST_CASE("internal conical refraction: a pin-hole is seen as a ring, bright in no other place") {
  const double a = 1.530, b = 1.681, c = 1.6855, depth_mm = 20;
  const double cone = std::sqrt((b * b - a * a) * (c * c - b * b)) / (a * c);
  const double v = std::acos(a / b * std::sqrt((c * c - b * b) / (c * c - a * a)));   // from the axis of n_gamma
  for (const Kernels* kernels : all_kernels()) {
    CAPTURE(kernels->name);
    Bench bench;
    // the binormal along z, n_beta along y
    const Vec3 gamma{-std::sin(v), 0, std::cos(v)}, beta{0, 1, 0};
    const int crystal = bench.scene.add_crystal({a, b, c}, {cross(beta, gamma), beta, gamma});
    bench.scene.scene.settings.conical_rays = 64;
    bench.scene.scene.settings.conical_spread_rad = radians(0.01);
    bench.plate(crystal, depth_mm);
    bench.scene.add_disc({0, 0, -1e-3}, {0, 0, 1}, 0.02, 0, bench.scene.add_emission(1), {});
    // the ring of rays goes through the foot of the wave normal and a place d tan(cone) aside
    const auto seen = [&](double across, double along_y) {
      return bench.cone(*kernels, {across * depth_mm * cone, along_y * depth_mm * cone, 60});
    };
    const double side = seen(1, 0) > seen(-1, 0) ? 1 : -1;
    CHECK(seen(side, 0) > 1e-3);
    CHECK(seen(0, 0) > 1e-3);
    CHECK(seen(side / 2, 0.5) > 1e-3);
    CHECK(seen(side / 2, -0.5) > 1e-3);
    for (const double across : {0.5, 1.1, -0.1}) CHECK(seen(side * across, 0) < 1e-4);
    CHECK(seen(-side, 0) < 1e-4);
  }
}
