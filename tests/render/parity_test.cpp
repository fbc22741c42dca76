// The same picture from any number of lanes, from the C++ compiler and from OpenCL.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "kernels/abi.h"
#include "tests/bench/native.hpp"
#include "tests/render/pictures.hpp"

using namespace nicol;
using test::difference;
using test::take;

namespace {

KernelOptions with(int lanes, bool real_double) {
  KernelOptions options;
  options.lanes = lanes;
  options.real_double = real_double;
  return options;
}

}  // namespace

// The order in which a tree is followed, and so the order of its sums, is that of the lanes together.
TEST_CASE("lanes change nothing but the order of sums") {
  const auto setup = test::load("everything.pov");
  const auto one = take(setup, setup.loaded->features.mask, with(1, false), 32);
  for (int lanes : {4, 8, 16}) {
    CAPTURE(lanes);
    const auto many = take(setup, setup.loaded->features.mask, with(lanes, false), 32);
    CHECK(difference(one, many) <= 1.2e-7);   // the last bit of a float at most: sums are compensated
    // compilers fuse scalars and vectors apart: a weight at adc_bailout to its last bit may fall on either side
    const double more = static_cast<double>(many.report.segments) / static_cast<double>(one.report.segments);
    CHECK(std::fabs(more - 1) < 1e-3);
  }
}

TEST_CASE("nothing is counted against the picture, and float stays near double") {
  const auto setup = test::load("everything.pov");
  for (bool real_double : {false, true}) {
    const auto picture = take(setup, setup.loaded->features.mask, with(0, real_double), 48);
    CHECK(picture.report.nan_count == 0);
    CHECK(picture.report.energy_count == 0);
    CHECK(picture.report.stack_count == 0);
    CHECK(picture.report.stokes_count == 0);
    CHECK(picture.report.segments > 48 * 48);
  }
}

TEST_CASE("lanes over pixels draw what lanes over wavelengths draw") {
  const auto setup = test::load("everything.pov");
  const std::uint32_t mask = setup.loaded->features.mask;
  std::uint32_t bit = 1, over_pixels = 0;
  for (const FeatureReason& row : setup.loaded->features.rows) {
    if (row.name == "lanes_over_pixels") over_pixels = bit;
    bit <<= 1;
  }
  CHECK(difference(take(setup, mask, with(8, false), 32), take(setup, mask | over_pixels, with(8, false), 32)) <= 1.2e-7);
}

TEST_CASE("the C++ compiler draws the picture that OpenCL draws") {
  const auto setup = test::load("everything.pov");
  const Scene& scene = setup.loaded->scene;
  const auto device = take(setup, setup.loaded->features.mask, with(1, true), 24);
  const auto host = bench::render_native_double(pack(scene, setup.loaded->geometry, setup.loaded->features.mask, 24, 24, 1));
  double apart = 0, largest = 0;
  const std::size_t count = scene.lambda_nm.size();
  for (int pixel = 0; pixel < 24 * 24; ++pixel) {
    for (std::size_t lambda = 0; lambda < count; ++lambda) {
      for (int s = 0; s < 4; ++s) {
        const double a = device.frame.component(s, lambda)[pixel];
        const double b = host.out[(pixel * count + lambda) * OUT_COMPONENTS + s];
        apart = std::max(apart, std::fabs(a - b));
        largest = std::max(largest, std::fabs(b));
      }
    }
  }
  CHECK(largest > 0);
  CHECK(apart < 1e-6 * largest);  // the frame is float
}
