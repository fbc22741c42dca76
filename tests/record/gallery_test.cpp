// The gallery's scenes: what the light of a pixel meets there, and the effects that it shows.
#include <doctest/doctest.h>

#include <algorithm>

#include "host/effects.hpp"
#include "tests/record/recorded.hpp"

using namespace nicol;
using test::cells_met;
using test::has_effect;
using test::load_gallery;

TEST_CASE("the founding cube turns light; beside it the sky has come straight") {
  const auto cube = load_gallery("founding/fig5_active.pov");
  const PathRecord middle = cube.at(0.5, 0.5), beside = cube.at(0.02, 0.02);
  CHECK(cells_met(middle) == std::vector<int>{0, 1});
  for (const char* name : {"polarization", "rotation", "rotatory_dispersion", "dispersion", "calcite_polarizers"})
    CHECK(has_effect(middle, name));
  CHECK_FALSE(has_effect(middle, "birefringence"));
  CHECK(middle.emissions == std::vector<int>{0});
  CHECK(std::count(middle.polarizers.begin(), middle.polarizers.end(), *cube.scene.camera.polarizer) == 1);
  CHECK(middle.faces > 2);
  CHECK(middle.deepest <= cube.scene.settings.max_trace_level);

  CHECK(cells_met(beside) == std::vector<int>{0});
  CHECK(beside.sky);
  CHECK(beside.emissions.empty());
  CHECK_FALSE(has_effect(beside, "rotation"));
  CHECK(beside.polarizers == std::vector<int>{*cube.scene.camera.polarizer});
  const PathRecord inactive = load_gallery("founding/fig5_inactive.pov").at(0.5, 0.5);
  CHECK_FALSE(has_effect(inactive, "rotation"));
}

TEST_CASE("crystals: two waves apart, two waves together, colours by direction") {
  const PathRecord rhomb = load_gallery("birefringence/calcite_rhomb.pov", {550}).at(0.5, 0.5);
  CHECK(has_effect(rhomb, "birefringence"));
  CHECK_FALSE(has_effect(rhomb, "coherence"));  // the images are further apart than a pixel
  const PathRecord figure = load_gallery("birefringence/biaxial_figure.pov").at(0.4, 0.45);
  CHECK(has_effect(figure, "birefringence"));
  CHECK(has_effect(figure, "coherence"));
  CHECK_FALSE(has_effect(figure, "conical_rays"));
  for (const char* file : {"gems/ruby.pov", "pleochroism/tourmaline.pov"}) {
    CAPTURE(file);
    const auto scene = load_gallery(file, {550});
    const PathRecord record = scene.at(0.5, 0.5);
    CHECK(has_effect(record, "absorption"));
    CHECK(has_effect(record, "pleochroism"));
    CHECK(has_effect(record, "birefringence"));
    CHECK_FALSE(has_effect(record, "rotation"));
  }
}

TEST_CASE("conical rays only where a wave normal meets a binormal") {
  CHECK(has_effect(load_gallery("conical/aragonite.pov").at(0.5, 0.5), "conical_rays"));
  const auto plate = test::load_text(R"(
global_settings { mm_per_unit 1 wavelengths { 589.3 } coherence off conical_rays 3 conical_spread 0.5 }
background { spectrum { e } }
camera { location -10*z direction z right x up y }
box { <-40, -40, 0>, <40, 40, 1>
  interior { alpha { constant 1.53 } beta { constant 1.681 } gamma { constant 1.6855 } optic_frame { alpha x gamma y } } }
)");
  // 15.4 degrees from the middle in the plane of alpha and gamma, as in birefringence/biaxial_figure.pov
  CHECK(has_effect(plate.at(0.5 + 0.2755, 0.5), "conical_rays"));
  CHECK_FALSE(has_effect(plate.at(0.5, 0.5), "conical_rays"));
  CHECK_FALSE(has_effect(plate.at(0.5, 0.5 + 0.2755), "conical_rays"));
}

TEST_CASE("every pixel of every kind of scene: effects are the scene's, in its order; weights and faces hold together") {
  for (const char* file : {"founding/fig8_corner.pov", "birefringence/calcite_twin.pov", "instruments/wollaston.pov",
                           "gems/zircon.pov", "activity/biquartz.pov", "comparison/glass_cube.pov",
                           "conventions/handedness_behind.pov"}) {
    CAPTURE(file);
    const auto scene = load_gallery(file, {450, 650});
    std::vector<std::string> all;
    for (const Effect& effect : effects_of(scene.scene)) all.push_back(effect.name);
    for (int pixel = 0; pixel < 36; ++pixel) {
      CAPTURE(pixel);
      const PathRecord record = scene.at((pixel % 6 + 0.5) / 6, (pixel / 6 + 0.5) / 6, 30, pixel % 2);
      std::vector<std::string> kept;
      for (const std::string& name : all)
        if (has_effect(record, name)) kept.push_back(name);
      CHECK(record.effects == kept);
      REQUIRE_FALSE(record.cells.empty());
      CHECK(record.cells.front().cell == scene.geometry.camera_cell);
      int faces = 0;
      for (const MetCell& met : record.cells) {
        CHECK(met.weight > 0);
        CHECK(met.weight <= 1 + 1e-12);
        CHECK(met.medium == scene.geometry.cells.at(met.cell).medium);
        faces += met.faces;
      }
      CHECK(record.faces == faces);
      CHECK(record.deepest <= scene.scene.settings.max_trace_level);
      CHECK(std::is_sorted(record.polarizers.begin(), record.polarizers.end()));
      CHECK(std::is_sorted(record.emissions.begin(), record.emissions.end()));
    }
  }
}
