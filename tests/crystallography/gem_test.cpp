// Gem cuts: directions of facets, GemCad's text format, faults with their lines.
#include <doctest/doctest.h>

#include "host/crystallography/bounded.hpp"
#include "host/crystallography/gem.hpp"
#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

// The standard round brilliant that the manual of GemCad for Windows walks through.
const char* const round_brilliant =
    "GemCad 5.0\n"
    "g 96 0.0\n"
    "y 8 y\n"
    "I 1.54\n"
    "H Standard Round Brilliant\n"
    "a -90.000000 1.02653281 93 n G 87 81 75 69 63 57 51 45 39 33 27 21 15 9 3\n"
    "a -42.500000 0.61819401 93 n 1 87 81 75 69 63 57 51 45 39 33 27 21 15 9 3\n"
    "a -41.500000 0.61701256 96 n 2 84 72 60\n"
    "48 36 24 12 G Meet at the culet\n"
    "a 34.000000 0.68444470 3 n A 9 15 21 27 33 39 45 51 57 63 69 75 81 87 93\n"
    "a 28.000000 0.60896430 96 n B 12 24 36 48 60 72 84\n"
    "a 16.000000 0.50613241 6 n C 18 30 42 54 66 78 90\n"
    "a 0.000000 0.36450932 96 n T\n"
    "F footnote\n";

GemCut cut_of(const std::string& text) {
  const auto read = read_gemcad(text);
  if (const GemCadError* error = std::get_if<GemCadError>(&read)) {
    FAIL(error->message, " line ", error->line);
    return {};
  }
  return std::get<GemCut>(read);
}

void check_error(const std::string& text, int line, const std::string& message) {
  CAPTURE(text);
  const auto read = read_gemcad(text);
  const GemCadError* error = std::get_if<GemCadError>(&read);
  REQUIRE(error);
  CHECK(error->message == message);
  CHECK(error->line == line);
}

void check_near(Vec3 a, Vec3 b) { CHECK(length(a - b) < 1e-15); }

}  // namespace

TEST_CASE("facets: crown up, pavilion down, teeth clockwise seen from above") {
  check_near(facet_normal(0.0, 96, 96), {0, 1, 0});
  check_near(facet_normal(-0.0, 96, 96), {0, -1, 0});
  check_near(facet_normal(90, 96, 96), {0, 0, 1});
  check_near(facet_normal(-90, 24, 96), {1, 0, 0});
  check_near(facet_normal(30, 24, 96), {0.5, std::sqrt(0.75), 0});
  check_near(facet_normal(-30, 48, 96), {0, -std::sqrt(0.75), -0.5});
}

TEST_CASE("GemCad's standard round brilliant: 57 facets and a girdle of 16") {
  const GemCut cut = cut_of(round_brilliant);
  CHECK(cut.gear == 96);
  CHECK(cut.refractive_index == 1.54);
  CHECK(cut.title == "Standard Round Brilliant");
  REQUIRE(cut.tiers.size() == 7);
  CHECK(cut.tiers[2].teeth.size() == 8);
  CHECK(cut.tiers[2].name == "2");
  const auto faces = half_spaces(cut);
  CHECK(faces.size() == 57 + 16);
  CHECK_FALSE(open_direction(faces));
  CHECK(girdle_width(cut) == doctest::Approx(2 * 1.02653281));
  // The eight mains of the pavilion meet in one point of the axis, to the last bit.
  int mains = 0;
  for (const HalfSpace& f : faces) {
    if (f.offset != 0.61701256) continue;
    ++mains;
    CHECK(f.normal.y == faces[16 + 16].normal.y);
  }
  CHECK(mains == 8);
}

TEST_CASE("without its pavilion the stone is open downwards") {
  GemCut cut = cut_of(round_brilliant);
  cut.tiers.erase(cut.tiers.begin() + 1, cut.tiers.begin() + 3);
  const auto direction = open_direction(half_spaces(cut));
  REQUIRE(direction);
  CHECK(direction->y == doctest::Approx(-1));
}

TEST_CASE("a turned gear turns every facet") {
  const GemCut cut = cut_of("g 96 90\na 90 1 96\na 0 1 96\n");
  check_near(half_spaces(cut)[0].normal, {1, 0, 0});
}

TEST_CASE("faults of a file are told with their lines") {
  check_error("GemCad 5.0\na 41 0.5 96\n", 2, "no gear: a line 'g 96 0.0' is needed");
  check_error("g 96 0\n", 1, "no facets: lines 'a angle distance tooth ...' are needed");
  check_error("g 0 0\n", 1, "a gear has at least one tooth");
  check_error("g 96 0\na 41 x 96\n", 2, "expected the distance of a facet, 'x' found instead");
  check_error("g 96 0\na 91 1 96\n", 2, "a facet's angle lies between -90 and 90");
  check_error("g 96 0\na 41 1 96 huh\n", 2, "expected a tooth of the gear, 'huh' found instead");
  check_error("g 96 0\na 41 1\n", 2, "a facet without a tooth of the gear");
  check_error("96 0\n", 1, "a number outside a facet");
  check_error(std::string("Gem\0Cad", 7), 1, "this is a binary file: GemCad saves text as .asc");
}

}  // namespace nicol::crystallography
