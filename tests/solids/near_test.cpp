// Faces that nearly touch: one warning for each pair of objects, with the distance.
#include <doctest/doctest.h>

#include <cmath>

#include "measures.hpp"

using namespace nicol;
using namespace nicol::test;

TEST_CASE("cubes a rounding step apart, or 1e-10, are told; 1e-6 is meant") {
  const auto apart = [](double gap) {
    return build({solid(box({0, 0, 0}, {1, 1, 1}), 1), solid(box({1 + gap, 0, 0}, {2, 1, 1}), 2)});
  };
  for (double gap : {3e-16, 1e-10}) {
    const Built built = apart(gap);
    CHECK_FALSE(built.failed);
    REQUIRE(built.messages.size() == 1);
    CHECK(built.says("box at line 1 and box at line 2 come within"));
    CHECK(built.geometry.patches.empty());
  }
  CHECK(apart(1e-10).says("1e-10 mm"));
  CHECK(apart(3e-16).says("2.22e-16 mm"));
  CHECK(apart(1e-6).messages.empty());
  CHECK(apart(0).messages.empty());
}

TEST_CASE("a light under a cube by 1e-17, a disc by 1e-12, and one rotated by other numbers") {
  const Object cube = solid(box({-1, 0, -1}, {1, 2, 1}), 1);
  CHECK(build({cube, light(floor_square(-2, 2, -1e-17), 2)}).says("come within 1e-17 mm"));
  CHECK(build({cube, light(floor_square(-2, 2, 1e-17), 2)}).says("come within 1e-17 mm"));
  CHECK(build({cube, light(DiscShape{{0, -1e-12, 0}, {0, 1, 0}, 0.5, 0}, 2)})
            .says("come within 1e-12 mm"));
  CHECK(build({cube, light(DiscShape{{8, -1e-12, 0}, {0, 1, 0}, 0.5, 0}, 2)}).messages.empty());

  // The same rotation written as one and as two: sin and cos differ in their last digits.
  Object turned = cube, lamp = light(floor_square(-2, 2, 0), 2);
  turned.transforms = {rotate_x(50)};
  lamp.transforms = {rotate_x(25), rotate_x(25)};
  CHECK(build({turned, lamp}).says("come within"));
}

TEST_CASE("neighbours whose tops differ by a rounding step are no near-contact") {
  const Built built =
      build({solid(box({0, 0, 0}, {1, 1, 1}), 1), solid(box({1, 0, 0}, {2, 1 + 3e-16, 1}), 2)});
  CHECK(built.messages.empty());
  CHECK(built.geometry.patches.size() == 2);
}
