// Angles between twinned individuals against published ones, and planes in common.
#include <doctest/doctest.h>

#include <algorithm>

#include "host/crystallography/bounded.hpp"
#include "host/crystallography/habit.hpp"
#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

const TwinLaw& law(const std::string& wanted) {
  for (const NamedTwinLaw& row : twin_laws())
    if (wanted == row.name) return row.law;
  FAIL(wanted);
  return twin_laws()[0].law;
}

Lattice lattice(const Cell& cell) {
  std::string why;
  return *make_lattice(cell, false, why);
}

Vec3 image(const TwinOperation& op, Vec3 v) {
  return op.rotation[0] * v.x + op.rotation[1] * v.y + op.rotation[2] * v.z;
}

Habit habit(const Cell& cell, const char* group, std::vector<std::pair<Miller, double>> forms) {
  Habit made;
  made.lattice = lattice(cell);
  for (const auto& [face, distance] : forms)
    for (const Miller m : form(*find_point_group(group), face)) made.faces.push_back({m, distance});
  return made;
}

const Cell quartz{1, 1, 1.09997, 90, 90, 120}, cubic;

Habit quartz_habit() {
  return habit(quartz, "32", {{{1, 0, 0}, 0.5}, {{1, 0, 1}, 1}, {{0, 1, 1}, 1.1}});
}

bool has(const std::vector<HalfSpace>& faces, HalfSpace wanted) {
  return std::any_of(faces.begin(), faces.end(), [&](const HalfSpace& f) {
    return length(f.normal - wanted.normal) == 0 && f.offset == wanted.offset;
  });
}

}  // namespace

// C. Frondel, Dana's System of Mineralogy III (1962): 84 deg 33'.
TEST_CASE("Japan law: the axes c of quartz cross at 84.55 degrees, hands are equal") {
  const TwinOperation op = twin_operation(lattice(quartz), law("japan"));
  const double cosine = std::abs(image(op, {0, 0, 1}).z);
  CHECK(std::acos(cosine) * degrees == doctest::Approx(84 + 33 / 60.0).epsilon(2e-4));
  CHECK_FALSE(op.mirrors);
}

TEST_CASE("Dauphine turns r onto z; Brazil mirrors and keeps both") {
  const Lattice l = lattice(quartz);
  const Vec3 r = normalize(l.normal({1, 0, 1}));
  const auto group = find_point_group("32");
  const auto falls_on = [&](Vec3 v, Miller seed) {
    for (const Miller m : form(*group, seed))
      if (length(normalize(l.normal(m)) - v) < 1e-12) return true;
    return false;
  };
  CHECK(falls_on(image(twin_operation(l, law("dauphine")), r), {0, 1, 1}));
  const TwinOperation brazil = twin_operation(l, law("brazil"));
  CHECK(brazil.mirrors);
  CHECK(falls_on(-image(brazil, r), {1, 0, 1}));
  CHECK(falls_on(-image(brazil, normalize(l.normal({5, 1, 1}))), {-5, -1, -1}));  // right to left
}

// W. A. Deer et al.: c axes of manebach and baveno twins of orthoclase (Dana 1892: 001 ^ 021 44 deg 56.5').
TEST_CASE("Baveno: individuals of orthoclase are nearly at right angles") {
  const Lattice l = lattice({0.6585, 1, 0.5554, 90, 116 + 3 / 60.0, 90});
  const Vec3 c = normalize(l.normal({0, 0, 1}));
  const TwinOperation op = twin_operation(l, law("baveno"));
  const double angle_deg = std::acos(std::abs(dot(c, image(op, c)))) * degrees;
  CHECK(angle_deg == doctest::Approx(2 * (44 + 56.5 / 60)).epsilon(5e-4));
}

TEST_CASE("individuals share their contact plane to the last bit, with opposite sides") {
  for (const char* name : {"japan", "dauphine", "brazil"}) {
    CAPTURE(name);
    Habit h = quartz_habit();
    h.size = 7.3;
    h.twin = Composition{law(name), 0.1, 2, 0};
    const auto parts = individuals(h);
    REQUIRE(parts.size() == 2);
    int common = 0;
    for (const HalfSpace& f : parts[0].faces)
      common += has(parts[1].faces, {-f.normal, -f.offset});
    CHECK(common == 1);
    CHECK(parts[1].opposite_hand ==
          (law(name).operation == TwinLaw::Operation::reflection));
    for (const Individual& part : parts) CHECK_FALSE(open_direction(part.faces));
  }
}

TEST_CASE("the spinel twin of an octahedron has whole normals, turned about [111]") {
  Habit h = habit(cubic, "m-3m", {{{1, 1, 1}, 1}});
  h.twin = Composition{law("spinel"), 0, 2, 0};
  const auto parts = individuals(h);
  for (const HalfSpace& f : parts[1].faces) {
    CHECK(f.normal.x == std::round(f.normal.x));
    CHECK(f.normal.y == std::round(f.normal.y));
    CHECK(f.normal.z == std::round(f.normal.z));
  }
  // A face of the twin: (-1 1 1) mirrored in (111) is (-5 1 1) / 3.
  CHECK(std::any_of(parts[1].faces.begin(), parts[1].faces.end(), [](const HalfSpace& f) {
    return length(f.normal - Vec3{-5, 1, 1}) == 0;
  }));
}

TEST_CASE("lamellae: every other slab is turned, neighbours share planes") {
  Habit h = habit({0.63347, 1, 0.5577, 94.05, 116.4833, 88.15}, "-1",
                  {{{0, 1, 0}, 1}, {{0, 0, 1}, 1}, {{1, 1, 0}, 1}, {{1, -1, 0}, 1}});
  h.twin = Composition{law("albite"), 0, 5, 0.2};
  const auto parts = individuals(h);
  REQUIRE(parts.size() == 5);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    CHECK(parts[i].opposite_hand == (i % 2 == 1));
    int common = 0;
    for (const HalfSpace& f : parts[i].faces) common += has(parts[i + 1].faces, {-f.normal, -f.offset});
    CHECK(common >= 1);
  }
}

TEST_CASE("equivalent faces stand at bit-equal offsets, opposite ones are exactly opposite") {
  Habit h = quartz_habit();
  h.size = 3.7;
  const auto faces = individuals(h)[0].faces;
  CHECK(faces.size() == 18);
  for (int i = 0; i < 18; ++i) {
    CHECK(faces[i].offset == faces[i / 6 * 6].offset);
    CHECK(has(faces, {-faces[i].normal, faces[i].offset}));
  }
}

TEST_CASE("of parallel faces the nearest counts; distances are those of the planes") {
  Habit h = habit(quartz, "32", {{{0, 0, 1}, 2}, {{0, 0, 1}, 1.5}});
  h.size = 2;
  const auto faces = individuals(h)[0].faces;
  REQUIRE(faces.size() == 2);
  CHECK(faces[0].offset / length(h.lattice.normal({0, 0, 1})) == doctest::Approx(3).epsilon(1e-15));
}

TEST_CASE("open shapes are told by a direction that nothing closes") {
  const auto direction = open_direction(individuals(habit(quartz, "32", {{{1, 0, 0}, 1}}))[0].faces);
  REQUIRE(direction);
  CHECK(std::abs(direction->z) == doctest::Approx(1));
  CHECK(open_direction({}));
  CHECK(open_direction({{{1, 0, 0}, 1}}));
  CHECK(open_direction({{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}})
            ->z == doctest::Approx(-1));
  CHECK_FALSE(open_direction({{{1, 1, 1}, 1}, {{-1, 0, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, -1}, 1}}));
}

}  // namespace nicol::crystallography
