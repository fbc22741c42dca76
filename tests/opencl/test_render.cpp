// The render loop on the stand-in kernel: every number of the picture is known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/samples.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {

Frame picture(Device& device, const PackedScene& scene, const RenderOptions& options, RenderReport& report) {
  const auto lambda_nm = wavelengths(scene.channels);
  return render(device, scene, lambda_nm, std::vector<double>(lambda_nm.size(), 10.0), options, report);
}

RenderOptions with_lanes(int lanes) {
  RenderOptions options;
  options.kernel.lanes = lanes;
  return options;
}

// Largest difference of any Stokes value from the stand-in's, relative to the value.
double worst_difference(const Frame& frame, const std::vector<std::array<double, 2>>& samples) {
  double worst = 0;
  for (int s = 0; s < 4; ++s)
    for (std::size_t w = 0; w < frame.lambda_nm.size(); ++w)
      for (std::size_t p = 0; p < frame.plane(); ++p) {
        const double right = stand_in_value(s, static_cast<int>(p), static_cast<int>(w), samples);
        worst = std::max(worst, std::fabs(static_cast<double>(frame.component(s, w)[p]) - right) / right);
      }
  return worst;
}

bool same_bits(const Frame& a, const Frame& b) {
  return a.stokes.size() == b.stokes.size() && a.cut_off.size() == b.cut_off.size() &&
         std::memcmp(a.stokes.data(), b.stokes.data(), a.stokes.size() * sizeof(float)) == 0 &&
         std::memcmp(a.cut_off.data(), b.cut_off.data(), a.cut_off.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("every value lands at its pixel, wavelength and component, for all lanes and both reals") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  for (int lanes : {1, 4, 8, 16})
    for (bool over_pixels : {false, true})
      for (bool real_double : {false, true}) {
        const PackedScene scene = stand_in_scene(13, 7, 11, lanes, over_pixels);
        RenderOptions options = with_lanes(lanes);
        options.kernel.real_double = real_double;
        options.kernel.generic = true;
        options.samples = 3;
        RenderReport report;
        const Frame frame = picture(*device, scene, options, report);
        CAPTURE(lanes);
        CAPTURE(over_pixels);
        CAPTURE(real_double);
        CHECK(worst_difference(frame, pixel_samples(3)) < 3e-7);
        CHECK(frame.rows_done == 7);
        CHECK(!report.interrupted);
        CHECK(report.lanes == lanes);
        CHECK(report.real == (real_double ? "double" : "float"));
        CHECK(report.nan_count == 1);
        const int units = over_pixels ? (13 * 7 + lanes - 1) / lanes * 11 : 13 * 7 * scene.stride / lanes;
        CHECK(report.segments == static_cast<std::uint64_t>(units) * lanes * 3);
      }
}

TEST_CASE("the generic kernel gives the picture of the specialised one") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  const PackedScene scene = stand_in_scene(9, 5, 8, 8, true);
  RenderOptions options = with_lanes(8);
  RenderReport report;
  const Frame special = picture(*device, scene, options, report);
  options.kernel.generic = true;
  CHECK(same_bits(special, picture(*device, scene, options, report)));
}

TEST_CASE("work-groups of 64 with a padded last one give the same picture as groups of 1") {
  const KernelFolder kernels;
  const auto device = open_device("0"), like_a_gpu = open_device("0");
  like_a_gpu->about.is_cpu = false;
  CHECK(lanes_on(*like_a_gpu, {}) == 1);
  RenderReport report;
  RenderOptions options = with_lanes(1);
  options.tile_seconds = 1e-5;
  const PackedScene scene = stand_in_scene(37, 11, 3, 1);
  const Frame grouped = picture(*like_a_gpu, scene, options, report);
  CHECK(report.build.options.find("-D LOCAL_SIZE=64") != std::string::npos);
  CHECK(same_bits(grouped, picture(*device, scene, options, report)));
  CHECK(report.segments == 37 * 11 * 3);
}

TEST_CASE("double on a device without it is refused with a way out") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  device->about.has_fp64 = false;
  RenderOptions options = with_lanes(8);
  options.kernel.real_double = true;
  RenderReport report;
  CHECK_THROWS_WITH_AS(picture(*device, stand_in_scene(4, 4, 8, 8), options, report),
                       doctest::Contains("cannot calculate in double precision (no cl_khr_fp64)"),
                       DeviceError);
}

TEST_CASE("the cut-off weight is the mean over channels, and reported") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  RenderReport report;
  const Frame frame = picture(*device, stand_in_scene(3, 2, 5, 8), with_lanes(8), report);
  double mean = 0;
  for (int p = 0; p < 6; ++p) {
    double right = 0;
    for (int w = 0; w < 5; ++w) right += stand_in_value(4, p, w, pixel_samples(1)) / 5;
    CHECK(static_cast<double>(frame.cut_off[static_cast<std::size_t>(p)]) == doctest::Approx(right));
    mean += right / 6;
  }
  CHECK(report.cut_off_mean == doctest::Approx(mean));
  CHECK(report.cut_off_worst == doctest::Approx(static_cast<double>(frame.cut_off[5])));
}

TEST_CASE("channels are mixed into wavelengths") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  PackedScene scene = stand_in_scene(4, 4, 2, 8);
  scene.mixing = {1, 0, 0.5, 0, 2, 0.25};   // 2 channels in 3 wavelengths
  RenderReport report;
  const Frame frame = render(*device, scene, wavelengths(3), {1, 1, 1}, with_lanes(8), report);
  for (int s = 0; s < 4; ++s)
    for (int p = 0; p < 16; ++p) {
      const double a = stand_in_value(s, p, 0, pixel_samples(1)), b = stand_in_value(s, p, 1, pixel_samples(1));
      const double right[] = {a, 2 * b, 0.5 * a + 0.25 * b};
      for (std::size_t w = 0; w < 3; ++w)
        CHECK(static_cast<double>(frame.component(s, w)[p]) == doctest::Approx(right[w]));
    }
}

TEST_CASE("samples that need several launches, and samples at given places") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  RenderOptions options = with_lanes(8);
  options.samples = 37;
  RenderReport report;
  CHECK(worst_difference(picture(*device, stand_in_scene(10, 6, 9, 8), options, report), pixel_samples(37)) < 3e-7);
  options.positions = {{0.25, 0.75}, {1, 0}};
  CHECK(worst_difference(picture(*device, stand_in_scene(10, 6, 9, 8), options, report), options.positions) < 3e-7);
}

TEST_CASE("the picture is the same to the bit whatever the tiles") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  for (bool over_pixels : {false, true}) {
    const PackedScene scene = stand_in_scene(61, 43, 19, 8, over_pixels);
    RenderOptions options = with_lanes(8);
    options.samples = 21;
    RenderReport one, many;
    options.tile_seconds = 10;
    const Frame large = picture(*device, scene, options, one);
    options.tile_seconds = 1e-5;
    const Frame small = picture(*device, scene, options, many);
    CHECK(many.tiles > one.tiles);
    CHECK(same_bits(large, small));
  }
}

TEST_CASE("cancelling leaves whole rows and says which") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  PackedScene scene = stand_in_scene(64, 64, 8, 8);
  scene.reals = {2000};
  std::atomic<bool> cancel{false};
  RenderOptions options = with_lanes(8);
  options.tile_seconds = 0.005;
  options.cancel = &cancel;
  options.progress = [&](const Progress& now) { cancel = cancel || now.fraction > 0.2; };
  RenderReport report;
  const Frame frame = picture(*device, scene, options, report);
  CHECK(report.interrupted);
  CHECK(frame.rows_done > 0);
  CHECK(frame.rows_done < 64);
  int rows = 0;
  for (std::size_t row = 0; row < 64; ++row) {
    rows += frame.row_done[row];
    for (std::size_t x = 0; x < 64; ++x) CHECK((frame.component(3, 7)[row * 64 + x] != 0) == bool(frame.row_done[row]));
  }
  CHECK(rows == frame.rows_done);
}

TEST_CASE("cancelled before it starts: an empty picture") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  const std::atomic<bool> cancel{true};
  RenderOptions options = with_lanes(8);
  options.cancel = &cancel;
  RenderReport report;
  const Frame frame = picture(*device, stand_in_scene(4, 4, 8, 8), options, report);
  CHECK(report.interrupted);
  CHECK(frame.rows_done == 0);
  CHECK(report.tiles == 0);
}

TEST_CASE("progress rises to 1 and knows the speed") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  RenderOptions options = with_lanes(8);
  options.samples = 40;
  double last = 0, rate = 0;
  bool rises = true;
  options.progress = [&](const Progress& now) {
    rises = rises && now.fraction > last && now.seconds_left >= 0;
    last = now.fraction;
    rate = now.segments_per_second;
  };
  RenderReport report;
  picture(*device, stand_in_scene(50, 40, 8, 8), options, report);
  CHECK(rises);
  CHECK(last == 1);
  CHECK(rate > 0);
}

TEST_CASE("every tile is told once with its pixels, which have their values then") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  for (bool over_pixels : {false, true})
    for (bool listed : {false, true}) {
      RenderOptions options = with_lanes(8);
      options.samples = 20;
      options.tile_seconds = 1e-4;
      if (listed) options.pixels = {3, 5, 8, 13, 21, 34, 55, 89, 144, 233};
      std::vector<int> told(listed ? 10 : 20 * 15, 0);
      bool there = true;
      options.tile = [&](const Frame& frame, const std::int32_t* pixels, std::size_t count) {
        CHECK(count > 0);
        for (std::size_t i = 0; i < count; ++i) {
          const auto p = static_cast<std::size_t>(pixels[i]);
          ++told.at(p);
          const double right = stand_in_value(2, listed ? options.pixels[p] : pixels[i], 4, pixel_samples(20));
          there = there && std::fabs(static_cast<double>(frame.component(2, 4)[p]) - right) < 1e-6 * right;
        }
      };
      RenderReport report;
      picture(*device, stand_in_scene(20, 15, 5, 8, over_pixels), options, report);
      CHECK(there);
      CHECK(std::count(told.begin(), told.end(), 1) == static_cast<std::ptrdiff_t>(told.size()));
    }
}

TEST_CASE("a picture that memory cannot hold is refused with its size") {
  const auto device = open_device("0");
  PackedScene scene = stand_in_scene(20000, 20000, 1, 8);
  scene.mixing.assign(400, 1.0);
  RenderReport report;
  try {
    render(*device, scene, wavelengths(400), std::vector<double>(400, 1.0), with_lanes(8), report);
    FAIL("fits");
  } catch (const DeviceError& error) {
    CHECK(std::string(error.what()).find("20000 x 20000 pixels and 400 wavelengths needs 2561.6 GB") !=
          std::string::npos);
  }
}

TEST_CASE("a scene packed for other lanes or with the wrong number of wavelengths is refused") {
  const auto device = open_device("0");
  RenderReport report;
  CHECK_THROWS_AS(picture(*device, stand_in_scene(4, 4, 5, 1), with_lanes(8), report), std::invalid_argument);
  CHECK_THROWS_AS(render(*device, stand_in_scene(4, 4, 8, 8), wavelengths(7), std::vector<double>(7, 1.0),
                         with_lanes(8), report),
                  std::invalid_argument);
  CHECK_THROWS_AS(lanes_on(*device, with_lanes(3).kernel), DeviceError);
  CHECK_THROWS_WITH_AS(picture(*device, stand_in_scene(20000, 20000, 80, 8), with_lanes(8), report),
                       doctest::Contains("20000 x 20000 pixels and 80 channels"), DeviceError);
}
