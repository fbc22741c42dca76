// A recording follows the paths that a picture is made of: it gives the picture's own Stokes vectors, each time, from any thread.
#include <doctest/doctest.h>

#include <cmath>
#include <thread>

#include "tests/bench/native.hpp"
#include "tests/record/recorded.hpp"

using namespace nicol;
using test::load_gallery;

namespace {

constexpr int size = 9, stokes_first = 0, components = 8;  // as kernels/abi.h has them

// Stokes vector of a pixel at a wavelength of a picture that the kernels drew, one lane in double.
std::array<double, 4> drawn(const PackedScene& packed, const bench::NativeResult& picture, std::size_t wavelengths, int pixel,
                            std::size_t wavelength) {
  std::array<double, 4> stokes{};
  for (int channel = 0; channel < packed.channels; ++channel) {
    const bool shared = !packed.mixing.empty();
    const double share = shared ? packed.mixing[channel * wavelengths + wavelength] : channel == static_cast<int>(wavelength);
    const double* out = picture.out.data() + (pixel * packed.channels + channel) * components + stokes_first;
    for (int i = 0; i < 4; ++i) stokes[i] += share * out[i];
  }
  return stokes;
}

bool same(const PathRecord& a, const PathRecord& b) {
  bool cells = a.cells.size() == b.cells.size();
  for (std::size_t i = 0; cells && i < a.cells.size(); ++i)
    cells = a.cells[i].cell == b.cells[i].cell && a.cells[i].weight == b.cells[i].weight && a.cells[i].faces == b.cells[i].faces;
  return cells && a.polarizers == b.polarizers && a.emissions == b.emissions && a.sky == b.sky && a.faces == b.faces &&
         a.deepest == b.deepest && a.stokes == b.stokes && a.effects == b.effects;
}

}  // namespace

TEST_CASE("the Stokes vectors of a recording are the picture's") {
  struct Case {
    const char* scene;
    std::vector<double> lambda_nm;
    bool shared;  // one geometry serves all wavelengths
  };
  for (const Case& c : {Case{"founding/fig5_active.pov", {400, 480, 550, 600, 700}, false},
                        Case{"founding/fig7_camera2.pov", {}, false},
                        Case{"comparison/glass_cube.pov", {450, 550, 650}, true},
                        Case{"birefringence/biaxial_figure.pov", {}, false},
                        Case{"conical/aragonite.pov", {}, false},
                        Case{"gems/ruby.pov", {500, 600}, false},
                        Case{"instruments/wollaston.pov", {}, false},
                        Case{"conventions/handedness_behind.pov", {}, false}}) {
    CAPTURE(c.scene);
    const auto loaded = load_gallery(c.scene, c.lambda_nm);
    const PackedScene packed = pack(loaded.scene, loaded.geometry, loaded.features.mask, size, size, 1);
    CHECK(packed.mixing.empty() != c.shared);
    const bench::NativeResult picture = bench::render_native_double(packed);
    const std::size_t wavelengths = loaded.scene.lambda_nm.size();
    double brightest = 0;
    for (int pixel = 0; pixel < size * size; ++pixel) {
      CAPTURE(pixel);
      const std::size_t wavelength = pixel % wavelengths;
      const auto expected = drawn(packed, picture, wavelengths, pixel, wavelength);
      const PathRecord record = record_paths(loaded.scene, loaded.geometry, loaded.features.mask, size, size, pixel % size,
                                             pixel / size, wavelength);
      for (int i = 0; i < 4; ++i) CHECK(std::fabs(record.stokes[i] - expected[i]) <= 1e-12 * expected[0]);
      brightest = std::max(brightest, record.stokes[0]);
      // what brings light has met a light or the sky
      if (record.stokes[0] > 0) CHECK((record.sky || !record.emissions.empty()));
    }
    CHECK(brightest > 0);
  }
}

TEST_CASE("recorded again, and by two threads at once, it is the same") {
  const auto loaded = load_gallery("gems/quartz_cluster.pov", {550});
  constexpr int pixels = 16;
  const auto all = [&] {
    std::vector<PathRecord> records;
    for (int i = 0; i < pixels; ++i) records.push_back(loaded.at(0.2 + 0.04 * i, 0.2 + 0.04 * i, 100));
    return records;
  };
  const std::vector<PathRecord> first = all();
  std::vector<PathRecord> parallel[2];
  std::thread one([&] { parallel[0] = all(); }), two([&] { parallel[1] = all(); });
  one.join();
  two.join();
  int faces = 0;
  for (int i = 0; i < pixels; ++i) {
    CHECK(same(first[i], parallel[0][i]));
    CHECK(same(first[i], parallel[1][i]));
    faces += first[i].faces;
  }
  CHECK(faces > 0);
}
