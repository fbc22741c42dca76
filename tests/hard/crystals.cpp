// Crystals where their waves come together or lie far apart: birefringence 1e-7 and 0.7, the optic axis, the
// binormal, indices that cross while the crystal is active; and the 60-digit solutions of faces in all these places.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/hard/bench.hpp"
#include "tests/hard/closed_forms.hpp"
#include "tests/kernels/oracle_cases.hpp"
#include "tests/kernels/random_rays.hpp"

namespace nicol::hard {
namespace {

constexpr double lambda_nm = 580, lambda_mm = lambda_nm * 1e-6;

OpticFrame frame_along(const Vec3& c, const Vec3& about) {
  const Vec3 z = test::unit(c), x = test::unit(test::plus(about, test::scaled(-test::dot(about, z), z)));
  return {x, test::cross(z, x), z};
}

// A plate across z of the medium that `add` makes, its lower face towards a light polarized at `azimuth`.
TestScene plate_before_light(double thick_mm, double azimuth, const std::function<int(TestScene&)>& add,
                             const std::vector<double>& wavelengths = {lambda_nm}) {
  TestScene scene(wavelengths);
  scene.scene.weight_nm.assign(wavelengths.size(), 1e-9);   // lines: no bin washes fringes out
  scene.scene.settings.adc_bailout = 1e-18;
  const int light = scene.add_polarizer(Polarizer::Kind::ideal, {std::cos(azimuth), std::sin(azimuth), 0}, {0, 0, 1});
  scene.add_sheet({0, 0, -50}, {0, 0, 1}, 400, 400, scene.add_emission(2, light), {});   // 1 passes
  scene.add_box({-300, -300, 0}, {300, 300, thick_mm}, add(scene));
  return scene;
}

// A pixel wider than any walk-off: what a plate does to the state is not told apart by place.
const Look straight_down{{0, 0, 100}, {0, 0, -1}, {1, 0, 0}, 10};

void hold_stokes(Bench& bench, const std::string& what, const std::string& reason, double bound, const Seen& seen,
                 const Stokes& exact) {
  double off = 0;
  for (int i = 0; i < 4; ++i) {
    const double storage = bench.way().specialised ? 0x1p-24 : 0;
    off = std::max(off, std::fabs(seen.s[i] - static_cast<double>(exact[i])) - storage);
    if (std::isnan(seen.s[i])) off = NAN;
  }
  bench.hold(what, reason, bound, off);
}

// 24 roundings of amplitudes, 4 of the phase between the waves.
double state_bound(double epsilon, double phase) { return epsilon * (24 + 4 * std::fabs(phase)); }
const char* const state_reason = "24 eps of the amplitudes, 4 eps of the phase 2 pi (n1 - n0) d/lambda";

void plate_of(Bench& bench, const std::array<double, 3>& n, double thick_mm) {
  const TestScene scene = plate_before_light(
      thick_mm, 0.6, [&](TestScene& s) { return s.add_crystal(n, frame_along({1, 0, 0}, {0, 1, 0})); });
  const Real thick = Real(thick_mm) / lambda_mm;
  // wave 1, extraordinary, along x
  const Stokes exact = wave_plate({Real(n[0]), Real(n[2])}, pi_real / 2, thick, 0.6);
  const double phase = 2 * test::pi * (n[2] - n[0]) * static_cast<double>(thick);
  hold_stokes(bench, "Stokes vector of a plate", state_reason, state_bound(bench.epsilon(), phase),
              bench.look(stage_of(scene), straight_down)[0], exact);
}

void weak(Bench& bench) {
  for (const double thick_mm : {0.1, 5.0}) plate_of(bench, {1.6, 1.6, 1.6 + 1e-7}, thick_mm);
}

// Calomel, Hg2Cl2: 1.97325, 2.6559 at 589.3 nm (Palache, Berman & Frondel, Dana's System II, 1951).
void strong(Bench& bench) {
  for (const double thick_mm : {0.01, 0.5}) plate_of(bench, {1.97325, 1.97325, 2.6559}, thick_mm);
}

constexpr double from_axis[] = {0, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};

void optic_axis(Bench& bench) {
  const double n_o = 1.65835, n_e = 1.48640, thick_mm = 1;
  for (const double angle : from_axis)
    for (const double azimuth : {0.0, 1.1}) {
      const Vec3 aside{std::cos(azimuth), std::sin(azimuth), 0};
      const Vec3 axis = test::plus(test::scaled(std::sin(angle), aside), {0, 0, std::cos(angle)});
      const TestScene scene = plate_before_light(
          thick_mm, 0.3, [&](TestScene& t) { return t.add_crystal({n_o, n_o, n_e}, frame_along(axis, {0, 1, 0})); });
      const Real sine = std::sin(Real(angle)), inverse = 1 / (Real(n_o) * n_o) + (1 / (Real(n_e) * n_e) - 1
          / (Real(n_o) * n_o)) * sine * sine;
      const Real n = 1 / std::sqrt(inverse), thick = Real(thick_mm) / lambda_mm;
      const Stokes exact = wave_plate({Real(n_o), n}, azimuth + pi_real / 2, thick, 0.3);
      const double phase = 2 * test::pi * static_cast<double>((n - n_o) * thick);
      hold_stokes(bench, "Stokes vector of a plate", state_reason, state_bound(bench.epsilon(), phase),
                  bench.look(stage_of(scene), straight_down)[0], exact);
    }
}

// The sheets of the impermeability's section across z: eigenvalues and axes, without differences of like numbers.
struct Section {
  Real n[2], azimuth;   // of wave 0, the fast one
};
Section section_across_z(const std::array<Real, 3>& eta, const OpticFrame& frame) {
  Real xx = 0, xy = 0, yy = 0;
  for (int i = 0; i < 3; ++i) {
    xx += eta[i] * frame[i].x * frame[i].x;
    xy += eta[i] * frame[i].x * frame[i].y;
    yy += eta[i] * frame[i].y * frame[i].y;
  }
  const Real mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
  return {{1 / std::sqrt(mean + radius), 1 / std::sqrt(mean - radius)}, std::atan2(2 * xy, xx - yy) / 2};
}

void binormal(Bench& bench) {
  const std::array<double, 3> n{1.530, 1.681, 1.6855};
  const double thick_mm = 1;
  const Real v = std::acos(n[0] / Real(n[1]) * std::sqrt((Real(n[2]) * n[2] - Real(n[1]) * n[1]) / (Real(n[2]) * n[2]
      - Real(n[0]) * n[0])));
  for (const double angle : from_axis)
    for (const double azimuth : {0.0, 0.9, 2.0}) {
      // the binormal along z, gamma in the plane of x and z; then all of it leant over by `angle` towards `azimuth`
      const double s = static_cast<double>(std::sin(v)), c = static_cast<double>(std::cos(v));
      const Vec3 lean{std::cos(azimuth), std::sin(azimuth), 0}, turn{-lean.y, lean.x, 0};
      const auto leant = [&](const Vec3& p) {
        const double a = test::dot(p, lean), z = p.z, cosine = std::cos(angle), sine = std::sin(angle);
        return test::plus(test::scaled(test::dot(p, turn), turn),
                          test::plus(test::scaled(a * cosine + z * sine, lean), {0, 0, z * cosine - a * sine}));
      };
      const OpticFrame frame{leant({c, 0, s}), leant({0, 1, 0}), leant({-s, 0, c})};
      const TestScene scene = plate_before_light(thick_mm, 0.3, [&](TestScene& t) { return t.add_crystal(n, frame); });
      std::array<Real, 3> eta;
      for (int i = 0; i < 3; ++i) eta[i] = 1 / (Real(n[i]) * n[i]);
      const Section waves = section_across_z(eta, frame);
      const Real thick = Real(thick_mm) / lambda_mm;
      const Stokes exact = wave_plate({waves.n[0], waves.n[1]}, waves.azimuth, thick, 0.3);
      const double phase = 2 * test::pi * static_cast<double>(thick) * (n[2] - n[0]);
      hold_stokes(bench, "Stokes vector of a plate",
          "24 eps; 4 eps of the phase of the birefringence; the frame itself is rounded in double",
                  state_bound(bench.epsilon(), phase) + 0x1p-52 * 2 * test::pi * n[1] * static_cast<double>(thick),
                      bench.look(stage_of(scene), straight_down)[0], exact);
    }
}

// Indices that cross at one wavelength while the crystal turns light: there it is all turned, as by an isotropic
// medium. All wavelengths at once: the lanes hold both sides of the crossing.
void crossing(Bench& bench) {
  std::vector<double> wavelengths;
  std::vector<Real> difference;
  for (double d = 1e-4; d > 1e-9; d /= 4) difference.push_back(d);
  difference.push_back(0);
  for (std::size_t i = difference.size() - 1; i-- > 0;) difference.push_back(-difference[i]);
  for (std::size_t i = 0; i < difference.size(); ++i) wavelengths.push_back(500 + 0.1 * static_cast<double>(i));
  const double n = 2.6, kappa = 7.2e-4, thick_mm = 0.3, light = 0.4;   // silver thiogallate: 522 deg/mm at 497.4 nm
  // crystal's z along x, its x along z; light along x of the crystal
  const OpticFrame frame{Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}};
  const double g = 2 * n * kappa;
  Samples n_e;
  for (const Real d : difference) n_e.push_back(n + static_cast<double>(d));
  const auto add = [&](TestScene& s) {
    const int medium = s.add_crystal({n, n, n + 1}, frame, {g, 0, 0, 0, 0, 0});
    s.scene.media[medium].n[2] = n_e;
    return medium;
  };
  const TestScene scene = plate_before_light(thick_mm, light, add, wavelengths);
  const auto seen = bench.look(stage_of(scene), straight_down);
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    const Real mm = Real(wavelengths[i]) * 1e-6L;
    const Real change = Real(n_e[i]) - n;
    // y against x: the ordinary wave lies along y
    const Real retardance = -2 * pi_real * change * thick_mm / mm, turn = pi_real * g / (n * mm) * thick_mm;
    const Stokes exact = turning_plate(n, retardance, turn, light);
    const double phase = static_cast<double>(std::hypot(retardance, 2 * turn));
    const double bound = state_bound(bench.epsilon(), phase) + static_cast<double>(std::fabs(change)) + 4 * kappa
        * kappa * (1 + phase);
    hold_stokes(bench, "Stokes vector of a plate",
        "24 eps; 4 eps of the phase; one R for both waves: n1 - n0; first order in zeta: 4 kappa^2 (1 + phase)",
                bound, seen[i], exact);
  }
}

// Quartz: along the axis activity alone, a degree beside it hardly any.
void active_axis(Bench& bench) {
  const double n_o = 1.54425, n_e = 1.55336, thick_mm = 3, rho = test::radians(21.724), light = 0.4;
  for (const double angle : {0.0, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const double g33 = rho * n_o * lambda_mm / test::pi, g11 = -0.449 * g33;
    const OpticFrame frame = frame_along({std::sin(angle), 0, std::cos(angle)}, {0, 1, 0});
    const TestScene scene = plate_before_light(
        thick_mm, light, [&](TestScene& s) { return s.add_crystal({n_o, n_o, n_e}, frame, {g11, g11, g33, 0, 0, 0}); });
    const Real sine = std::sin(Real(angle)), square = sine * sine;
    const Real n = 1 / std::sqrt(1 / (Real(n_o) * n_o) + (1 / (Real(n_e) * n_e) - 1 / (Real(n_o) * n_o)) * square);
    const Real retardance = -2 * pi_real * (n - n_o) * thick_mm / lambda_mm;   // the extraordinary wave lies along x
    const Real turn = pi_real * (g33 + (g11 - g33) * square) / (n_o * Real(lambda_mm)) * thick_mm;
    const Stokes exact = turning_plate(n_o, retardance, turn, light);
    const double phase = static_cast<double>(std::hypot(retardance, 2 * turn)),
        kappa = rho * lambda_mm / (2 * test::pi);
    const double bound = state_bound(bench.epsilon(), phase) + static_cast<double>(n - n_o) + 4 * kappa * kappa * (1
        + phase) +
                         2 * (n_e * n_e / (n_o * n_o) - 1) * 1.449 * static_cast<double>(square * turn);
    hold_stokes(bench, "Stokes vector of a plate",
                "24 eps; 4 eps of the phase; closed form: one R for both waves, gyration of E for D; first order "
                "in zeta: 4 kappa^2 (1 + phase)", bound,
                bench.look(stage_of(scene), straight_down)[0], exact);
  }
}

// A camera in calcite before a face across its view that stands on a light: each wave passes by its own index.
void camera_inside(Bench& bench) {
  const std::array<double, 3> n{1.65835, 1.65835, 1.48640};
  TestScene scene;
  const int cell = scene.add_box({-50, -50, -10}, {50, 50, 10}, scene.add_crystal(n, frame_along({1, 0, 0}, {0, 1,
      0})));
  scene.cover(cell, test::Side::z_low, scene.add_sheet({0, 0, -10}, {0, 0, 1}, 50, 50, scene.add_emission(1), {}));
  scene.geometry.camera_cell = cell;
  scene.scene.settings.max_trace_level = 1;
  for (const double pixel_mm : {1e-6, 10.0}) {
    const Seen seen = bench.look(stage_of(scene), {{0, 0, 3}, {0, 0, -1}, {1, 0, 0}, pixel_mm})[0];
    const Real o = 4 * Real(n[0]) / ((1 + Real(n[0])) * (1 + Real(n[0]))),
        e = 4 * Real(n[2]) / ((1 + Real(n[2])) * (1 + Real(n[2])));
    const char* why = "24 eps";
    bench.hold_seen("T of both waves", why, 24 * bench.epsilon(), seen.s[0], static_cast<double>((o + e) / 2), 1);
    bench.hold_seen("T_e - T_o", why, 24 * bench.epsilon(), seen.s[1], static_cast<double>((e - o) / 2), 1);
  }
}

// Two individuals of one crystal in contact: all that the face between them takes from one wave it gives to the others.
void twins(Bench& bench) {
  const std::array<double, 3> kinds[] = {{1.65835, 1.65835, 1.48640}, {1.530, 1.681, 1.6855}};
  for (const std::array<double, 3>& n : kinds)
    for (const double pixel_mm : {1e-6, 20.0}) {
      TestScene scene;
      scene.scene.sky = {1};
      scene.scene.settings.adc_bailout = 1e-3;
      const int a = scene.add_box({-8, -8, -8}, {0, 8, 8}, scene.add_crystal(n, frame_along({0.3, 0.5, 0.8}, {1, 0,
          0})));
      const int b = scene.add_box({0, -8, -8}, {8, 8, 8}, scene.add_crystal(n, frame_along({-0.3, 0.5, 0.8}, {-1, 0,
          0})));
      scene.join(Patch::Behind::cell_contact, a, test::Side::x_high, b, test::Side::x_low);
      const Stage stage = stage_of(scene);
      for (const test::RayCase& ray : test::random_rays(16, 9, 3)) {
        const Seen seen = bench.look(stage, {ray.position, ray.direction, ray.axis, pixel_mm})[0];
        bench.hold_seen("bright world: S0 + cut-off", "R + T = 1: 8 eps a face, 40 faces", 320 * bench.epsilon(),
            seen.s[0] + seen.cut_off, 1, 2);
        bench.hold_seen("bright world: polarization", "none but what was cut off; 8 eps a face", 320 * bench.epsilon(),
                        std::max(0.0, std::hypot(seen.s[1], seen.s[2], seen.s[3]) - seen.cut_off), 0, 2);
      }
      // straight onto the face between them: nothing of either wave is lost
      scene.geometry.camera_cell = a;
      const Seen seen = bench.look(stage_of(scene), {{-4, 0.3, 0.2}, {1, 0, 0}, {0, 1, 0}, pixel_mm})[0];
      bench.hold_seen("from inside: S0 + cut-off", "R + T = 1: 8 eps a face, 40 faces", 320 * bench.epsilon(),
          seen.s[0] + seen.cut_off, 1, 2);
    }
}

// Faces of all classes in the places where digits are lost, against solutions to 60 digits. The share of what is
// allowed: 5e-6 (1e-12 in double) + 20 eps times the condition of the problem, active crystals first order in zeta.
void solutions(Bench& bench) {
  if (bench.way().lanes != 1 || bench.way().specialised) return;   // the probe has one lane
  static const nlohmann::json all = test::read_json("vectors.json"), hard = test::read_json("faces_hard.json");
  const test::Precision precision = bench.way().real_double ? test::in_double : test::in_float;
  for (const nlohmann::json* file : {&all, &hard})
    for (const nlohmann::json& one : (*file)["interface"]) {
      const std::string tag = one.value("tag", "absorbing, hard");
      if (tag.rfind("generic", 0) == 0) continue;
      bench.hold(tag, "of 5e-6 (1e-12) + 20 eps x condition, 60 digits", 1, test::judge_face(one,
          bench.way().native(), precision).worst());
    }
}

}  // namespace

std::vector<Case> crystal_cases() {
  return {{"crystals", "birefringence 1e-7", weak},
          {"crystals", "birefringence 0.68", strong},
          {"crystals", "optic axis", optic_axis},
          {"crystals", "binormal", binormal},
          {"crystals", "gyrotropic crossing", crossing},
          {"crystals", "optic axis of quartz", active_axis},
          {"crystals", "camera inside a crystal", camera_inside},
          {"crystals", "twins", twins},
          {"crystals", "faces to 60 digits", solutions}};
}

}  // namespace nicol::hard
