// Scenes: reading, diagnostics with places, include files handed in, explanation.
#include <doctest/doctest.h>

#include <algorithm>

#include "scenes.hpp"

using namespace api_test;

TEST_CASE("versions and statuses") {
  CHECK(nicol_abi_version() == NICOL_ABI_VERSION);
  CHECK(nicol::version().find('.') != std::string::npos);
  CHECK(std::string(nicol_status_text(NICOL_OK)) == "done");
  CHECK(std::string(nicol_status_text(NICOL_ERROR_INTERNAL)) != "unknown status");
  CHECK(std::string(nicol_status_text(-7)) == "unknown status");
}

TEST_CASE("the device of a context is one of those that there are") {
  const auto devices = nicol::devices();
  REQUIRE(!devices.empty());
  const nicol_device_info used = nicol::Context().device();
  CHECK(std::any_of(devices.begin(), devices.end(), [&](const auto& d) { return d.index == used.index && std::string(d.name) == used.name; }));
  CHECK(used.compute_units > 0);
  nicol::ContextOptions wrong;
  wrong.device = "no such device";
  try {
    nicol::Context{wrong};
    FAIL("a device that is not there was opened");
  } catch (const nicol::Error& error) {
    CHECK(error.status() == NICOL_ERROR_DEVICE);
    CHECK(std::string(error.what()).find("no such device") != std::string::npos);
  }
}

TEST_CASE("errors of a scene have places") {
  const nicol::Scene scene = nicol::Scene::load_text(nicol::Context(), "wrong.pov", "#version 3.7;\nbox { <0, 0, 0>, <1, 1, Q> }\nsphere { 0, }\n");
  CHECK(!scene.whole());
  const auto all = scene.diagnostics();
  REQUIRE(all.size() >= 2);
  CHECK(all[0].severity == NICOL_ERROR);
  CHECK(all[0].file == "wrong.pov");
  CHECK(all[0].line == 2);
  CHECK(all[0].column > 1);
  CHECK(all[0].text.find(all[0].message.substr(0, 10)) != std::string::npos);
  CHECK(all[0].text.find('^') != std::string::npos);
  CHECK_THROWS_AS(scene.explanation(), nicol::Error);
  CHECK_THROWS_AS(scene.render(), nicol::Error);
  CHECK(scene.features().empty());
}

TEST_CASE("a whole scene tells its files, wavelengths and features") {
  const nicol::Scene scene = cube_scene(nicol::Context());
  REQUIRE(scene.whole());
  CHECK(scene.files().front() == "cube.pov");
  const auto lambda = scene.wavelengths_nm();
  CHECK(std::vector<double>(lambda.begin(), lambda.end()) == std::vector<double>{450, 550, 650});
  const auto features = scene.features();
  CHECK(std::any_of(features.begin(), features.end(), [](const auto& f) { return !f.on; }));
  for (const auto& feature : features) CHECK_MESSAGE(scene.explanation().find(feature.reason) != std::string::npos, feature.name);
  CHECK(scene.explanation().find("left out:") != std::string::npos);
}

TEST_CASE("include files come from a callback first, then from folders") {
  std::vector<std::string> asked;
  nicol::SceneOptions options = sized(8, 8);
  options.include = [&](std::string_view name) -> std::optional<std::string> {
    asked.emplace_back(name);
    if (name == "cube.inc") return cube;
    return std::nullopt;
  };
  const std::string text = "#include \"units.inc\"\n#include \"cube.inc\"\n";
  const nicol::Scene scene = nicol::Scene::load_text(nicol::Context(), "main.pov", text, options);
  CHECK(scene.whole());
  CHECK(asked == std::vector<std::string>{"units.inc", "cube.inc"});
  const auto files = scene.files();
  CHECK(std::find(files.begin(), files.end(), "cube.inc") != files.end());
  CHECK(std::any_of(files.begin(), files.end(), [](const std::string& f) { return f.find("include/units.inc") != std::string::npos; }));
}

TEST_CASE("what an include callback throws comes back") {
  struct Odd {};
  nicol::SceneOptions options;
  options.include = [](std::string_view) -> std::optional<std::string> { throw Odd(); };
  CHECK_THROWS_AS(nicol::Scene::load_text(nicol::Context(), "main.pov", "#include \"a.inc\"", options), Odd);
}

TEST_CASE("#debug goes to the log") {
  std::string told;
  nicol::ContextOptions options;
  options.log = [&](nicol_severity severity, std::string_view text) {
    if (severity == NICOL_NOTE) told += text;
  };
  nicol::Scene::load_text(nicol::Context(options), "told.pov", "#debug \"seen\"");
  CHECK(told.find("seen") != std::string::npos);
}

TEST_CASE("a file that cannot be read is no scene") {
  try {
    nicol::Scene::load_file(nicol::Context(), "/nowhere/scene.pov");
    FAIL("read");
  } catch (const nicol::Error& error) {
    CHECK(error.status() == NICOL_ERROR_INPUT);
    CHECK(std::string(error.what()).find("/nowhere/scene.pov") != std::string::npos);
  }
}
