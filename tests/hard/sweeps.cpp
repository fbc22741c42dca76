// Sweeps across singular places, in random directions: nothing jumps there. In double each step is cut into eight;
// none of the eight may take more than half of a continuous change (a square root's first eighth takes 0.36). Every
// way stays near double, by what rounding its input changes in double.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/hard/bench.hpp"

namespace nicol::hard {
namespace {

using test::Dice;

struct View {
  Stage stage;
  Look look;
};

struct Sweep {
  std::string name;
  std::function<View(double t, unsigned seed)> at;
  std::vector<double> points;
  std::function<double(double t)> rounding_of_input;   // in epsilon
  double floor = 40;                                    // of every Stokes component, in epsilon
  std::string reason;
};

// 0 and 10^-digits .. 10^-first to both sides, ascending.
std::vector<double> around_zero(double largest, double smallest) {
  std::vector<double> points{0};
  for (double t = smallest; t <= largest * 1.0001; t *= 10) {
    points.push_back(t);
    points.push_back(-t);
  }
  std::sort(points.begin(), points.end());
  return points;
}

struct Reference {
  std::vector<Seen> at;         // in double, at the points
  std::vector<Seen> lower, upper;
  double largest_jump = 0;      // of an eighth of a step, beyond what continuity leaves it
};

Seen in_double(const View& view) {
  Table unused;
  return Bench({true, 1, false}, "", unused).look(view.stage, view.look)[0];
}

double apart(const Seen& a, const Seen& b) {
  double most = 0;
  for (int i = 0; i < 4; ++i) most = std::max(most, std::fabs(a.s[i] - b.s[i]));
  return most;
}

// What rounding the input changes there.
double moved(const Reference& r, std::size_t i) { return std::max(apart(r.at[i], r.lower[i]), apart(r.at[i],
    r.upper[i])); }

// What the largest eighth of a step changes beyond half of the step's change. Where the step has a bend in it, its
// largest eighth is cut again: what stays in one piece each time is a jump.
double jump_in(const Sweep& sweep, unsigned seed, double from, double to, int times) {
  std::vector<Seen> fine;
  const auto place = [&](int k) { return from + k / 8.0 * (to - from); };
  for (int k = 0; k <= 8; ++k) fine.push_back(in_double(sweep.at(place(k), seed)));
  double range = 0, jump = 0;
  int largest = 0;
  for (int k = 0; k <= 8; ++k)
    for (int l = 0; l < k; ++l) range = std::max(range, apart(fine[k], fine[l]));
  for (int k = 0; k < 8; ++k) {
    if (apart(fine[k], fine[k + 1]) <= jump) continue;
    jump = apart(fine[k], fine[k + 1]);
    largest = k;
  }
  if (jump <= 0.5 * range || times == 1) return jump - 0.5 * range;
  return jump_in(sweep, seed, place(largest), place(largest + 1), times - 1);
}

Reference reference_of(const Sweep& sweep, unsigned seed, double epsilon) {
  Reference out;
  for (const double t : sweep.points) {
    const double dt = sweep.rounding_of_input(t) * epsilon;
    out.at.push_back(in_double(sweep.at(t, seed)));
    out.lower.push_back(in_double(sweep.at(t - dt, seed)));
    out.upper.push_back(in_double(sweep.at(t + dt, seed)));
  }
  for (std::size_t i = 0; i + 1 < sweep.points.size(); ++i) {
    const double blur = moved(out, i) + moved(out, i + 1);
    out.largest_jump = std::max(out.largest_jump, jump_in(sweep, seed, sweep.points[i], sweep.points[i + 1],
        3) - 2 * blur);
  }
  return out;
}

void run(Bench& bench, const Sweep& sweep) {
  static std::map<std::pair<std::string, double>, Reference> known;
  for (unsigned seed = 0; seed < 2; ++seed) {
    const auto key = std::make_pair(sweep.name + std::to_string(seed), bench.epsilon());
    if (!known.count(key)) known[key] = reference_of(sweep, seed, bench.epsilon());
    const Reference& reference = known[key];
    if (bench.way().real_double && bench.way().lanes == 1 && !bench.way().specialised)
      bench.hold("jump of an eighth of a step", "half of the step's change, roundings of the input; 1e-13", 1e-13,
          std::max(0.0, reference.largest_jump));
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
      const View view = sweep.at(sweep.points[i], seed);
      const Seen seen = bench.look(view.stage, view.look)[0];
      const double storage = bench.way().specialised ? 0x1p-24 : 0;
      bench.hold("from double", sweep.reason, 2 * moved(reference, i) + sweep.floor * bench.epsilon(),
                 std::max(0.0, apart(seen, reference.at[i]) - storage));
    }
  }
}

OpticFrame random_frame(unsigned seed) {
  const Vec3 z = test::any_direction(3 * seed + 1), about = test::any_direction(3 * seed + 2);
  const Vec3 x = test::unit(test::plus(about, test::scaled(-test::dot(about, z), z)));
  return {x, test::cross(z, x), z};
}
OpticFrame turned(const OpticFrame& frame, const Vec3& about, double angle) {
  OpticFrame out;
  for (int i = 0; i < 3; ++i) {
    const double along = test::dot(frame[i], about);
    out[i] = test::plus(test::scaled(along * (1 - std::cos(angle)), about),
                        test::plus(test::scaled(std::cos(angle), frame[i]), test::scaled(std::sin(angle),
                            test::cross(about, frame[i]))));
  }
  return out;
}

// A plate of the medium on a light of its own polarization, across z.
TestScene plate(double thick_mm, const std::function<int(TestScene&)>& add, double azimuth = 0.4) {
  TestScene scene;
  scene.scene.settings.adc_bailout = 1e-9;
  const int polarizer = scene.add_polarizer(Polarizer::Kind::ideal, {std::cos(azimuth), std::sin(azimuth), 0}, {0, 0,
      1});
  scene.add_sheet({0, 0, -50}, {0, 0, 1}, 400, 400, scene.add_emission(2, polarizer), {});
  scene.add_box({-300, -300, 0}, {300, 300, thick_mm}, add(scene));
  return scene;
}
Look towards(const Vec3& direction, double pixel_mm) {
  return {test::plus({0, 0, 0.5}, test::scaled(-60, test::unit(direction))), direction, {1, 0.1, 0}, pixel_mm};
}

const std::array<double, 3> calcite{1.65835, 1.65835, 1.48640}, quartz{1.54425, 1.54425, 1.55336}, aragonite{1.530,
    1.681, 1.6855};

// Phases of plates: 4 eps of 2 pi (n1 - n0) d/lambda.
double plate_floor(double difference, double thick_mm) { return 60 + 4 * 2 * test::pi * difference * thick_mm
    / 580e-6; }
const char* const plate_reason = "roundings of the input, in double; 60 eps; 4 eps of the phase between the waves";

Sweep normal_incidence() {
  return {"normal incidence",
          [](double t, unsigned seed) {
            const double azimuth = 1.3 + seed;
            return View{stage_of(plate(0.05, [&](TestScene& s) { return s.add_crystal(calcite, random_frame(seed)); })),
                        towards({t * std::cos(azimuth), t * std::sin(azimuth), -1}, 10)};
          },
          around_zero(1e-2, 1e-9), [](double) { return 4; }, plate_floor(0.17, 0.05), plate_reason};
}

// From inside glass, calcite (a pixel that tells its waves apart) onto a face on a light.
Sweep critical(bool crystal) {
  return {crystal ? "critical angle of calcite" : "critical angle of glass",
          [=](double t, unsigned seed) {
            TestScene scene;
            // axis across the plane of incidence
            const OpticFrame frame{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}};
            const int medium = crystal ? scene.add_crystal(calcite, frame) : scene.add_medium(1.52);
            const int cell = scene.add_box({-50, -50, -10}, {50, 50, 10}, medium);
            scene.cover(cell, test::Side::z_high, scene.add_sheet({0, 0, 10}, {0, 0, 1}, 50, 50,
                scene.add_emission(1), {}));
            scene.geometry.camera_cell = cell;
            scene.scene.settings.max_trace_level = 1;
            // the ordinary wave's; the extraordinary one's
            const double at = std::asin(1 / (crystal ? calcite[seed == 0 ? 0 : 2] : 1.52)) + t;
            return View{stage_of(scene), {{0, 0, 9.9}, {std::sin(at), 0, std::cos(at)}, {0, 1, 0}, 1e-6}};
          },
          around_zero(1e-2, 1e-8), [](double) { return 8; }, 40, "8 eps of the angle, in double; 40 eps"};
}

Sweep optic_axis() {
  return {"optic axis",
          [](double t, unsigned seed) {
            const double g33 = test::radians(21.724) * quartz[0] * 580e-6 / test::pi;
            const std::vector<double> gyration = seed ? std::vector<double>{-0.449 * g33, -0.449 * g33, g33, 0, 0,
                0} : std::vector<double>{};
            const double azimuth = 0.7 + seed;
            return View{stage_of(plate(1, [&](TestScene& s) {
                          return s.add_crystal(quartz, OpticFrame{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                              gyration);
                        })),
                        towards({t * std::cos(azimuth), t * std::sin(azimuth), -1}, 10)};
          },
          around_zero(1e-2, 1e-8), [](double) { return 4; }, plate_floor(0.0001, 1), plate_reason};
}

Sweep binormal() {
  return {"binormal",
          [](double t, unsigned seed) {
            const double v = std::acos(aragonite[0] / aragonite[1] * std::sqrt((aragonite[2] * aragonite[2]
                - aragonite[1] * aragonite[1]) /
                                                                               (aragonite[2] * aragonite[2]
                                                                                   - aragonite[0] * aragonite[0])));
            const OpticFrame frame{Vec3{std::cos(v), 0, std::sin(v)}, Vec3{0, 1, 0}, Vec3{-std::sin(v), 0,
                std::cos(v)}};
            const Vec3 about{std::cos(0.8 + 2 * seed), std::sin(0.8 + 2 * seed), 0};
            return View{stage_of(plate(0.2, [&](TestScene& s) { return s.add_crystal(aragonite, turned(frame, about,
                t)); })),
                        towards({0, 0, -1}, 10)};
          },
          around_zero(1e-2, 1e-9), [](double) { return 2; }, plate_floor(0.155, 0.2), plate_reason};
}

Sweep shares() {
  std::vector<double> pixels;
  for (double mm = 0.4; mm < 16; mm *= 1.3) pixels.push_back(mm);
  return {"shares of coherence",
          [](double t, unsigned seed) {
            return View{stage_of(plate(5.00013 + 0.01 * seed, [&](TestScene& s) { return s.add_crystal(calcite,
                random_frame(seed + 5)); })),
                        towards({0, 0, -1}, t)};
          },
          pixels, [](double t) { return 8 * t; }, plate_floor(0.17, 5), plate_reason};
}

Sweep bins() {
  std::vector<double> widths;
  for (double nm = 0.05; nm < 60; nm *= 1.4) widths.push_back(nm);
  return {"bins of wavelengths",
          [](double t, unsigned seed) {
            TestScene scene({580, 610});
            scene.scene.weight_nm = {t, t};
            scene.scene.settings.adc_bailout = 1e-9;
            const int polarizer = scene.add_polarizer(Polarizer::Kind::ideal, {std::cos(0.4), std::sin(0.4), 0}, {0,
                0, 1});
            scene.add_sheet({0, 0, -50}, {0, 0, 1}, 400, 400, scene.add_emission(2, polarizer), {});
            scene.add_box({-300, -300, 0}, {300, 300, 0.3}, scene.add_crystal(calcite, random_frame(seed + 21)));
            return View{stage_of(scene), towards({0.1, 0.2, -1}, 20)};
          },
          widths, [](double t) { return 8 * t; }, plate_floor(0.17, 0.3), plate_reason};
}

Sweep matching() {
  return {"index matching",
          [](double t, unsigned seed) {
            TestScene scene;
            const bool crystal = seed == 1;
            const auto medium = [&](double n) {
              return crystal ? scene.add_crystal({n, n, n + 0.01}, OpticFrame{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0,
                  1, 0}}) : scene.add_medium(n);
            };
            const int one = scene.add_box({-50, -50, -10}, {50, 50, 0}, scene.add_medium(1.52));
            const int two = scene.add_box({-50, -50, 0}, {50, 50, 10}, medium(1.52 + t));
            scene.join(Patch::Behind::cell_contact, one, test::Side::z_high, two, test::Side::z_low);
            // what comes back leaves by the side
            scene.cover(one, test::Side::x_high, scene.add_disc({50, 0, -5}, {1, 0, 0}, 80, 0, scene.add_emission(1),
                {}));
            scene.geometry.camera_cell = one;
            scene.scene.settings.max_trace_level = 2;
            scene.scene.settings.adc_bailout = 0;
            return View{stage_of(scene), {{0, 0, -0.05}, {std::sin(1.55), 0, std::cos(1.55)}, {0, 1, 0}}};
          },
          around_zero(1e-3, 1e-10), [](double t) { return 8 + 8 * std::fabs(t); }, 40,
              "8 eps of the index, in double; 40 eps"};
}

Sweep birefringence() {
  return {"birefringence to 0",
          [](double t, unsigned seed) {
            const std::array<double, 3> n{1.6, seed ? 1.6 + t / 3 : 1.6, 1.6 + t};
            return View{stage_of(plate(0.5, [&](TestScene& s) {
                          const int medium = s.add_crystal(n, random_frame(seed + 9));
                          s.scene.media[medium].symmetry = seed ? Medium::Symmetry::biaxial
                              : Medium::Symmetry::uniaxial;
                          return medium;
                        })),
                        towards({0.3, -0.2, -1}, 10)};
          },
          around_zero(1e-3, 1e-11), [](double t) { return 8 + 8 * std::fabs(t); }, plate_floor(1e-3, 0.5),
              plate_reason};
}

Sweep grazing() {
  std::vector<double> angles;
  for (double t = 1e-7; t < 0.1; t *= 3) angles.push_back(t);
  return {"grazing incidence",
          [](double t, unsigned seed) {
            TestScene scene;
            const int medium = seed ? scene.add_crystal(calcite, random_frame(17)) : scene.add_medium(1.52);
            const int cell = scene.add_box({-5000, -5000, -5e-4}, {5000, 5000, 5e-4}, medium);
            scene.cover(cell, test::Side::z_low, scene.add_sheet({0, 0, -5e-4}, {0, 0, 1}, 5000, 5000,
                scene.add_emission(1), {}));
            scene.scene.settings.max_trace_level = 1;
            scene.scene.sky = {1};
            return View{stage_of(scene), {{-1000 * std::cos(t), 0, 5e-4 + 1000 * std::sin(t)}, {std::cos(t), 0,
                -std::sin(t)}, {0, 1, 0}}};
          },
          angles, [](double t) { return 4 * t; }, 40, "4 eps of the angle, in double; 40 eps"};
}

std::function<void(Bench&)> running(const Sweep& sweep) {
  return [sweep](Bench& bench) { run(bench, sweep); };
}

}  // namespace

std::vector<Case> sweep_cases() {
  std::vector<Case> cases;
  for (const Sweep& sweep : {normal_incidence(), critical(false), critical(true), optic_axis(), binormal(), shares(),
      bins(), matching(),
                             birefringence(), grazing()})
    cases.push_back({"sweeps", "across " + sweep.name, running(sweep)});
  return cases;
}

}  // namespace nicol::hard
