// Orders of the 32 point groups and multiplicities of their forms: International Tables for
// Crystallography A (2016), table 3.2.3.2.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "host/crystallography/point_group.hpp"

namespace nicol::crystallography {

namespace {

struct Order {
  const char* symbol;
  std::size_t order;
};
const Order orders[] = {{"1", 1},     {"-1", 2},   {"2", 2},    {"m", 2},    {"2/m", 4},    {"222", 4},
                        {"mm2", 4},   {"mmm", 8},  {"4", 4},    {"-4", 4},   {"4/m", 8},    {"422", 8},
                        {"4mm", 8},   {"-42m", 8}, {"4/mmm", 16}, {"3", 3},  {"-3", 6},     {"32", 6},
                        {"3m", 6},    {"-3m", 12}, {"6", 6},    {"-6", 6},   {"6/m", 12},   {"622", 12},
                        {"6mm", 12},  {"-6m2", 12}, {"6/mmm", 24}, {"23", 12}, {"m-3", 24}, {"432", 24},
                        {"-43m", 24}, {"m-3m", 48}};

struct Multiplicity {
  const char* symbol;
  Miller face;
  std::size_t faces;
};
const Multiplicity multiplicities[] = {
    {"m-3m", {1, 0, 0}, 6},  {"m-3m", {1, 1, 1}, 8},  {"m-3m", {1, 1, 0}, 12}, {"m-3m", {2, 1, 0}, 24},
    {"m-3m", {2, 1, 1}, 24}, {"m-3m", {2, 2, 1}, 24}, {"-43m", {1, 1, 1}, 4},  {"-43m", {1, 1, 0}, 12},
    {"-43m", {2, 1, 1}, 12}, {"m-3", {2, 1, 0}, 12},  {"23", {1, 1, 1}, 4},    {"432", {2, 1, 0}, 24},
    {"6/mmm", {0, 0, 1}, 2}, {"6/mmm", {1, 0, 0}, 6}, {"6/mmm", {1, 0, 1}, 12}, {"6mm", {0, 0, 1}, 1},
    {"-6m2", {1, 1, 1}, 12}, {"-6m2", {1, 0, 1}, 6}, {"-6m2", {1, 0, 0}, 3}, {"-6m2", {1, 1, 0}, 6},
    {"-62m", {1, 1, 0}, 3}, {"-62m", {1, 0, 0}, 6},
    {"32", {0, 0, 1}, 2},    {"32", {1, 0, 0}, 6},    {"32", {1, 1, 0}, 3},    {"32", {1, 0, 1}, 6},
    {"32", {1, 1, 1}, 6},    {"32", {5, 1, 1}, 6},    {"312", {1, 0, 0}, 3},   {"312", {1, 1, 0}, 6},
    {"3m", {1, 0, 0}, 3},    {"3m", {1, 1, 0}, 6},    {"3m", {1, 0, 1}, 3},    {"3m", {0, 0, 1}, 1},
    {"31m", {1, 1, 0}, 3},   {"31m", {1, 0, 0}, 6},   {"-3m", {1, 0, 1}, 6},   {"-3m", {2, 1, 1}, 12},
    {"-3m", {1, 1, 1}, 12},  {"-31m", {1, 1, 1}, 6},  {"-3", {1, 0, 1}, 6},    {"3", {0, 0, 1}, 1},
    {"4/mmm", {1, 1, 1}, 8}, {"4/mmm", {2, 1, 0}, 8}, {"-42m", {1, 1, 1}, 4},  {"-42m", {1, 0, 1}, 8},
    {"-4m2", {1, 0, 1}, 4},  {"-4m2", {1, 1, 1}, 8},  {"mmm", {1, 1, 0}, 4},   {"mmm", {1, 0, 0}, 2},
    {"222", {1, 1, 1}, 4},   {"mm2", {0, 0, 1}, 1},   {"mm2", {1, 1, 1}, 4},   {"mm2", {1, 1, 0}, 4},
    {"2/m", {0, 1, 0}, 2},   {"2/m", {1, 1, 0}, 4},   {"2/m", {1, 0, 0}, 2},   {"2", {0, 1, 0}, 1},
    {"2", {1, 0, 0}, 2},     {"m", {1, 0, 1}, 1},     {"m", {0, 1, 0}, 2},     {"-1", {3, -2, 1}, 2}};

}  // namespace

TEST_CASE("all 32 point groups: order, and as many faces of a general form") {
  for (const Order& row : orders) {
    CAPTURE(std::string(row.symbol));
    const auto group = find_point_group(row.symbol);
    REQUIRE(group);
    CHECK(group->symbol == row.symbol);
    CHECK(group->operations.size() == row.order);
    CHECK(form(*group, {5, 2, 3}).size() == row.order);
  }
}

TEST_CASE("multiplicities of special forms") {
  for (const Multiplicity& row : multiplicities) {
    CAPTURE(std::string(row.symbol));
    CAPTURE(to_text(row.face));
    CHECK(form(*find_point_group(row.symbol), row.face).size() == row.faces);
  }
}

TEST_CASE("eleven groups have hands, eleven have an inversion") {
  int hands = 0, inversions = 0;
  for (const Order& row : orders) {
    const auto group = find_point_group(row.symbol);
    hands += group->has_hands();
    const auto faces = form(*group, {5, 2, 3});
    inversions += std::find(faces.begin(), faces.end(), Miller{-5, -2, -3}) != faces.end();
  }
  CHECK(hands == 11);
  CHECK(inversions == 11);
}

TEST_CASE("full, old and spaced symbols name the same groups") {
  CHECK(find_point_group("m3m")->symbol == "m-3m");
  CHECK(find_point_group("4/m -3 2/m")->symbol == "m-3m");
  CHECK(find_point_group("321")->symbol == "32");
  CHECK(find_point_group("2/m 2/m 2/m")->symbol == "mmm");
  CHECK(find_point_group("-3 2/m")->symbol == "-3m");
  CHECK_FALSE(find_point_group("33"));
  CHECK_FALSE(find_point_group("32", false) == std::nullopt);
  CHECK_FALSE(find_point_group("432", true));
  for (const std::string& symbol : point_group_symbols()) CHECK(find_point_group(symbol));
}

TEST_CASE("rhombohedral axes: {100} is the rhombohedron, {111} the base") {
  const auto group = find_point_group("-3m", true);
  REQUIRE(group);
  CHECK(group->operations.size() == 12);
  CHECK(form(*group, {1, 0, 0}).size() == 6);
  CHECK(form(*group, {1, 1, 1}).size() == 2);
  CHECK(form(*group, {1, 0, -1}).size() == 6);
  CHECK(form(*find_point_group("32", true), {1, 0, -1}).size() == 3);
}

TEST_CASE("indices: four need h + k + i = 0, none is all zero, common divisors go") {
  std::string why;
  CHECK(face_of_indices({1, 0, -1, 1}, why) == Miller{1, 0, 1});
  CHECK(face_of_indices({2, 0, 2}, why) == Miller{1, 0, 1});
  CHECK_FALSE(face_of_indices({1, 0, 1, 1}, why));
  CHECK(why == "Miller-Bravais indices (h k i l) need h + k + i = 0; here i must be -1");
  CHECK_FALSE(face_of_indices({0, 0, 0}, why));
  CHECK(why == "a face with all indices zero is none");
  CHECK_FALSE(face_of_indices({1.5, 0, 0}, why));
  CHECK_FALSE(face_of_indices({1, 0}, why));
  CHECK(parse_indices("10-11") == std::vector<double>{1, 0, -1, 1});
  CHECK(parse_indices("12 3 -15 4") == std::vector<double>{12, 3, -15, 4});
  CHECK_FALSE(parse_indices("1x1"));
  CHECK_FALSE(parse_indices("1-"));
}

}  // namespace nicol::crystallography
