// Solids that are hard to hit right: edges, vertices, faces that touch or nearly do, slivers and needles, scenes of
// any size.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/hard/bench.hpp"
#include "tests/hard/closed_forms.hpp"
#include "tests/kernels/random_rays.hpp"

namespace nicol::hard {
namespace {

const char* const glass = " interior { index { constant 1.52 } } ";
constexpr double n_glass = 1.52;

// All lights at radiance 1.
Stage lit_stage(const std::string& text, double sky, const Vec3& camera = {0, 0, 1000}) {
  Stage stage = stage_of(text, {580}, camera);
  stage.scene.sky.assign(1, sky);
  for (Emission& emission : stage.scene.emissions) emission.radiance.assign(1, 1);
  return stage;
}

// In a world of radiance 1 nothing can be seen: what comes and what was cut off make 1, unpolarized. 8 eps a face.
void hold_furnace(Bench& bench, const std::string& what, const Seen& seen, int faces) {
  bench.hold_seen(what + ": S0 + cut-off", "R + T = 1: 8 eps a face", 8 * faces * bench.epsilon(),
      seen.s[0] + seen.cut_off, 1, 2);
  const double polarized = std::hypot(seen.s[1], seen.s[2], seen.s[3]);
  bench.hold_seen(what + ": polarization", "none but what was cut off; 8 eps a face", 8 * faces * bench.epsilon(),
                  std::max(0.0, polarized - seen.cut_off), 0, 2);
}

// A cube of -1..1 over dark and bright, met on an edge or a vertex: what is seen there is what is seen beside it.
void edges(Bench& bench) {
  Stage furnace = lit_stage("box { -1, 1" + std::string(glass) + "}", 1);
  Stage floor = lit_stage("box { -1, 1" + std::string(glass) +
                          "} polygon { 5, <-9,-3,-9>, <9,-3,-9>, <9,-3,9>, <-9,-3,9>, <-9,-3,-9> "
                          "luminous { spectrum { e } } }", 0.25);
  furnace.scene.settings.adc_bailout = floor.scene.settings.adc_bailout = 1e-5;
  const Look looks[] = {{{1, 1, 10}, {0, 0, -1}},        {{1, 0.3, 10}, {0, 0, -1}},     {{10, 10, 10}, {-1, -1, -1}},
                        {{10, 10, 0.3}, {-1, -1, 0}},    {{11, 9, 0.5}, {-1, -0.8, 0}},  {{1, -1, 7}, {0, 0, -1}},
                        {{-10, 10, 10}, {1, -1, -1}},    {{1 + 8, 1 + 4, 1 + 2}, {-4, -2, -1}}, {{5, 1, 0.3}, {-1, 0,
                            0}},
                        {{1 + 3, 5, -1 + 3}, {-0.75, -1, -0.75}}};
  for (const Look& look : looks) {
    hold_furnace(bench, "bright world", bench.look(furnace, look)[0], 40);
    const Seen seen = bench.look(floor, look)[0];
    double nearest = 1e9;
    const Vec3 d = test::unit(look.along), a = test::unit(test::cross(d, {0.3, 0.5, 0.8})), b = test::cross(d, a);
    for (int i = 0; i < 16; ++i) {
      const double turn = i * test::pi / 8 + 0.1, aside = 1e-5;
      const Vec3 from = test::plus(look.from, test::plus(test::scaled(aside * std::cos(turn), a),
          test::scaled(aside * std::sin(turn), b)));
      const Seen beside = bench.look(floor, {from, look.along})[0];
      nearest = std::min(nearest, std::fabs(beside.s[0] - seen.s[0]) - 2 * beside.cut_off);
    }
    bench.hold("S0 against beside the edge", "one of the sides: 40 faces of 8 eps, what both cut off",
        320 * bench.epsilon() + 0x1p-23, nearest);
  }
}

// `count` plates, `gap_mm` apart, over a light: T = (1 - R)/(1 + (2 N - 1) R).
Stage stack(int count, double thick_mm, double gap_mm, const std::string& contact) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double low = i * (thick_mm + gap_mm);
    text += fmt::format("box {{ <-300, {:.17g}, -300>, <300, {:.17g}, 300> {} {} }}\n", low, low + thick_mm, glass,
        contact);
  }
  text += "polygon { 5, <-900,-5,-900>, <900,-5,-900>, <900,-5,900>, <-900,-5,900>, <-900,-5,-900> "
          "luminous { spectrum { e } } }";
  return lit_stage(text, 0);
}

// Between what is seen and what was cut off lies the closed form.
void hold_between(Bench& bench, const std::string& what, const Seen& seen, Real exact, double bound) {
  const double least = seen.s[0], most = seen.s[0] + seen.cut_off, expected = static_cast<double>(exact);
  bench.hold_seen(what, "T lies within S0 and S0 + cut-off, to 12 eps a plate", bound, std::clamp(expected, least,
      most), expected, 1);
}

void hold_stack(Bench& bench, const Stage& stage, int plates, double height, const std::string& what) {
  for (const double angle : {0.0, 0.3, 0.9, 1.3}) {
    const Vec3 along{std::sin(angle), -std::cos(angle), 0};
    const Look look{test::plus({0, height, 0}, test::scaled(-10, along)), along, {0, 0, 1}};
    const Seen seen = bench.look(stage, look)[0];
    const Plate exact = plate_between(1, n_glass, std::cos(Real(angle)), plates);
    const double bound = 12 * plates * bench.epsilon();
    hold_between(bench, what + ": T", seen, exact.mean(), bound);
    const double difference = static_cast<double>(exact.difference());
    bench.hold_seen(what + ": T_s - T_p", "12 eps a plate, but for what was cut off", bound,
                    std::max(0.0, std::fabs(seen.s[1] - difference) - seen.cut_off), 0, 1);
  }
}

void touching(Bench& bench) {
  for (const int plates : {2, 3}) {
    Stage gaps = stack(plates, 1, 0, ""), one = stack(plates, 1, 0, "optical_contact on");
    gaps.scene.settings.adc_bailout = one.scene.settings.adc_bailout = 1e-7;
    hold_stack(bench, gaps, plates, plates, fmt::format("{} in contact", plates));
    hold_stack(bench, one, 1, plates, fmt::format("{} in optical contact", plates));
  }
}

void nearly_touching(Bench& bench) {
  for (const double gap_mm : {1e-9, 1e-7, 1e-5}) {
    Stage stage = stack(3, 1, gap_mm, "");
    stage.scene.settings.adc_bailout = 1e-7;
    hold_stack(bench, stage, 3, 3, fmt::format("3 plates {:g} mm apart", gap_mm));
  }
}

// A light so near behind a plate that rounding may have the ray beyond it already.
void light_nearly_touching(Bench& bench) {
  for (const double gap_mm : {1e-9, 1e-7, 1e-5})
    for (const double thick_mm : {1.0, 0.7}) {
      Stage stage =
          lit_stage(fmt::format("box {{ <-300, 0, -300>, <300, {:.17g}, 300> {} }} polygon {{ 5, "
                                "<-900,{:.17g},-900>, <900,{:.17g},-900>, <900,{:.17g},900>, <-900,{:.17g},900>, "
                                "<-900,{:.17g},-900> luminous {{ spectrum {{ e }} }} }}",
                                          thick_mm, glass, -gap_mm, -gap_mm, -gap_mm, -gap_mm, -gap_mm), 0);
      stage.scene.settings.adc_bailout = 1e-7;
      hold_stack(bench, stage, 1, thick_mm, fmt::format("light {:g} mm behind", gap_mm));
    }
}

void slivers(Bench& bench) {
  for (const double thick_mm : {1e-3, 1e-7, 1e-12}) {
    const Stage stage = stack(1, thick_mm, 0, "");
    hold_stack(bench, stage, 1, thick_mm, fmt::format("600 x {:g} mm", thick_mm));
  }
  // a wedge of 1e-6 rad
  Stage wedge = lit_stage("prism { -10, 10, 4, <-10, 0>, <10, 0>, <10, 2e-5>, <-10, 0>" + std::string(glass) + "}", 1);
  wedge.scene.settings.adc_bailout = 1e-5;
  for (int i = 0; i < 12; ++i) {
    const Vec3 to{-9.9 + 1.7 * i, 0.5, 0}, along = test::unit({0.2 * std::sin(i), 0.1 * std::cos(2 * i),
        i % 2 ? 1.0 : -1.0});
    hold_furnace(bench, "wedge of 1e-6 rad", bench.look(wedge, {test::plus(to, test::scaled(-20, along)), along})[0],
        60);
  }
}

void furnace(Bench& bench, const std::string& what, Stage stage, double ball_mm, int rays, int faces) {
  stage.scene.settings.adc_bailout = 1e-4;
  for (const test::RayCase& ray : test::random_rays(rays, ball_mm, 11))
    hold_furnace(bench, what, bench.look(stage, {ray.position, ray.direction, ray.axis})[0], faces);
}

void needles(Bench& bench) {
  const std::string box = fmt::format("box {{ <-5, -5e-5, -5e-5>, <5, 5e-5, 5e-5> {} }}", glass);
  furnace(bench, "1e-4 x 10 mm, from its side", lit_stage(box, 1), 3e-5, 24, 60);
  const std::string crystal = "prism { -5, 5, 4, <-5e-5, -3e-5>, <5e-5, -3e-5>, <0, 6e-5>, <-5e-5, -3e-5>"
      + std::string(glass) + "}";
  furnace(bench, "three edges", lit_stage(crystal, 1), 2e-5, 24, 60);
  Stage end = lit_stage(box, 1);
  end.scene.settings.adc_bailout = 1e-4;
  for (const double tilt : {0.0, 1e-6, 1e-5, 1e-4, 1e-3})
    hold_furnace(bench, "1e-4 x 10 mm, into its end", bench.look(end, {{6, 0, 1e-5}, {-1, tilt, tilt / 3}})[0], 300);
}

void many_faces(Bench& bench) {
  std::string points;
  const int sides = 254;
  for (int i = 0; i <= sides; ++i)
    points += fmt::format(", <{:.17g}, {:.17g}>", 2 * std::cos(2 * test::pi * (i % sides) / sides),
        2 * std::sin(2 * test::pi * (i % sides) / sides));
  furnace(bench, "prism of 256 faces", lit_stage(fmt::format("prism {{ -1, 1, {} {} {} }}", sides + 1, points, glass),
      1), 1.5, 48, 200);
}

// The same scene, large and small: light does not know how large it is.
void sizes(Bench& bench) {
  const auto scene = [](double size) {
    const auto v = [&](double x, double y, double z) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", size * x,
        size * y, size * z); };
    return fmt::format("box {{ {}, {} {} }} box {{ {}, {} {} }} "
                       "polygon {{ 5, {}, {}, {}, {}, {} luminous {{ spectrum {{ e }} }} }}",
                       v(-1, 0, -1), v(1, 2, 1), glass, v(1, 0.25, -0.5), v(2, 1.5, 0.5), glass, v(-4, 0, -4), v(4, 0,
                           -4), v(4, 0, 4),
                       v(-4, 0, 4), v(-4, 0, -4));
  };
  const Look from{{5, 6, 8}, {-4.7, -5.3, -8.1}, {1, 0, 0}, 0.21};
  static std::vector<Seen> expected;
  const int width = 8, height = 4;
  Way exact = bench.way();
  exact.real_double = true;
  exact.specialised = false;
  for (const double size : {1.0, 1e-6, 1e6}) {
    Stage stage = lit_stage(scene(size), 0.1);
    stage.scene.settings.adc_bailout = 1e-3;
    const Look look{test::scaled(size, from.from), from.along, from.right, size * from.pixel_mm};
    if (expected.empty()) {
      Table unused;
      expected = Bench(exact, "", unused).look(stage, look, width, height);
    }
    const auto seen = bench.look(stage, look, width, height);
    for (std::size_t i = 0; i < seen.size(); ++i)
      bench.hold_seen(fmt::format("{:g} mm against 1 mm, S0", size), "100 faces of 8 eps, but for what both cut off",
                      800 * bench.epsilon(),
                      std::max(0.0, std::fabs(seen[i].s[0] - expected[i].s[0]) - expected[i].cut_off
                          - seen[i].cut_off), 0, 1);
  }
}

// The camera in the plane of a face: the face is neither seen nor does it stand in the way.
void in_plane(Bench& bench) {
  Stage stage = lit_stage("box { <-1, 0, -1>, <1, 2, 1>" + std::string(glass) + "}", 1, {20, 2, 0.3});
  stage.scene.settings.adc_bailout = 1e-5;
  for (const double y : {2.0, 0.0})
    for (const double up : {0.0, 1e-8, -1e-8, 1e-7, -1e-7, 1e-4, -1e-4})
      for (const double aside : {0.0, 0.013})
        hold_furnace(bench, "bright world", bench.look(stage, {{20, y, 0.3}, {-1, up, aside}, {0, 0, 1}})[0], 60);
}

// A polarizer whose axis lies along the ray passes what it passes beside that: half of unpolarized light, in some
// state.
void axis_along(Bench& bench) {
  for (const auto kind : {Polarizer::Kind::ideal, Polarizer::Kind::ideal_absorbing})
    for (const double tilt : {1e-9, 1e-7, 1e-5, 1e-3}) {
      TestScene scene;
      scene.add_box({-1, 19, -1}, {1, 21, 1}, scene.add_medium(n_glass));
      // seen along its plane, all but; its axis in the line of sight
      scene.add_sheet({0, 0, 0}, {0, 0, 1}, 10, 10, {}, scene.add_polarizer(kind, {1, 0, 0}, {0, 0, 1}));
      scene.scene.sky = {1};
      const Seen seen = bench.look(stage_of(scene), {{9, 0, 4 * tilt}, {-1, 0, -tilt}, {0, 1, 0}})[0];
      bench.hold_seen("S0 of an unpolarized sky", "half of it is passed: 12 eps", 12 * bench.epsilon(), seen.s[0],
          0.5, 1);
      bench.hold_seen("its polarization", "complete: 12 eps", 12 * bench.epsilon(), std::hypot(seen.s[1], seen.s[2],
          seen.s[3]), 0.5, 1);
    }
  // the light's own polarizer, and the analyzer of the camera, exactly along the ray
  for (const auto kind : {Polarizer::Kind::ideal, Polarizer::Kind::ideal_absorbing}) {
    TestScene scene;
    scene.add_box({-1, 19, -1}, {1, 21, 1}, scene.add_medium(n_glass));
    scene.add_sheet({0, 0, -5}, {0, 0, 1}, 10, 10, scene.add_emission(1, scene.add_polarizer(kind, {0, 0, 1}, {1, 0,
        0})), {});
    const Seen seen = bench.look(stage_of(scene), {{0.5, 0.3, 5}, {0, 0, -1}})[0];
    bench.hold_seen("S0 of a light", "half of it is passed: 12 eps", 12 * bench.epsilon(), seen.s[0], 0.5, 1);
  }
}

void lights_all_round(Bench& bench) {
  TestScene scene;
  scene.scene.settings.adc_bailout = 1e-6;
  scene.scene.settings.max_trace_level = 100;   // light that total reflection traps stays inside
  const int cell = scene.add_box({-1, -2, -3}, {1, 2, 3}, scene.add_medium(n_glass));
  const int light = scene.add_emission(1);
  const Vec3 normals[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (int side = 0; side < 6; ++side) {
    const Vec3 n = normals[side];
    // a disc larger than the face
    scene.cover(cell, side, scene.add_disc({n.x, 2 * n.y, 3 * n.z}, n, 9, 0, light, {}));
  }
  scene.geometry.camera_cell = cell;
  const Stage stage = stage_of(scene);
  for (int i = 0; i < 24; ++i)
    hold_furnace(bench, "from inside", bench.look(stage, {{0.3, -0.4, 0.7}, test::any_direction(i),
        test::any_direction(i + 99)})[0], 100);
}

// Solids in solids in solids, every second one of another glass: N shells let (1 - R)/(1 + (2 N - 1) R) through.
void nested(Bench& bench) {
  const int shells = 4;
  TestScene scene;
  int parent = 0;
  const int medium = scene.add_medium(n_glass), air = scene.add_medium(1);
  for (int i = 0; i < shells; ++i) {
    const double half = shells - i;
    parent = scene.add_box({-half, -half, -half}, {half, half, half}, i % 2 ? air : medium, parent);
  }
  scene.scene.settings.adc_bailout = 1e-7;
  scene.add_sheet({0, 0, -20}, {0, 0, 1}, 50, 50, scene.add_emission(1), {});
  const Stage stage = stage_of(scene);
  // straight through: as many plates as shells of glass, front and back
  const Seen seen = bench.look(stage, {{0.1, 0.2, 20}, {0, 0, -1}})[0];
  const Plate exact = plate_between(1, n_glass, 1, shells);
  hold_between(bench, "T through 4 boxes in one another", seen, exact.mean(), 12 * shells * bench.epsilon());
  TestScene bright = scene;
  bright.scene.sky = {1};
  furnace(bench, "bright world", stage_of(bright), 4, 16, 200);
}

}  // namespace

std::vector<Case> solid_cases() {
  return {{"solids", "edges and vertices", edges},
          {"solids", "faces that touch", touching},
          {"solids", "faces 1e-9 mm apart", nearly_touching},
          {"solids", "light 1e-9 mm away", light_nearly_touching},
          {"solids", "slivers", slivers},
          {"solids", "needles", needles},
          {"solids", "256 faces", many_faces},
          {"solids", "1e-6 mm and 1e6 mm", sizes},
          {"solids", "camera in a face's plane", in_plane},
          {"solids", "polarizer's axis in the ray", axis_along},
          {"solids", "light on every side", lights_all_round},
          {"solids", "solids in solids", nested}};
}

}  // namespace nicol::hard
