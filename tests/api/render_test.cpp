// Renderings: the bits of the command line, callbacks, parts, errors of the picture.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "scenes.hpp"

using namespace api_test;
namespace fs = std::filesystem;

namespace {

// A folder that goes away.
struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "nicol_api_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  fs::path path;
};

int run(const std::string& command) { return std::system(command.c_str()); }

// Not released when the program ends: OpenCL may be gone by then.
nicol::Context& context() {
  static nicol::Context& all = *new nicol::Context;
  return all;
}

// A picture put together of its tiles.
struct Tiles {
  std::vector<float> stokes, rgb;
  std::size_t calls = 0;
  bool take(const nicol::Tile& tile) {
    const std::size_t plane = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height), count = tile.pixels.size();
    const std::size_t rows = 4 * tile.wavelengths_nm.size();
    stokes.resize(rows * plane);
    rgb.resize(3 * plane);
    for (std::size_t i = 0; i < count; ++i) {
      const auto p = static_cast<std::size_t>(tile.pixels[i]);
      for (std::size_t row = 0; row < rows; ++row) stokes[row * plane + p] = tile.stokes[row * count + i];
      for (std::size_t k = 0; k < 3; ++k) rgb[k * plane + p] = tile.linear_srgb[3 * i + k];
    }
    ++calls;
    return true;
  }
};

}  // namespace

TEST_CASE("the bits of the command line") {
  const Folder folder;
  const std::string scene = APP_TESTS "/cube.pov", theirs = folder / "theirs.exr", ours = folder / "ours.exr";
  REQUIRE(run(std::string(NICOL_PROGRAM) + " render -q --no-budget --width 40 --height 30 -o " + theirs + " " + scene) == 0);
  nicol::Scene::load_file(context(), scene, sized(40, 30)).render().write(ours);
  CHECK(run(std::string(COMPARE_EXR) + " " + theirs + " " + ours) == 0);
}

TEST_CASE("tiles make the picture, and progress goes from 0 to 1") {
  Tiles tiles;
  double before = 0;
  bool forward = true;
  nicol::RenderOptions options;
  options.tile = [&](const nicol::Tile& tile) { return tiles.take(tile); };
  options.progress = [&](double fraction, double seconds, double) {
    forward = forward && fraction >= before && fraction <= 1 && seconds >= 0;
    before = fraction;
    return true;
  };
  const nicol::Picture picture = cube_scene(context()).render(options);
  CHECK(tiles.calls > 0);
  CHECK(forward);
  CHECK(before == doctest::Approx(1));
  CHECK(!picture.cancelled());
  CHECK(picture.width() == 40);
  CHECK(picture.height() == 30);
  CHECK(picture.wavelengths_nm().size() == 3);
  CHECK(same(picture.stokes(), {tiles.stokes.data(), tiles.stokes.size()}));
  CHECK(same(picture.linear_srgb(), {tiles.rgb.data(), tiles.rgb.size()}));
  CHECK(picture.stokes(0, 1)[0] > 0);
  CHECK(picture.xyz()[picture.plane_size()] == doctest::Approx(0.4).epsilon(1e-5));
  CHECK(picture.plane(NICOL_PLANE_COVERAGE)[7] == 1);
  CHECK(picture.plane(NICOL_PLANE_SAMPLES)[7] == 1);
  CHECK_THROWS_AS(picture.plane(NICOL_PLANE_ERROR_TOTAL), nicol::Error);
  const nicol_report report = picture.report();
  CHECK(report.segments > 1200);
  CHECK(report.interrupted == 0);
  CHECK(report.mean_radiance > 0);
}

TEST_CASE("declared values and wavelengths come from outside") {
  nicol::SceneOptions options = sized(40, 30);
  options.declares = {{"Sky", 0.25}};
  options.wavelengths_nm = {600, 500.125};
  const nicol::Picture picture = nicol::Scene::load_text(context(), "cube.pov", cube, options).render();
  CHECK(picture.xyz()[picture.plane_size()] == doctest::Approx(0.25).epsilon(1e-5));
  CHECK(picture.wavelengths_nm()[0] == 500.125);
  CHECK(picture.wavelengths_nm()[1] == 600);
}

TEST_CASE("a tile callback that stops leaves the rows so far") {
  std::size_t pixels = 0;
  nicol::RenderOptions options;
  options.tile = [&](const nicol::Tile& tile) {
    pixels += tile.pixels.size();
    return pixels < tile.pixels.size() + static_cast<std::size_t>(4 * tile.width);
  };
  const nicol::Scene scene = cube_scene(context(), 800, 800);
  const nicol::Picture picture = scene.render(options);
  CHECK(picture.cancelled());
  CHECK(picture.report().interrupted == 1);
  const auto covered = picture.plane(NICOL_PLANE_COVERAGE), green = picture.stokes(0, 1);
  std::size_t there = 0, wrong = 0;
  for (std::size_t p = 0; p < covered.size(); ++p) {
    there += covered[p] == 1 ? 1 : 0;
    wrong += (covered[p] == 1) == (green[p] > 0) ? 0 : 1;
  }
  CHECK(there >= 800);
  CHECK(there < covered.size());
  CHECK(wrong == 0);
}

TEST_CASE("a progress or cancel callback stops too; before anything is rendered there is no picture") {
  const nicol::Scene scene = cube_scene(context());
  const auto stopped = [&](const nicol::RenderOptions& options) {
    try {
      return scene.render(options).cancelled();
    } catch (const nicol::Error& error) {
      return error.status() == NICOL_CANCELLED;
    }
  };
  nicol::RenderOptions by_progress, by_cancel;
  by_progress.progress = [](double, double, double) { return false; };
  by_cancel.cancel = [] { return true; };
  CHECK(stopped(by_progress));
  CHECK(stopped(by_cancel));
  CHECK_THROWS_AS(scene.render(by_cancel), nicol::Error);
}

TEST_CASE("what a callback throws comes back, and the context goes on") {
  const nicol::Scene scene = cube_scene(context());
  struct Odd {
    int number;
  };
  nicol::RenderOptions options;
  options.tile = [](const nicol::Tile&) -> bool { throw Odd{7}; };
  try {
    scene.render(options);
    FAIL("nothing was thrown");
  } catch (const Odd& odd) {
    CHECK(odd.number == 7);
  }
  CHECK(scene.render().report().interrupted == 0);
}

TEST_CASE("parts and windows are those of the whole; parts merge to it") {
  const Folder folder;
  const nicol::Scene scene = cube_scene(context());
  const nicol::Picture whole = scene.render();
  nicol::RenderOptions options;
  options.part_count = 2;
  std::vector<std::string> paths;
  for (int part = 1; part <= 2; ++part) {
    options.part = part;
    paths.push_back(folder / (part == 1 ? "a.exr" : "b.exr"));
    const nicol::Picture made = scene.render(options);
    made.write(paths.back());
    CHECK_THROWS_AS(made.write(folder / "part.png"), nicol::Error);
  }
  CHECK(same(context().merge(paths).stokes(), whole.stokes()));
  CHECK_THROWS_AS(context().merge({paths[0]}), nicol::Error);
  const nicol::Picture half = context().merge({paths[0]}, true);
  CHECK_THROWS_AS(half.report(), nicol::Error);
  nicol::RenderOptions window;
  window.rows = {0, 1};
  window.columns = {3, 5};
  Tiles tiles;
  window.tile = [&](const nicol::Tile& tile) { return tiles.take(tile); };
  const nicol::Picture cut = scene.render(window);
  CHECK(same(cut.stokes(), {tiles.stokes.data(), tiles.stokes.size()}));
  std::size_t covered = 0, wrong = 0;
  for (std::size_t p = 0; p < cut.plane_size(); ++p) {
    const bool in = p >= 3 && p < 8;
    covered += cut.plane(NICOL_PLANE_COVERAGE)[p] == 1 ? 1 : 0;
    wrong += cut.stokes(0, 2)[p] == (in ? whole.stokes(0, 2)[p] : 0) ? 0 : 1;
  }
  CHECK(covered == 5);
  CHECK(wrong == 0);
}

TEST_CASE("a journal that cannot be written is told once, as a warning") {
  std::vector<std::string> notes, warnings;
  nicol::ContextOptions logged;
  logged.log = [&](nicol_severity severity, std::string_view text) { (severity == NICOL_WARNING ? warnings : notes).emplace_back(text); };
  nicol::RenderOptions options;
  options.journal = "/no/such/folder/journal";
  options.resume = true;
  CHECK(!cube_scene(nicol::Context(logged)).render(options).cancelled());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find(options.journal) != std::string::npos);
  for (const std::string& note : notes) CHECK_MESSAGE(note.find("tiles") == std::string::npos, note);
}

TEST_CASE("error budget and error bound, when asked for; a window that leaves nothing out is the whole picture") {
  const nicol::Scene scene = cube_scene(context());
  nicol::RenderOptions options;
  options.rows = {0, 30};
  options.columns = {0, 40};
  options.first_wavelength_nm = 1;
  options.last_wavelength_nm = 1e4;
  options.want_error_bound = options.want_error_budget = true;
  const nicol::Picture picture = scene.render(options);
  const auto budget = picture.budget();
  CHECK(budget.size() >= 4);
  CHECK(std::isfinite(picture.budget_rms()));
  const auto total = picture.plane(NICOL_PLANE_ERROR_TOTAL), cut_off = picture.plane(NICOL_PLANE_ERROR_CUT_OFF),
             sampling = picture.plane(NICOL_PLANE_ERROR_SAMPLING), rounding = picture.plane(NICOL_PLANE_ERROR_ROUNDING);
  std::size_t wrong = 0;
  for (std::size_t p = 0; p < total.size(); ++p) {
    const float sum = cut_off[p] + sampling[p] + rounding[p];
    wrong += std::isnan(sum) || std::abs(total[p] - sum) <= 1e-5f * sum ? 0 : 1;
  }
  CHECK(wrong == 0);
  const Folder folder;
  picture.write_error_map(folder / "map.exr");
  CHECK(fs::file_size(folder / "map.exr") > 0);
  const nicol::Picture plain = scene.render();
  CHECK(plain.budget().empty());
  CHECK_THROWS_AS(plain.budget_rms(), nicol::Error);
}

TEST_CASE("settings for an error are chosen, and the scene stays as it is") {
  nicol::SceneOptions options = sized(24, 18);
  options.error = 0.05;
  const nicol::Scene scene = nicol::Scene::load_text(context(), "cube.pov", cube, options);
  const nicol::Picture picture = scene.render();
  const nicol_chosen chosen = picture.chosen();
  CHECK(chosen.error == 0.05);
  CHECK(std::string(chosen.text).find("adc_bailout") != std::string::npos);
  CHECK(scene.wavelengths_nm().size() == 3);
  CHECK_THROWS_AS(cube_scene(context()).render().chosen(), nicol::Error);
}

TEST_CASE("two threads, two scenes, one context") {
  nicol::SceneOptions dim = sized(40, 30);
  dim.declares = {{"Sky", 0.125}};
  const nicol::Scene scenes[] = {cube_scene(context()), nicol::Scene::load_text(context(), "cube.pov", cube, dim)};
  const nicol::Picture alone[] = {scenes[0].render(), scenes[1].render()};
  const Folder folder;
  bool right[2] = {true, true};
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i)
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < 3; ++turn) {
        const nicol::Scene again = nicol::Scene::load_text(context(), "cube.pov", cube, i == 0 ? sized(40, 30) : dim);
        const nicol::Picture made = again.render();
        made.write(folder / (std::to_string(i) + ".exr"));
        right[i] = right[i] && same(made.stokes(), alone[i].stokes()) && same(scenes[i].render().xyz(), alone[i].xyz());
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 2; ++i) {
    CHECK(right[i]);
    const std::string written = folder / "alone.exr";
    alone[i].write(written);
    CHECK(run(std::string(COMPARE_EXR) + " " + written + " " + (folder / (std::to_string(i) + ".exr"))) == 0);
  }
}

TEST_CASE("a picture outlives its scene and its context") {
  std::optional<nicol::Picture> picture;
  {
    const nicol::Context own;
    picture.emplace(cube_scene(own, 8, 8).render());
  }
  CHECK(picture->xyz()[picture->plane_size()] == doctest::Approx(0.4).epsilon(1e-5));
  CHECK(!picture->notes().empty());
}
