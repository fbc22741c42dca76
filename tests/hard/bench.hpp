// Hard scenes, and the eight ways in which each is rendered: float and double, 1 and 8 lanes, generic and specialised.
// Generic: the kernels compiled by the C++ compiler, read in full precision. Specialised: compiled by OpenCL for the
// device with the scene's effects baked in; what the picture's storage as float takes (2^-24) is not counted as an
// error.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "host/opencl/render.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"
#include "tests/hard/table.hpp"
#include "tests/kernels/test_scene.hpp"
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

namespace nicol::hard {

using test::Kernels;
using test::TestScene;

// Seen by one pixel at one wavelength, in the picture's axes.
struct Seen {
  double s[4] = {0, 0, 0, 0};
  double cut_off = 0;
};

// One ray; `right` shows right in the picture.
struct Look {
  Vec3 from, along;
  Vec3 right{1, 0, 0};
  double pixel_mm = 1e-3;
};

// A scene that can be rendered: right-handed world millimetres.
struct Stage {
  Scene scene;
  Geometry geometry;
};
// From the text of a scene without a camera, wavelengths or settings (right-handed: z is turned). Throws what is
// wrong with it.
Stage stage_of(const std::string& text, const std::vector<double>& lambda_nm, const Vec3& camera);
Stage stage_of(TestScene scene);

struct Way {
  bool real_double = false;
  int lanes = 1;
  bool specialised = false;
  int column() const { return 4 * real_double + 2 * (lanes == 8) + specialised; }
  double epsilon() const { return real_double ? 0x1p-52 : 0x1p-23; }
  const Kernels& native() const;  // of the same precision and lanes
};
std::vector<Way> all_ways();

// One case, one way.
class Bench {
 public:
  Bench(const Way& way, std::string name, Table& table) : way_(way), name_(std::move(name)), table_(table) {}
  const Way& way() const { return way_; }
  double epsilon() const { return way_.epsilon(); }
  // What the ray brings, at each wavelength. Holds the device's counters to 0.
  std::vector<Seen> look(const Stage& stage, const Look& look);
  // A picture of `width` pixels side by side around the ray, pixel by pixel, then by wavelength.
  std::vector<Seen> look(const Stage& stage, const Look& look, int width, int height = 1);
  void hold(const std::string& quantity, const std::string& reason, double bound, double error);
  // The same for values that came out of a picture: the rounding of its terms, `size` in all, does not count.
  void hold_seen(const std::string& quantity, const std::string& reason, double bound, double seen, double expected,
                 double size);
  double tile_seconds = 0.03;   // of pictures on the device

 private:
  Way way_;
  std::string name_;
  Table& table_;
};

struct Case {
  std::string group, name;
  std::function<void(Bench&)> run;
};

std::vector<Case> face_cases();
std::vector<Case> crystal_cases();
std::vector<Case> solid_cases();
std::vector<Case> path_cases();
std::vector<Case> sweep_cases();
std::vector<Case> repeat_cases();

// What a picture with everything in it comes to, in tiles of that many seconds: 16 hexadecimal digits.
std::string picture_digest(const Way& way, double tile_seconds);

}  // namespace nicol::hard
