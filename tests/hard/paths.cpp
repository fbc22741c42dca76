// Long ways through solids: many turns of the plane of polarization, absorption to exp(-50), a thousand reflections,
// light trapped in crystals, one wavelength and 401.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/hard/bench.hpp"
#include "tests/hard/closed_forms.hpp"
#include "tests/kernels/random_rays.hpp"

namespace nicol::hard {
namespace {

constexpr double n_glass = 1.52;

// A block across z before a light polarized along x.
TestScene block_before_light(double thick_mm, const std::function<int(TestScene&)>& add,
    const std::vector<double>& wavelengths = {580}) {
  TestScene scene(wavelengths);
  scene.scene.settings.adc_bailout = 1e-18;
  const int light = scene.add_polarizer(Polarizer::Kind::ideal, {1, 0, 0}, {0, 0, 1});
  scene.add_sheet({0, 0, -50}, {0, 0, 1}, 400, 400, scene.add_emission(2, light), {});   // 1 passes
  scene.add_box({-200, -200, 0}, {200, 200, thick_mm}, add(scene));
  return scene;
}

// The plane turns by rho d on the way there, back on the way back: one angle for all orders.
void rotation(Bench& bench) {
  const double thick_mm = 16, mean = static_cast<double>(plate_between(1, n_glass, 1).mean());
  for (const double degrees : {27008.0, 1e7, -27008.17})
    for (const double thick : {thick_mm, 15.731}) {
      const TestScene scene = block_before_light(thick, [&](TestScene& s) { return s.add_medium(n_glass, 0,
          degrees / thick); });
      const Seen seen = bench.look(stage_of(scene), {{0, 0, 100}, {0, 0, -1}})[0];
      // the depth as the scalar holds it
      const double depth = bench.way().native().round(thick / 2) * 2;
      const Real turns = -Real(degrees / thick) / 360 * depth, angle = 2 * pi_real * (turns - std::rint(turns));
      const double bound = 24 * bench.epsilon() + static_cast<double>(std::fabs(turns)) * 2 * test::pi * 0x1p-48 + 4
          * 0x1p-52 * std::fabs(degrees) / 57;
      const std::string what = fmt::format("{:g} degrees", std::fabs(degrees));
      const char* why = "24 eps; turns as two floats, 2^-48 of them";
      bench.hold_seen(what + ": S1", why, bound, seen.s[1], mean * static_cast<double>(std::cos(2 * angle)), 1);
      bench.hold_seen(what + ": S2", why, bound, seen.s[2], mean * static_cast<double>(std::sin(2 * angle)), 1);
      bench.hold_seen(what + ": S0", "24 eps", 24 * bench.epsilon(), seen.s[0], mean, 1);
    }
}

// Askew the way is longer by what one rounding of the direction makes of it.
void rotation_askew(Bench& bench) {
  const double degrees = 27008, thick = 16;
  const TestScene scene = block_before_light(thick, [&](TestScene& s) { return s.add_medium(n_glass, 0,
      degrees / thick); });
  const Stage stage = stage_of(scene);
  for (const double tilt : {1e-6, 1e-3, 0.2}) {
    const Seen seen = bench.look(stage, {{-10 * tilt, 0, thick + 10}, {tilt, 0, -1}})[0];
    const Real sine = tilt / std::sqrt(1 + Real(tilt) * tilt), inside = std::sqrt(1 - sine * sine / (n_glass
        * n_glass));
    const Real angle = -Real(degrees) / 180 * pi_real / inside;
    // in the axes of the face, one sense for both ways: orders m are t R (rho R rho R)^m t with rho = diag(r_s, r_p)
    const Face out = face_between(n_glass, 1, n_glass * inside);
    const Real t_s = std::sqrt(out.T_s), t_p = std::sqrt(out.T_p), r_s = out.r_s.real(), r_p = out.r_p.real();
    const Real c = std::cos(angle), s = std::sin(angle);
    Real x = t_p, y = 0, sum[4] = {0, 0, 0, 0};   // x: along p; light along x
    for (int m = 0; m < 60; ++m) {
      const auto turn = [&] {
        const Real old = x;
        x = c * old - s * y;
        y = s * old + c * y;
      };
      turn();
      const Real seen_x = t_p * x, seen_y = t_s * y;
      sum[0] += seen_x * seen_x + seen_y * seen_y;
      sum[1] += seen_x * seen_x - seen_y * seen_y;
      sum[2] += 2 * seen_x * seen_y;
      for (int way = 0; way < 2; ++way) {   // back, and up to where the next way there begins
        x *= r_p;
        y *= r_s;
        if (way == 0) turn();
      }
    }
    const double bound = bench.epsilon() * (24 + 3 * std::fabs(static_cast<double>(angle)) * 2);
    for (int i = 0; i < 3; ++i)
      bench.hold_seen(fmt::format("S{}", i), "24 eps; 3 eps of the path's length, in the angle twice", bound, seen.s[i],
                      static_cast<double>(sum[i]), 1);
  }
}

void absorption(Bench& bench) {
  const double thick = 7;
  for (const double depth : {1e-6, 1.0, 20.0, 50.0}) {
    const double per_mm = depth / thick, k = per_mm * 580e-6 / (4 * test::pi);
    for (const bool uniaxial : {false, true}) {
      const auto add = [&](TestScene& s) {
        const OpticFrame frame{Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}};
        return uniaxial ? s.add_crystal({n_glass, n_glass, 1.6}, frame, {}, {2 * k, 2 * k, k}) : s.add_medium(n_glass,
            k);
      };
      TestScene scene = block_before_light(thick, add);
      scene.scene.settings.adc_bailout = 0;
      scene.scene.settings.max_trace_level = 8;
      const Seen seen = bench.look(stage_of(scene), {{0, 0, 100}, {0, 0, -1}, {1, 0, 0}, 1})[0];
      const std::complex<Real> index(uniaxial ? Real(1.6) : n_glass, uniaxial ? 0 : k);
      const Real R = std::norm((index - Real(1)) / (index + Real(1))), exact_k = Real(k);
      const Real passed = std::exp(-4 * pi_real * exact_k * thick / 580e-6L);
      Real sum = 0;
      // T of both faces: 1 - R, and the flux between the waves inside, 4 k^2/|n + 1|^2, of a transparent way
      const Real T = 4 * index.real() / std::norm(index + Real(1));
      for (int m = 0; m < 4; ++m) sum += T * T * passed * std::pow(R * passed, 2 * m);
      const double error = seen.s[0] / static_cast<double>(sum);
      const double bound = bench.epsilon() * (24 + 6 * depth) + 4 * k * k;
      bench.hold_seen(fmt::format("exp(-{:g}){}, relative", depth, uniaxial ? " of a crystal" : ""),
                      "24 eps; 6 eps of the exponent; k^2 at faces", bound, error, 1, 1);
    }
  }
}

// A rod of 1 x 2000 mm that light crosses a thousand times and more by total reflection, in through one end, out
// through the other to a light. Orders: back and forth between the ends.
void bounces(Bench& bench) {
  TestScene scene;
  scene.scene.settings.adc_bailout = 1e-6;
  scene.scene.settings.max_trace_level = 4096;
  const double length = 2000, half = 0.5;
  const int rod = scene.add_box({-half, -half, 0}, {half, half, length}, scene.add_medium(n_glass));
  scene.cover(rod, test::Side::z_low, scene.add_sheet({0, 0, 0}, {0, 0, 1}, 1, 1, scene.add_emission(1), {}));
  const Stage stage = stage_of(scene);
  for (const double slope : {0.4, 0.6, 0.8}) {   // inside: tan of the angle to the axis
    const double outside = std::asin(n_glass * std::sin(std::atan(slope)));
    const Look look{{0.1 - 3 * std::sin(outside), 0.2, length + 3 * std::cos(outside)}, {std::sin(outside), 0,
        -std::cos(outside)}, {0, 1, 0}};
    const Seen seen = bench.look(stage, look)[0];
    const Plate exact = plate_between(1, n_glass, std::cos(Real(outside)));
    const double walls = length * slope, expected = static_cast<double>(exact.mean());
    const std::string what = fmt::format("{:.0f} walls", walls);
    const double bound = 4 * walls * bench.epsilon();
    bench.hold_seen(what + ": S0", "4 eps a wall, within what was cut off", bound,
                    std::clamp(expected, seen.s[0], seen.s[0] + seen.cut_off), expected, 1);
    const double difference = static_cast<double>(exact.difference());
    bench.hold_seen(what + ": S1", "4 eps a wall, but for what was cut off", bound,
                    std::max(0.0, std::fabs(seen.s[1] - difference) - seen.cut_off), 0, 1);
  }
  // light that never gets out: 4096 faces
  TestScene trapped;
  trapped.scene.settings.max_trace_level = 4096;
  trapped.scene.sky = {1};
  trapped.geometry.camera_cell = trapped.add_box({-1, -1.1, -1.2}, {1, 1.1, 1.2}, trapped.add_medium(n_glass));
  const Stage closed = stage_of(trapped);
  for (const Vec3& along : {Vec3{1, 1, 1}, Vec3{1, 0.9, 1.1}, Vec3{-1, 1.05, 0.95}}) {
    const Seen seen = bench.look(closed, {{0.1, 0.2, 0.3}, along})[0];
    bench.hold_seen("4096 faces, trapped: what is left", "2 eps a face", 2 * 4096 * bench.epsilon(),
        seen.s[0] + seen.cut_off, 1, 1);
  }
}

OpticFrame tilted() {
  const Vec3 z = test::unit({0.3, 0.5, 0.8}), about{0.3, 0.8, -0.5};
  const Vec3 x = test::unit(test::plus(about, test::scaled(-test::dot(about, z), z)));
  return {x, test::cross(z, x), z};
}

// Light trapped by total reflection in crystals, as pairs of amplitudes (a wide pixel) and as single waves: every
// face keeps what it got.
void trapped_in_crystals(Bench& bench) {
  struct Kind {
    const char* name;
    std::array<double, 3> n;
    std::vector<double> gyration;
    double kappa;
  };
  const Kind kinds[] = {{"quartz, active", {1.5442, 1.5442, 1.5533}, {-4.85e-5, -4.85e-5, 1.08e-4, 0, 0, 0}, 3.5e-5},
                        {"calcite", {1.6584, 1.6584, 1.4864}, {}, 0},
                        {"aragonite", {1.530, 1.681, 1.6855}, {}, 0}};
  for (const Kind& kind : kinds)
    for (const bool coherence : {false, true}) {
      TestScene scene;
      scene.scene.sky = {1};
      scene.scene.settings.adc_bailout = 1e-4;
      scene.scene.settings.max_trace_level = 200;
      scene.geometry.camera_cell = scene.add_box({-8, -3, -5}, {8, 3, 5}, scene.add_crystal(kind.n, tilted(),
          kind.gyration));
      const Stage stage = stage_of(scene);
      for (int i = 0; i < 10; ++i) {
        const Seen seen = bench.look(stage, {{-7, 0.3, 0.1}, test::any_direction(i), test::any_direction(i + 50),
            coherence ? 20 : 1e-6})[0];
        bench.hold_seen(fmt::format("{}{}: what is left", kind.name, coherence ? ", coherent" : ""),
                        "R + T = 1: 8 eps a face, 40 faces to the cut-off", 320 * bench.epsilon(),
                            seen.s[0] + seen.cut_off, 1, 1);
      }
    }
}

// Both waves of a hardly birefringent crystal as one path, a thousand times round: what drifts with every face adds up.
void trapped_pairs(Bench& bench) {
  const Vec3 along[] = {{1, 1, 1}, {1, 0.9, 1.1}, {-1, 1.05, 0.95}};
  for (const bool active : {false, true}) {
    TestScene scene;
    scene.scene.sky = {1};
    scene.scene.settings.max_trace_level = 1000;
    scene.scene.settings.adc_bailout = 1e-2;
    const double g = 1.08e-4;
    const int medium = scene.add_crystal({n_glass, n_glass, n_glass + 1e-6}, tilted(),
                                         active ? std::vector<double>{g, g, g, 0, 0, 0} : std::vector<double>{});
    scene.geometry.camera_cell = scene.add_box({-1, -1.1, -1.2}, {1, 1.1, 1.2}, medium);
    const Stage stage = stage_of(scene);
    for (const Vec3& direction : along) {
      const Seen seen = bench.look(stage, {{0.1, 0.2, 0.3}, direction, {1, 0, 0}, 1})[0];
      bench.hold_seen(active ? "1000 faces, active: what is left" : "1000 faces: what is left", "4 eps a face",
          4000 * bench.epsilon(),
                      seen.s[0] + seen.cut_off, 1, 1);
    }
  }
}

// A wavelength alone is what it is among 401.
void wavelengths(Bench& bench) {
  std::vector<double> all;
  for (int i = 0; i <= 400; ++i) all.push_back(380 + i);
  const auto stage = [&](const std::vector<double>& lambda_nm) {
    std::vector<double> index, turn;
    TestScene scene = block_before_light(
        8, [&](TestScene& s) {
          const int medium = s.add_medium(n_glass);
          for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
            const double um2 = lambda_nm[i] * lambda_nm[i] * 1e-6;
            for (int axis = 0; axis < 3; ++axis) s.scene.media[medium].n[axis][i] = 1.5046 + 0.0042 / um2;
            s.scene.media[medium].rotation_deg_per_mm[i] = 7.19 * 540 / um2;
          }
          return medium;
        },
        lambda_nm);
    return stage_of(scene);
  };
  const Look look{{-3, -1, 30}, {0.3, 0.1, -3}};
  const auto together = bench.look(stage(all), look);
  bench.hold("wavelengths of 401", "none is lost", 0, std::fabs(static_cast<double>(together.size()) - 401));
  for (const std::size_t i : {0, 1, 7, 8, 200, 399, 400}) {
    const Seen alone = bench.look(stage({all[i]}), look)[0];
    for (int s = 0; s < 4; ++s)
      bench.hold_seen("one of 401 against itself alone", "the same arithmetic, in another lane", bench.epsilon(),
          together[i].s[s], alone.s[s], 2);
  }
  // straight down: Malus, each wavelength with its own index and rotation
  const auto straight = bench.look(stage(all), {{0, 0, 30}, {0, 0, -1}});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Real um2 = Real(all[i]) * all[i] * 1e-6L, n = 1.5046L + 0.0042L / um2,
        turn = 7.19L * 540 / um2 * 8 * pi_real / 180;
    const double mean = static_cast<double>(plate_between(1, n, 1).mean());
    const double bound = bench.epsilon() * 24 + 0x1p-48 * static_cast<double>(turn) + 0x1p-50
        * static_cast<double>(turn);
    bench.hold_seen("S1 of 401, straight", "24 eps; turns as two floats", bound, straight[i].s[1],
                    mean * static_cast<double>(std::cos(2 * turn)), 1);
    bench.hold_seen("S2 of 401, straight", "24 eps; turns as two floats", bound, straight[i].s[2],
                    -mean * static_cast<double>(std::sin(2 * turn)), 1);
  }
}

}  // namespace

std::vector<Case> path_cases() {
  return {{"paths", "27008 and 1e7 degrees", rotation},
          {"paths", "27008 degrees askew", rotation_askew},
          {"paths", "absorption to exp(-50)", absorption},
          {"paths", "1000 bounces", bounces},
          {"paths", "trapped in crystals", trapped_in_crystals},
          {"paths", "pairs trapped in crystals", trapped_pairs},
          {"paths", "one wavelength and 401", wavelengths}};
}

}  // namespace nicol::hard
