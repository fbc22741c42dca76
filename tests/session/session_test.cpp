// Sessions as a person has them, on the OpenCL device: pictures get finer, follow the controls, and are read again when files change.
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/engine/loaded_scene.hpp"
#include "host/app/preview_command.hpp"
#include "host/output/frame.hpp"
#include "host/preview/session.hpp"

namespace nicol::preview {
namespace {

namespace fs = std::filesystem;

const std::string scenes = SCENES_FOLDER;

// A session whose turns are taken when there is news, as a window does.
class Driven {
 public:
  explicit Driven(const app::PreviewCommand& command)
      : session(app::preview_session(command), [this] {
          {
            const std::lock_guard<std::mutex> held(lock_);
            ++news_;
          }
          told_.notify_all();
        }) {}

  // Whether it came true in time.
  template <class Is>
  bool until(Is is, double seconds = 120) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    std::uint64_t seen = 0;
    for (;;) {
      session.update();
      if (is(session)) return true;
      if (std::chrono::steady_clock::now() > end) return false;
      std::unique_lock<std::mutex> held(lock_);
      told_.wait_for(held, std::chrono::milliseconds(100), [&] { return news_ != seen; });
      seen = news_;
    }
  }
  bool until_done() {
    session.update();
    return until([](Session& s) { return s.pictures_done(); });
  }

 private:
  std::mutex lock_;
  std::condition_variable told_;
  std::uint64_t news_ = 0;

 public:
  Session session;   // last: its threads call the above
};

app::PreviewCommand command_for(const std::string& scene, int width, int height) {
  app::PreviewCommand command;
  command.scene = scene;
  command.options.width = width;
  command.options.height = height;
  command.options.wavelengths = "420:680:130";
  command.options.samples = 1;
  command.size_given = true;
  return command;
}

struct Folder {
  fs::path path = fs::temp_directory_path() / ("nicol_session_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return (path / name).string();
  }
};

// A box of glass on a light, as wide as `side`.
std::string small_scene(const std::string& side) {
  return "#version unofficial 3.7;\n"
         "#include \"side.inc\"\n"
         "global_settings { mm_per_unit 1 max_trace_level 8 adc_bailout 1e-4 }\n"
         "camera { orthographic location <0, 0, -20> right 16*x up 16*y direction z }\n"
         "background { spectrum { d65 scale 0.1 } }\n"
         "polygon { 5, <-9,-9,5>, <9,-9,5>, <9,9,5>, <-9,9,5>, <-9,-9,5> luminous { spectrum { e } } }\n"
         "box { <-" + side + ", -3, 0>, <" + side + ", 3, 3> interior { ior 1.5 } }\n";
}

double mean_of(const Developed& shown) {
  double sum = 0;
  for (const float value : shown.rgb) sum += static_cast<double>(value);
  return sum / static_cast<double>(shown.rgb.size());
}

TEST_CASE("the picture of a session is that of a render") {
  app::PreviewCommand command = command_for(scenes + "/founding/fig5_active.pov", 61, 47);
  Driven driven(command);
  REQUIRE(driven.until_done());
  const PaneStatus& status = driven.session.status(0);
  CHECK(status.failure == "");
  CHECK(status.step == 1);
  CHECK(status.counted_errors == 0);
  CHECK(status.samples == 23);
  CHECK(status.passes == 5);
  CHECK(std::isfinite(status.sample_error));

  std::unique_ptr<engine::LoadedScene> loaded = engine::load_scene(command.scene, command.options);
  REQUIRE(loaded);
  const auto device = open_device("");
  RenderOptions options;
  options.samples = 23;
  RenderReport report;
  const PackedScene packed = pack(loaded->scene, loaded->geometry, loaded->features.mask, 61, 47, lanes_on(*device, options.kernel));
  const Frame frame = render(*device, packed, loaded->scene.lambda_nm, loaded->scene.weight_nm, options, report);
  double brightest = 0, worst = 0;
  for (const float value : frame.stokes) brightest = std::max(brightest, static_cast<double>(std::fabs(value)));
  for (int y = 0; y < 47; ++y)
    for (int x = 0; x < 61; ++x) {
      const auto info = driven.session.pixel(0, x, y);
      REQUIRE(info);
      CHECK(info->samples == 23);
      for (std::size_t w = 0; w < frame.lambda_nm.size(); ++w)
        for (int s = 0; s < 4; ++s)
          worst = std::max(worst, std::fabs(info->stokes[static_cast<std::size_t>(s)][w] -
                                            static_cast<double>(frame.component(s, w)[y * 61 + x])));
    }
  CHECK(worst < 2e-6 * brightest);   // means of means, in float
}

TEST_CASE("controls change the picture, and back") {
  app::PreviewCommand command = command_for(scenes + "/founding/fig5_active.pov", 48, 48);
  Driven driven(command);
  REQUIRE(driven.until_done());
  Session& session = driven.session;
  const std::vector<float> before = session.developed(0).rgb;

  session.controls.analyzer_deg = 90;
  REQUIRE(driven.until_done());
  const double crossed = mean_of(session.developed(0));
  CHECK(crossed != doctest::Approx(mean_of({48, 48, before, true})).epsilon(0.05));

  session.controls.analyzer_deg = 0;
  session.controls.navigation.yaw_rad = 0.3;
  REQUIRE(driven.until_done());
  CHECK(session.developed(0).rgb != before);

  session.controls.navigation = {};
  session.turn_effect(1, false);
  REQUIRE(driven.until_done());
  CHECK(session.status(0).without == std::vector<std::string>{session.status(0).effects.front().name});
  CHECK(session.developed(0).rgb != before);

  session.reset();
  REQUIRE(driven.until_done());
  const std::vector<float>& after = session.developed(0).rgb;
  REQUIRE(after.size() == before.size());
  double worst = 0;
  for (std::size_t i = 0; i < after.size(); ++i) worst = std::max(worst, std::fabs(static_cast<double>(after[i] - before[i])));
  CHECK(worst < 1e-5);
}

TEST_CASE("files that change are read again; errors leave the last good picture") {
  const Folder folder;
  folder.file("side.inc", "// nothing\n");
  const std::string scene = folder.file("a.pov", small_scene("3"));
  Driven driven(command_for(scene, 32, 32));
  Session& session = driven.session;
  REQUIRE(driven.until_done());
  const double narrow = mean_of(session.developed(0));

  folder.file("a.pov", small_scene("7"));
  REQUIRE(driven.until([&](Session& s) { return s.pictures_done() && mean_of(s.developed(0)) != narrow; }, 20));
  const double wide = mean_of(session.developed(0));

  folder.file("side.inc", "\n\nbox { <1, 2 }\n");
  REQUIRE(driven.until([](Session& s) { return s.status(0).stale; }, 20));
  const PaneStatus& status = session.status(0);
  REQUIRE(!status.messages.empty());
  CHECK(status.messages.front().error);
  CHECK(fs::path(status.messages.front().file).filename() == "side.inc");
  CHECK(status.messages.front().line == 3);
  CHECK(status.messages.front().column > 1);
  CHECK(mean_of(session.developed(0)) == wide);

  // As editors save: another file takes the name.
  folder.file("side.new", "// well again\n");
  fs::rename(folder.path / "side.new", folder.path / "side.inc");
  REQUIRE(driven.until([](Session& s) { return !s.status(0).stale; }, 20));
  CHECK(session.status(0).messages.empty());
}

TEST_CASE("a file that was missing is read when it comes") {
  const Folder folder;
  const std::string scene = folder.file("a.pov", small_scene("3"));
  Driven driven(command_for(scene, 16, 16));
  REQUIRE(driven.until([](Session& s) { return s.status(0).stale; }, 20));
  CHECK(driven.session.developed(0).rgb.empty());
  folder.file("side.inc", "// here\n");
  REQUIRE(driven.until([](Session& s) { return s.status(0).step == 1; }, 30));
}

TEST_CASE("two panes: what a change makes, and what it differs by") {
  app::PreviewCommand command = command_for(scenes + "/founding/fig5_active.pov", 40, 40);
  command.right = {"without optical_activity"};
  Driven driven(command);
  Session& session = driven.session;
  session.controls.show_difference = true;
  REQUIRE(driven.until_done());
  CHECK(session.two_renders());
  const Difference* difference = session.difference();
  REQUIRE(difference);
  CHECK(difference->comparable);
  CHECK(difference->largest > 0.1);   // the colours of the active cube
  const auto& effects = session.status(1).effects;
  CHECK(std::none_of(effects.begin(), effects.end(), [](const Effect& e) { return e.name == "rotation"; }));

  command.right = {"real=double"};
  Driven twice(command);
  twice.session.controls.show_difference = true;
  REQUIRE(twice.until_done());
  REQUIRE(twice.session.difference());
  CHECK(twice.session.difference()->largest < 1e-3);
  CHECK(twice.session.status(1).real == "double");
}

TEST_CASE("one scene between polarizers: the right pane shows what arrives at the analyzer") {
  Driven driven(command_for(scenes + "/founding/fig5_active.pov", 40, 40));
  Session& session = driven.session;
  REQUIRE(driven.until([](Session& s) { return s.two_renders() && s.pictures_done(); }));
  CHECK_FALSE(session.compares());
  const auto passed = session.pixel(0, 20, 20), arrives = session.pixel(1, 20, 20);
  REQUIRE(passed);
  REQUIRE(arrives);
  for (std::size_t w = 0; w < passed->lambda_nm.size(); ++w) CHECK(passed->stokes[0][w] < arrives->stokes[0][w]);
  // The plane of polarization has turned by another angle at each wavelength.
  const auto azimuth = [&](std::size_t w) { return std::atan2(arrives->stokes[2][w], arrives->stokes[1][w]) / 2; };
  CHECK(std::fabs(azimuth(0) - azimuth(1)) > 0.2);
}

TEST_CASE("what the light of a pixel met is told") {
  Driven driven(command_for(scenes + "/founding/fig5_active.pov", 40, 40));

  REQUIRE(driven.until_done());
  std::optional<PixelPath> path;
  REQUIRE(driven.until([&](Session& s) { return (path = s.pixel_path(0, 20, 20)).has_value(); }, 20));
  CHECK(std::find(path->effects.begin(), path->effects.end(), "rotation") != path->effects.end());
  CHECK(path->cells.size() >= 2);
}

TEST_CASE("changes of the right pane that cannot be understood are told") {
  app::PreviewCommand command = command_for(scenes + "/founding/fig5_active.pov", 40, 40);
  for (const char* wrong : {"without colour", "error 200%", "Declare=Activity", "samples=0", "wavelengths=700:400:10", "sideways"}) {
    command.right = {wrong};
    CAPTURE(wrong);
    CHECK_THROWS_AS(app::preview_session(command), engine::UsageError);
  }
}

}  // namespace
}  // namespace nicol::preview
