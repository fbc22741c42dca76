// A kernel specialised to a mask draws what the generic one draws under that mask: none, all, each, each pair.
// NICOL_PAIR_SHARD=i/n takes every n-th pair, so that the builds can be shared out.
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/render/pictures.hpp"

using namespace nicol;
using test::difference;
using test::take;

namespace {

constexpr int feature_count = 0
#define FEATURE(name, bit, meaning) +1
#include "kernels/features.def"
#undef FEATURE
    ;

// Double precision and one lane: what differs then is the physics, not the rounding.
KernelOptions exact(bool generic) {
  KernelOptions options;
  options.real_double = true;
  options.lanes = 1;
  options.generic = generic;
  options.binary_cache = false;
  return options;
}

void same_picture(const test::Setup& setup, std::uint32_t mask) {
  CAPTURE(mask);
  CHECK(difference(take(setup, mask, exact(true), 12), take(setup, mask, exact(false), 12)) < 1e-6);
}

}  // namespace

TEST_CASE("the scene calls for every feature but those it excludes") {
  const auto setup = test::load("everything.pov");
  for (const FeatureReason& row : setup.loaded->features.rows) {
    const bool excluded = row.name == "full_jones" || row.name == "orthographic" || row.name == "lanes_over_pixels" ||
                          row.name == "camera_in_crystal";
    CAPTURE(row.name);
    CHECK(row.on == !excluded);
    CHECK_FALSE(row.reason.empty());
  }
}

TEST_CASE("specialised is generic: none, all, each alone") {
  const auto setup = test::load("everything.pov");
  same_picture(setup, 0);
  same_picture(setup, (1u << feature_count) - 1);
  same_picture(setup, setup.loaded->features.mask);
  for (int i = 0; i < feature_count; ++i) same_picture(setup, 1u << i);
}

TEST_CASE("specialised is generic: each pair") {
  const auto setup = test::load("everything.pov");
  int shard = 0, shards = 1, number = 0;
  if (const char* text = std::getenv("NICOL_PAIR_SHARD")) REQUIRE(std::sscanf(text, "%d/%d", &shard, &shards) == 2);
  for (int i = 0; i < feature_count; ++i)
    for (int j = i + 1; j < feature_count; ++j)
      if (number++ % shards == shard) same_picture(setup, 1u << i | 1u << j);
}
