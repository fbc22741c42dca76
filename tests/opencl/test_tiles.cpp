// Tiles cover the picture once, whatever the times they took.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <random>
#include <vector>

#include "host/opencl/samples.hpp"
#include "host/opencl/tiles.hpp"

using namespace nicol;

TEST_CASE("every sample of every unit is launched once, in order, within the limits") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 40);
    const int samples = *rc::gen::inRange(1, 50), max_units = *rc::gen::inRange(1, 500);
    UnitPool pool(width * height, *rc::gen::element(0, width));
    TileSchedule schedule(pool, samples, max_units, 0.03);
    std::vector<int> done(static_cast<std::size_t>(width * height), 0);
    for (Tile tile; schedule.next(tile);) {
      RC_ASSERT(tile.unit_count >= 1 && tile.unit_count <= max_units);
      RC_ASSERT(tile.sample_end - tile.sample_begin <= TileSchedule::samples_per_launch);
      for (auto unit = tile.first_unit; unit < tile.first_unit + tile.unit_count; ++unit) {
        RC_ASSERT(done.at(static_cast<std::size_t>(unit)) == tile.sample_begin);
        done[static_cast<std::size_t>(unit)] = tile.sample_end;
      }
      schedule.took(tile, *rc::gen::element(0.0, 1e-6, 0.001, 0.1, 10.0));
    }
    for (int n : done) RC_ASSERT(n == samples);
  }));
}

TEST_CASE("tiles grow to the wanted time and end with rows") {
  UnitPool pool(1000 * 1000, 1000);
  TileSchedule schedule(pool, 1, 60000, 0.03);
  Tile tile;
  double seconds = 0;
  for (int i = 0; i < 12; ++i) {
    REQUIRE(schedule.next(tile));
    seconds = static_cast<double>(tile.unit_count) * 2e-6;
    schedule.took(tile, seconds);
  }
  CHECK(seconds == doctest::Approx(0.03).epsilon(0.1));
  CHECK(tile.first_unit % 1000 == 0);
  CHECK(tile.unit_count % 1000 == 0);
}

TEST_CASE("a cheap stretch does not make the next tile endless") {
  UnitPool pool(10000000, 0);
  TileSchedule schedule(pool, 1, 1000000, 0.03);
  Tile tile;
  for (int i = 0; i < 12; ++i) {
    schedule.next(tile);
    schedule.took(tile, static_cast<double>(tile.unit_count) * 1e-5);
  }
  const auto before = tile.unit_count;
  schedule.took(tile, 0);
  schedule.next(tile);
  CHECK(tile.unit_count <= 2 * before + 1);
}

TEST_CASE("after a shortage the tiles halve and nothing is left out") {
  UnitPool pool(1000, 0);
  TileSchedule schedule(pool, 40, 64, 0.03);
  Tile tile;
  schedule.next(tile);
  schedule.next(tile);
  CHECK(tile.sample_begin == 16);
  pool.give_back(tile.first_unit, tile.unit_count);
  schedule.restart();
  REQUIRE(schedule.shrink());
  schedule.next(tile);
  CHECK(tile.first_unit == 0);
  CHECK(tile.sample_begin == 0);
  CHECK(tile.unit_count == 32);
  for (int i = 0; i < 5; ++i) CHECK(schedule.shrink());
  CHECK(schedule.max_units() == 1);
  CHECK(!schedule.shrink());
}

TEST_CASE("several executors share the units, whoever gives some back") {
  CHECK(rc::check([] {
    const int units = *rc::gen::inRange(1, 2000), executors = *rc::gen::inRange(2, 6), samples = *rc::gen::inRange(1, 40);
    UnitPool pool(units, *rc::gen::element(0, 17));
    std::vector<TileSchedule> schedules;
    for (int e = 0; e < executors; ++e) schedules.emplace_back(pool, samples, *rc::gen::inRange(1, 300), 0.03);
    std::mt19937 chance(*rc::gen::arbitrary<unsigned>());
    const auto one_of = [&](unsigned n) { return chance() % n; };
    std::vector<int> done(static_cast<std::size_t>(units), 0);
    while (pool.left() > 0) {
      TileSchedule& schedule = schedules[one_of(static_cast<unsigned>(executors))];
      Tile tile;
      RC_ASSERT(schedule.next(tile, executors));
      if (one_of(8) == 0) {
        pool.give_back(tile.first_unit, tile.unit_count);
        schedule.restart();
        continue;
      }
      if (one_of(4) == 0) schedule.cut(tile, 1 + tile.unit_count / 2);
      while (tile.sample_end < samples) RC_ASSERT(schedule.next(tile, executors));
      for (auto unit = tile.first_unit; unit < tile.first_unit + tile.unit_count; ++unit) ++done.at(static_cast<std::size_t>(unit));
      schedule.took(tile, one_of(2) == 0 ? 1e-6 : 0.01);
    }
    for (int n : done) RC_ASSERT(n == 1);
  }));
}

TEST_CASE("tiles get smaller towards the end of what several share") {
  UnitPool pool(1000, 0);
  TileSchedule schedule(pool, 1, 1000, 0.03, 1e-9);
  Tile tile;
  REQUIRE(schedule.next(tile, 2));
  CHECK(tile.unit_count == 250);
  REQUIRE(schedule.next(tile, 2));
  CHECK(tile.unit_count == 187);
  REQUIRE(schedule.next(tile));
  CHECK(tile.unit_count == 563);
}

TEST_CASE("samples start at the centre, stay in the pixel and spread evenly") {
  const auto samples = pixel_samples(256);
  REQUIRE(samples.size() == 256);
  CHECK(samples[0] == std::array<double, 2>{0.5, 0.5});
  std::vector<int> cells(64, 0);
  for (const auto& [x, y] : samples) {
    REQUIRE((x >= 0 && x < 1 && y >= 0 && y < 1));
    ++cells[static_cast<std::size_t>(static_cast<int>(x * 8) * 8 + static_cast<int>(y * 8))];
  }
  // 4 a cell on average; 256 random points would leave one empty as a rule
  for (int n : cells) CHECK((n >= 2 && n <= 6));
}
