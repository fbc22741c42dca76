#include "tests/render/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/pack.hpp"

namespace nicol::test {

Setup load_gallery(const std::string& file, const std::string& wavelengths) {
  engine::SceneOptions options;
  options.width = options.height = 64;
  options.wavelengths = wavelengths;
  Setup setup;
  setup.loaded = engine::load_scene(NICOL_TEST_FOLDER "/../../scenes/" + file, options);
  if (!setup.loaded) throw std::runtime_error(file + " does not load");
  setup.device = open_device("");
  return setup;
}

Setup load(const std::string& file) {
  engine::SceneOptions options;
  options.width = options.height = 16;
  Setup setup;
  setup.loaded = engine::load_scene(NICOL_TEST_FOLDER "/" + file, options);
  if (!setup.loaded) throw std::runtime_error(file + " does not load");
  setup.device = open_device("");
  return setup;
}

Picture take(const Setup& setup, std::uint32_t features, const KernelOptions& kernel, int size) {
  RenderOptions options;
  options.kernel = kernel;
  const Scene& scene = setup.loaded->scene;
  const PackedScene packed =
      pack(scene, setup.loaded->geometry, features, size, size, lanes_on(*setup.device, kernel));
  Picture picture;
  picture.frame = render(*setup.device, packed, scene.lambda_nm, scene.weight_nm, options, picture.report);
  return picture;
}

double difference(const Picture& a, const Picture& b) {
  const auto& x = a.frame.stokes;
  const auto& y = b.frame.stokes;
  if (x.size() != y.size()) return INFINITY;
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isnan(x[i]) || std::isnan(y[i])) return INFINITY;
    largest = std::max({largest, std::fabs(double(x[i])), std::fabs(double(y[i]))});
    apart = std::max(apart, std::fabs(double(x[i]) - double(y[i])));
  }
  return largest > 0 ? apart / largest : 0;
}

}  // namespace nicol::test
