// Single faces where formulas lose their digits: grazing and normal incidence, Brewster's angle, the critical angle,
// media that match.
#include <algorithm>
#include <cmath>

#include "tests/hard/bench.hpp"
#include "tests/hard/closed_forms.hpp"

namespace nicol::hard {
namespace {

using test::Side;

// A plate of `n` in vacuum, `thick_mm` along z and 10 m wide, whose lower face stands on a light of radiance 1: what
// is seen from above is what the plate transmits.
TestScene plate_on_light(double n, double thick_mm) {
  TestScene scene;
  scene.scene.settings.adc_bailout = 1e-18;
  const double half = thick_mm / 2;
  const int cell = scene.add_box({-5000, -5000, -half}, {5000, 5000, half}, scene.add_medium(n));
  scene.cover(cell, Side::z_low, scene.add_sheet({0, 0, -half}, {0, 0, 1}, 5000, 5000, scene.add_emission(1), {}));
  return scene;
}

// From above down to the origin of a plate's upper face, `grazing` rad from it in the plane of x and z; y shows right.
Look down_on_plate(double grazing, double thick_mm, double far_mm) {
  return {{-far_mm * std::cos(grazing), 0, thick_mm / 2 + far_mm * std::sin(grazing)},
          {std::cos(grazing), 0, -std::sin(grazing)}, {0, 1, 0}};
}

// T is proportional to p1 there, and p1 keeps its relative rounding: direction, its length, its product with the
// normal. What leaves the far face does so at the critical angle, where p2^2 is a difference.
void grazing(Bench& bench) {
  const double n = 1.52, thick = 1e-3;
  TestScene first = plate_on_light(n, thick), both = first;
  first.scene.sky = {1};
  first.scene.settings.max_trace_level = 1;
  both.scene.settings.max_trace_level = 2;
  both.scene.settings.adc_bailout = first.scene.settings.adc_bailout = 0;
  const Stage entry = stage_of(first), plate = stage_of(both);
  for (double angle = 1e-7; angle < 0.2; angle *= 3.1) {
    const Look look = down_on_plate(angle, thick, 1000);
    const Face face = face_between(1, n, std::sin(Real(angle)));
    const double mean = static_cast<double>((face.T_s + face.T_p) / 2);
    const Seen in = bench.look(entry, look)[0];
    bench.hold_seen("T of the face, relative", "4 eps of p1, 8 roundings of T", 12 * bench.epsilon(),
        in.cut_off / mean, 1, 1);
    bench.hold_seen("R + T", "8 roundings", 8 * bench.epsilon(), in.s[0] + in.cut_off, 1, 2);
    const Seen through = bench.look(plate, look)[0];
    const auto hold = [&](const char* what, double value, const std::function<Real(const Face&)>& of) {
      const auto by_square = [&](Real p2_square) {
        return of(face_between(n, 1, std::sqrt(std::max(Real(0), p2_square) + Real(n) * n - 1)));
      };
      const Real square = std::sin(Real(angle)) * std::sin(Real(angle));
      const Real change = spread(by_square, square, 6 * bench.epsilon() * n * n);
      bench.hold_seen(what, "6 eps n^2 of p2^2 where it leaves; 24 eps",
          static_cast<double>(change) + 24 * bench.epsilon() * mean,
                      value, static_cast<double>(by_square(square)), mean);
    };
    hold("T^2 of a plate", through.s[0], [&](const Face& f) { return (face.T_s * f.T_s + face.T_p * f.T_p) / 2; });
    hold("T_s^2 - T_p^2", through.s[1], [&](const Face& f) { return (face.T_s * f.T_s - face.T_p * f.T_p) / 2; });
  }
}

void normal(Bench& bench) {
  const double n = 1.52;
  const Stage stage = stage_of(plate_on_light(n, 2));
  for (const double tilt : {0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
    for (const double azimuth : {0.0, 0.7, 2.1, 4.0}) {
      const Look look{{0, 0, 10}, {tilt * std::cos(azimuth), tilt * std::sin(azimuth), -1}};
      const Seen seen = bench.look(stage, look)[0];
      const Real cosine = 1 / std::sqrt(1 + Real(tilt) * tilt);
      const Plate exact = plate_between(1, n, cosine);
      const char* why = "a dozen roundings of T";
      const double bound = 12 * bench.epsilon(), across = static_cast<double>(exact.difference());
      // azimuth of s = z x d against the picture's x and y
      const Vec3 d = test::unit(look.along), x = test::unit(test::plus(look.right, test::scaled(-test::dot(look.right,
          d), d)));
      const Vec3 s{-d.y, d.x, 0};
      const double turned = std::atan2(test::dot(s, test::cross(x, d)), test::dot(s, x));
      bench.hold_seen("T of a plate", why, bound, seen.s[0], static_cast<double>(exact.mean()), 1);
      bench.hold_seen("S1", why, bound, seen.s[1], across * std::cos(2 * turned), 1);
      bench.hold_seen("S2", why, bound, seen.s[2], across * std::sin(2 * turned), 1);
    }
}

void brewster(Bench& bench) {
  for (const double n : {1.33, 1.52, 2.42, 4.0}) {
    const Stage stage = stage_of(plate_on_light(n, 2));
    const double grazing = std::atan(1 / n);
    for (const double off : {0.0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3}) {
      const Seen seen = bench.look(stage, down_on_plate(grazing + off, 2, 100))[0];
      const Plate exact = plate_between(1, n, std::sin(Real(grazing + off)));
      bench.hold_seen("T_p of a plate", "a dozen roundings of T", 12 * bench.epsilon(), seen.s[0] - seen.s[1],
                      static_cast<double>(exact.T_p), 2);
      bench.hold_seen("T_s of a plate", "a dozen roundings of T", 12 * bench.epsilon(), seen.s[0] + seen.s[1],
                      static_cast<double>(exact.T_s), 2);
    }
  }
}

// The camera in a block of glass whose upper face stands on a light; only that face counts.
void critical(Bench& bench) {
  for (const double n : {1.0001, 1.52, 2.42}) {
    TestScene scene;
    const int cell = scene.add_box({-50, -50, -10}, {50, 50, 10}, scene.add_medium(n));
    scene.cover(cell, Side::z_high, scene.add_sheet({0, 0, 10}, {0, 0, 1}, 50, 50, scene.add_emission(1), {}));
    scene.geometry.camera_cell = cell;
    scene.scene.settings.max_trace_level = 1;
    const Stage stage = stage_of(scene);
    const double angle = std::asin(1 / n);
    for (double off = 1e-8; off < 0.02; off *= 3.7)
      for (const int side : {-1, 0, 1}) {
        const double at = angle + side * off;
        if (!(at < 1.57)) continue;
        const Seen seen = bench.look(stage, {{0, 0, 9.9}, {std::sin(at), 0, std::cos(at)}, {0, 1, 0}})[0];
        const Real p1 = n * std::cos(Real(at)), square = p1 * p1;
        const double rounding = 6 * bench.epsilon();
        const auto hold = [&](const char* what, double value, const std::function<Real(const Face&)>& of) {
          const auto by_square = [&](Real x) { return of(face_between(n, 1, std::sqrt(std::max(Real(0), x)))); };
          const Real change = spread(by_square, square, rounding * n * n);
          bench.hold_seen(what, "p2^2 = p1^2 + bracket, off by 6 eps n^2, through T; 12 eps",
                          static_cast<double>(change) + 12 * bench.epsilon(), value,
                              static_cast<double>(by_square(square)), 1);
        };
        hold("T of the face", seen.s[0], [](const Face& f) { return (f.T_s + f.T_p) / 2; });
        hold("(T_s - T_p)/2", seen.s[1], [](const Face& f) { return (f.T_s - f.T_p) / 2; });
        bench.hold_seen("T + cut-off", "a dozen roundings", 12 * bench.epsilon(), seen.s[0] + seen.cut_off, 1, 1);
      }
  }
}

// The camera in glass before glass that differs by 1e-7; behind the camera a light. What comes back from the face
// between them is 1e-15 and less: relative to that.
void matching(Bench& bench) {
  const double n1 = 1.52;
  for (const double n2 : {n1 * (1 - 1e-7), n1 * (1 + 1e-7), n1 * (1 - 1e-4), n1}) {
    TestScene scene;
    const int one = scene.add_box({-50, -50, -10}, {50, 50, 0}, scene.add_medium(n1));
    const int two = scene.add_box({-50, -50, 0}, {50, 50, 10}, scene.add_medium(n2));
    scene.join(Patch::Behind::cell_contact, one, Side::z_high, two, Side::z_low);
    scene.cover(one, Side::z_low, scene.add_sheet({0, 0, -10}, {0, 0, 1}, 50, 50, scene.add_emission(1), {}));
    scene.geometry.camera_cell = one;
    scene.scene.settings.max_trace_level = 2;
    scene.scene.settings.adc_bailout = 0;
    const Stage stage = stage_of(scene);
    for (const double angle : {0.0, 1e-4, 0.3, 0.6}) {
      const Seen seen = bench.look(stage, {{0, 0, -1}, {std::sin(angle), 0, std::cos(angle)}, {0, 1, 0}})[0];
      const Real p1 = n1 * std::cos(Real(angle));
      const Face between = face_between(n1, n2, p1), out = face_between(n1, 1, p1);
      const Real s = std::norm(between.r_s) * out.T_s, p = std::norm(between.r_p) * out.T_p;
      const Real size = n2 == n1 ? 1 : s + p;
      bench.hold_seen("R_s, relative", "two dozen roundings: the bracket comes from the host", 24 * bench.epsilon(),
                      (seen.s[0] + seen.s[1]) / static_cast<double>(size), static_cast<double>(s / size), 2);
      bench.hold_seen("R_p, relative", "two dozen roundings: the bracket comes from the host", 24 * bench.epsilon(),
                      (seen.s[0] - seen.s[1]) / static_cast<double>(size), static_cast<double>(p / size), 2);
    }
  }
}

}  // namespace

std::vector<Case> face_cases() {
  return {{"faces", "grazing incidence", grazing},
          {"faces", "normal incidence", normal},
          {"faces", "Brewster's angle", brewster},
          {"faces", "critical angle", critical},
          {"faces", "index matching", matching}};
}

}  // namespace nicol::hard
