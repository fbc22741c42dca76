// Samples where they matter, on real scenes: the error that is asked for is kept, for less; and what an unfinished render has kept goes
// on to the same bits.
#include <doctest/doctest.h>

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "host/accuracy/picture_error.hpp"
#include "host/features.hpp"
#include "tests/render/pictures.hpp"

using namespace nicol;

namespace {

struct Scenes {
  const char* file;
  const char* wavelengths;
};
// Wavelengths in the lanes, pixels in the lanes, one geometry for all wavelengths; a crystal.
const Scenes scenes[] = {{"founding/fig5_active.pov", "400:700:30"},
                         {"founding/fig7_camera2.pov", ""},
                         {"founding/fig5_inactive.pov", "400:700:50"},
                         {"birefringence/calcite_twin.pov", "500:600:50"}};

test::Picture take(test::Setup& setup, int samples, double sample_error, int size = 64, RenderOptions options = {}) {
  setup.loaded->scene.settings.sample_error = sample_error;
  const Features features = decide_features(setup.loaded->scene, setup.loaded->geometry);
  options.samples = samples;
  options.sample_error = sample_error;
  test::Picture picture;
  const PackedScene packed = pack(setup.loaded->scene, setup.loaded->geometry, features.mask, size, size,
                                  lanes_on(*setup.device, options.kernel));
  picture.frame = render(*setup.device, packed, setup.loaded->scene.lambda_nm, setup.loaded->scene.weight_nm, options,
                         picture.report);
  return picture;
}

bool same_bits(const Frame& a, const Frame& b) {
  return a.stokes.size() == b.stokes.size() && a.samples == b.samples &&
         std::memcmp(a.stokes.data(), b.stokes.data(), a.stokes.size() * sizeof(float)) == 0 &&
         std::memcmp(a.cut_off.data(), b.cut_off.data(), a.cut_off.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("the sampling error that is asked for is kept against many samples") {
  for (const Scenes& scene : scenes) {
    CAPTURE(scene.file);
    auto setup = test::load_gallery(scene.file, scene.wavelengths);
    const auto many = take(setup, 511, 0);
    for (const double target : {0.03, 0.01}) {
      CAPTURE(target);
      const auto picture = take(setup, 1, target);
      const double off = picture_error(picture.frame, many.frame).stokes_rms;
      MESSAGE(std::string(scene.file) << ", asked " << target << ", estimated " << picture.report.sample_error << ", is " << off << ", "
                         << picture.report.samples_mean << " samples a pixel");
      CHECK(picture.report.sample_error_kept);
      CHECK(picture.report.sample_error <= target);
      CHECK(off <= target);
      // uniform samples of as many rays; edges along rows of pixels make single counts lucky
      double uniform2 = 0;
      for (const double part : {0.9, 1.0, 1.1}) {
        const auto uniform = take(setup, std::max(1, static_cast<int>(part * picture.report.samples_mean)), 0);
        uniform2 += std::pow(picture_error(uniform.frame, many.frame).stokes_rms, 2) / 3;
      }
      CHECK(off < 0.67 * std::sqrt(uniform2));
    }
  }
}

TEST_CASE("an error out of reach is told, and nothing but the samples is off") {
  auto setup = test::load_gallery("founding/fig7_camera2.pov", "");
  RenderOptions options;
  options.most_samples = 11;
  const auto picture = take(setup, 1, 1e-6, 64, options);
  CHECK(!picture.report.sample_error_kept);
  CHECK(picture.report.sample_error > 1e-6);
  for (const std::uint32_t n : picture.frame.samples) CHECK(n <= 11);
}

TEST_CASE("whatever the tiles, further samples go to the same pixels") {
  auto setup = test::load_gallery("founding/fig5_active.pov", "400:700:100");
  RenderOptions small;
  small.tile_seconds = 1e-4;
  const auto a = take(setup, 1, 0.01), b = take(setup, 1, 0.01, 64, small);
  CHECK(b.report.tiles > a.report.tiles);
  CHECK(same_bits(a.frame, b.frame));
}

TEST_CASE("what an unfinished render has kept goes on to the same bits") {
  auto setup = test::load_gallery("founding/fig5_active.pov", "400:700:100");
  const std::string path = (std::filesystem::temp_directory_path() / ("nicol adaptive " + std::to_string(getpid()) + ".part")).string();
  const auto whole = take(setup, 1, 0.005);
  REQUIRE(whole.report.passes > 3);
  std::string note;
  auto journal = Journal::open(path, "picture", false, note);
  std::atomic<bool> cancel{false};
  RenderOptions options;
  options.tile_seconds = 1e-4;
  options.journal = journal.get();
  options.journal_after_seconds = 0;
  options.cancel = &cancel;
  int told = 0;
  for (const int stop_at : {20, 60}) {  // twice, the second time among the passes
    told = 0;
    cancel = false;
    options.progress = [&](const Progress&) { cancel = ++told > stop_at; };
    CHECK(take(setup, 1, 0.005, 64, options).report.interrupted);
    journal.reset();
    journal = Journal::open(path, "picture", true, note);
    CHECK(note.empty());
    options.journal = journal.get();
  }
  options.progress = nullptr;
  cancel = false;
  const auto rest = take(setup, 1, 0.005, 64, options);
  CHECK(rest.report.tiles_found > 0);
  CHECK(same_bits(whole.frame, rest.frame));
  CHECK(rest.report.segments == whole.report.segments);
  journal->remove();
  CHECK(!std::filesystem::exists(path));
}
