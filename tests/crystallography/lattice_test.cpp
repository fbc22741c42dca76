// Angles between the normals of faces against those printed in E. S. Dana, A System of Mineralogy, 6th
// ed. (1892), for the axial ratios printed there; "within" is half a minute of arc and what the
// last digit of the ratios leaves.
#include <doctest/doctest.h>

#include "host/crystallography/lattice.hpp"
#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

double angle_deg(const Lattice& lattice, Miller f, Miller g) {
  return std::acos(dot(normalize(lattice.normal(f)), normalize(lattice.normal(g)))) * degrees;
}

Lattice lattice(const Cell& cell, bool rhombohedral = false) {
  std::string why;
  const auto made = make_lattice(cell, rhombohedral, why);
  REQUIRE_MESSAGE(made, why);
  return *made;
}

constexpr double dm(double deg, double minutes) { return deg + minutes / 60; }

Cell hexagonal(double ratio) { return {1, 1, ratio, 90, 90, 120}; }

struct Published {
  const char* name;
  Cell cell;
  Miller f, g;
  double angle_deg;
};
const Cell quartz = hexagonal(1.09997), calcite = hexagonal(0.85430),
           orthoclase{0.6585, 1, 0.5554, 90, dm(116, 3), 90},
           gypsum{0.68994, 1, 0.41241, 90, dm(99, 18), 90},
           albite{0.63347, 1, 0.55770, dm(94, 3), dm(116, 29), dm(88, 9)};
const Published angles[] = {
    {"quartz m r", quartz, {1, 0, 0}, {1, 0, 1}, dm(38, 13)},
    {"quartz r r'", quartz, {1, 0, 1}, {-1, 1, 1}, dm(85, 46)},
    {"quartz r z", quartz, {1, 0, 1}, {0, 1, 1}, dm(46, 16)},
    {"quartz m s", quartz, {1, 0, 0}, {1, 1, 1}, dm(37, 58)},
    {"quartz m x", quartz, {1, 0, 0}, {5, 1, 1}, dm(12, 1)},
    {"calcite r r' (cleavage)", calcite, {1, 0, 1}, {-1, 1, 1}, dm(74, 55)},
    {"calcite c r", calcite, {0, 0, 1}, {1, 0, 1}, dm(44, 36.5)},
    {"zircon p p'", {1, 1, 0.640373, 90, 90, 90}, {1, 1, 1}, {-1, 1, 1}, dm(56, 40.5)},
    {"rutile e e'", {1, 1, 0.64415, 90, 90, 90}, {1, 0, 1}, {0, 1, 1}, dm(45, 2)},
    {"topaz m m'''", {0.52854, 1, 0.47698, 90, 90, 90}, {1, 1, 0}, {1, -1, 0}, dm(55, 43)},
    {"aragonite m m'''", {0.62244, 1, 0.72056, 90, 90, 90}, {1, 1, 0}, {1, -1, 0}, dm(63, 48)},
    {"barite m m'''", {0.81520, 1, 1.31359, 90, 90, 90}, {1, 1, 0}, {1, -1, 0}, dm(78, 22.5)},
    {"orthoclase m m'''", orthoclase, {1, 1, 0}, {1, -1, 0}, dm(61, 13)},
    {"orthoclase c m", orthoclase, {0, 0, 1}, {1, 1, 0}, dm(67, 47)},
    {"orthoclase c y", orthoclase, {0, 0, 1}, {-2, 0, 1}, dm(80, 18)},
    {"gypsum m m'''", gypsum, {1, 1, 0}, {1, -1, 0}, dm(68, 30)},
    {"albite b c", albite, {0, 1, 0}, {0, 0, 1}, dm(86, 24)},
    {"albite m M", albite, {1, 1, 0}, {1, -1, 0}, dm(59, 14)}};

}  // namespace

TEST_CASE("axial ratios give the published angles between faces") {
  for (const Published& row : angles) {
    CAPTURE(std::string(row.name));
    CHECK(std::abs(angle_deg(lattice(row.cell), row.f, row.g) - row.angle_deg) < 0.02);
  }
}

TEST_CASE("the cleavage rhombohedron of calcite has edges of 105.08 and 74.92 degrees") {
  const Lattice c = lattice(calcite);
  CHECK(180 - angle_deg(c, {1, 0, 1}, {-1, 1, 1}) == doctest::Approx(105.08).epsilon(1e-4));
  CHECK(180 - angle_deg(c, {1, 0, 1}, {1, -1, -1}) == doctest::Approx(74.92).epsilon(1e-4));
}

TEST_CASE("rhombohedral axes are the hexagonal ones, obverse") {
  // alpha of calcite's morphological rhombohedron: 101 deg 55' (Dana); c/a = 0.8543.
  const double alpha_deg = 2 * std::asin(1.5 / std::sqrt(3 + 0.85430 * 0.85430)) * degrees;
  CHECK(std::abs(alpha_deg - dm(101, 55)) < 0.02);
  const Lattice r = lattice({1, 1, 1, alpha_deg, alpha_deg, alpha_deg}, true), h = lattice(calcite);
  CHECK(angle_deg(r, {1, 0, 0}, {0, 1, 0}) ==
        doctest::Approx(angle_deg(h, {1, 0, 1}, {-1, 1, 1})).epsilon(1e-12));
  const Vec3 a = normalize(r.normal({1, 0, 0})), b = normalize(h.normal({1, 0, 1}));
  CHECK(length(a - b) < 1e-12);
  const Vec3 up = normalize(r.normal({1, 1, 1}));
  CHECK(length(up - Vec3{0, 0, 1}) < 1e-12);
}

TEST_CASE("Z runs along c, Y along b*, a lies in XZ, right-handed; reciprocal axes are dual") {
  const Lattice l = lattice({1.3, 2, 0.7, 94, 116, 88});
  CHECK(l.axes[2].x == 0);
  CHECK(l.axes[2].y == 0);
  CHECK(l.axes[0].y == 0);
  CHECK(l.axes[0].x > 0);
  CHECK(std::abs(l.reciprocal[1].x) + std::abs(l.reciprocal[1].z) < 1e-15);
  CHECK(dot(l.axes[0], cross(l.axes[1], l.axes[2])) > 0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(dot(l.axes[i], l.reciprocal[j]) == doctest::Approx(i == j ? 1 : 0).epsilon(1e-14));
  const double lengths[] = {1.3, 2, 0.7};
  for (int i = 0; i < 3; ++i) CHECK(length(l.axes[i]) == doctest::Approx(lengths[i]).epsilon(1e-14));
  CHECK(std::acos(dot(l.axes[0], l.axes[1]) / 2.6) * degrees == doctest::Approx(88).epsilon(1e-12));
}

TEST_CASE("right angles are exact: an orthorhombic lattice has no rounding in its zeros") {
  const Lattice l = lattice({0.5, 1, 2, 90, 90, 90});
  CHECK(l.axes[0].z == 0);
  CHECK(l.axes[1].x == 0);
  CHECK(l.axes[1].z == 0);
}

TEST_CASE("cells that do not exist, and groups that do not fit") {
  std::string why;
  CHECK_FALSE(make_lattice({1, 1, 0, 90, 90, 90}, false, why));
  CHECK_FALSE(make_lattice({1, 1, 1, 30, 30, 90}, false, why));
  CHECK(why == "no cell has these angles: its edges would lie in one plane");
  CHECK_FALSE(make_lattice({1, 1, 2, 80, 80, 80}, true, why));
  CHECK(fits(lattice(quartz), *find_point_group("32")));
  CHECK_FALSE(fits(lattice({1, 1, 1.1, 90, 90, 90}), *find_point_group("32")));
  CHECK_FALSE(fits(lattice({1, 1.01, 1, 90, 90, 90}), *find_point_group("432")));
  CHECK(fits(lattice({1, 1.01, 1, 90, 90, 90}), *find_point_group("222")));
}

}  // namespace nicol::crystallography
