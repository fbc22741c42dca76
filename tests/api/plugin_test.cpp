// Plugins loaded by a context are there for its scenes, and for no other's.
#include <doctest/doctest.h>

#include <cmath>

#include "scenes.hpp"

using namespace api_test;

namespace {

std::string with_index(const std::string& index) {
  std::string text = cube;
  const std::string plain = "ior 1.5";
  return text.replace(text.find(plain), plain.size(), index);
}

nicol::Scene glass(const nicol::Context& context) {
  return nicol::Scene::load_text(context, "cube.pov", with_index("index { plugin { \"constant_index\" n 1.5 } }"), sized(40, 30));
}

}  // namespace

TEST_CASE("a plugin that is loaded gives its index") {
  const nicol::Context with, without;
  with.load_plugin(CONSTANT_INDEX);
  CHECK(!glass(without).whole());
  const nicol::Scene scene = glass(with);
  REQUIRE_MESSAGE(scene.whole(), nicol_last_error());
  const nicol::Picture made = scene.render(), plain = cube_scene(with).render();
  const auto a = made.stokes(), b = plain.stokes();
  double worst = 0;
  for (std::size_t i = 0; i < b.size(); ++i) worst = std::max(worst, static_cast<double>(std::abs(a[i] - b[i])));
  CHECK(worst <= 1e-5 * made.report().mean_radiance);
}

TEST_CASE("a plugin that cannot be loaded says so") {
  const nicol::Context context;
  for (const char* path : {"/nowhere/plugin.so", APP_TESTS "/cube.pov"}) {
    CHECK(nicol_load_plugin(context.get(), path) == NICOL_ERROR_PLUGIN);
    CHECK_MESSAGE(std::string(nicol_last_error()).find(path) != std::string::npos, nicol_last_error());
  }
  CHECK(cube_scene(context).whole());
}
