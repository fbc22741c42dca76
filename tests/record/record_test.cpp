// Scenes small enough to say by hand what a pixel's light meets.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "tests/record/recorded.hpp"

using namespace nicol;
using test::cells_met;
using test::has_effect;
using test::load_text;

namespace {

// Straight on: a light 20 mm wide at z = 5, seen from z = -10.
const std::string straight_on = R"(
global_settings { mm_per_unit 1 wavelengths { 589.3 } max_trace_level 20 adc_bailout 1e-6 }
background { spectrum { e scale 0.5 } }
polygon { 5, <-10, -10, 5>, <10, -10, 5>, <10, 10, 5>, <-10, 10, 5>, <-10, -10, 5> luminous { spectrum { e } } }
)";
const std::string orthographic = "camera { orthographic location -10*z right 30*x up 30*y look_at 0 }\n";
const std::string glass = " interior { index { constant 1.5 } } ";

double weight_in(const PathRecord& record, int cell) {
  for (const MetCell& met : record.cells)
    if (met.cell == cell) return met.weight;
  return 0;
}
int faces_of(const PathRecord& record, int cell) {
  for (const MetCell& met : record.cells)
    if (met.cell == cell) return met.faces;
  return 0;
}

}  // namespace

TEST_CASE("a plate: each cell with the weight of its heaviest path, each face with its order") {
  const auto plate = load_text(straight_on + orthographic + "box { <-4, -4, 0>, <4, 4, 1>" + glass + "}");
  const PathRecord record = plate.at(0.5, 0.5);
  REQUIRE(cells_met(record) == std::vector<int>{0, 1});
  CHECK(record.cells[0].cell == 0);
  CHECK(record.cells[0].object == -1);
  CHECK(record.cells[1].medium == *plate.scene.objects.at(record.cells[1].object).medium);
  CHECK(weight_in(record, 0) == 1);
  CHECK(std::fabs(weight_in(record, 1) - 0.96) < 1e-12);  // R = (0.5/2.5)^2
  // inside, a path of 0.96 x 0.04^m goes on while that is above 1e-6: m = 0 .. 4
  CHECK(faces_of(record, 0) == 1);
  CHECK(faces_of(record, 1) == 5);
  CHECK(record.faces == 6);
  CHECK(record.deepest == 6);
  CHECK(record.emissions == std::vector<int>{0});
  CHECK(record.sky);  // by reflection
  CHECK(record.polarizers.empty());
  CHECK(record.effects.empty());  // straight on, a face does not polarize
  // all orders: T = (1 - R)/(1 + R), R = 2 x 0.04/1.04
  const double passed = 0.96 / 1.04;
  CHECK(std::fabs(record.stokes[0] / (plate.scene.emissions[0].radiance[0] * (passed + 0.5 * (1 - passed))) - 1) < 1e-6);
}

TEST_CASE("beside the plate: the light alone, and beside that the sky alone") {
  const auto plate = load_text(straight_on + orthographic + "box { <-4, -4, 0>, <4, 4, 1>" + glass + "}");
  const PathRecord light = plate.at(0.7, 0.5), sky = plate.at(0.95, 0.5);
  CHECK(cells_met(light) == std::vector<int>{0});
  CHECK(light.emissions == std::vector<int>{0});
  CHECK_FALSE(light.sky);
  CHECK(light.faces == 0);
  CHECK(cells_met(sky) == std::vector<int>{0});
  CHECK(sky.emissions.empty());
  CHECK(sky.sky);
  CHECK(std::fabs(sky.stokes[0] - plate.scene.sky[0]) <= 1e-15 * plate.scene.sky[0]);
}

TEST_CASE("aslant a face polarizes; between equal media it does not") {
  const auto at = [](const std::string& index) {
    const std::string box = "box { <-4, -4, -1>, <4, 4, 1> rotate 30*y interior { index { constant " + index + " } } }";
    return load_text(straight_on + orthographic + box).at(0.5, 0.5);
  };
  CHECK(at("1.5").effects == std::vector<std::string>{"polarization"});
  CHECK(at("1").effects.empty());
}

TEST_CASE("polarizers: the camera's, free ones and the light's are passed; one that the light does not meet is not") {
  const std::string sheet = "polygon { 5, <-2, -2, 0>, <2, -2, 0>, <2, 2, 0>, <-2, 2, 0>, <-2, -2, 0> ";
  const auto scene = load_text(R"(
global_settings { mm_per_unit 1 wavelengths { 500, 600 } max_trace_level 20 adc_bailout 1e-6 }
background { spectrum { e } }
camera { orthographic location -10*z right 30*x up 30*y look_at 0 polarizer { ideal angle 20 } }
)" + sheet + "translate 6*z luminous { spectrum { e } polarizer { ideal angle 50 } } }\n" +
                               sheet + "polarizer { calcite angle 30 } }\n" +  //
                               sheet + "translate 6*x polarizer { ideal angle 30 } }\n");
  REQUIRE(scene.scene.polarizers.size() == 4);
  const PathRecord middle = scene.at(0.5, 0.5), aside = scene.at(0.7, 0.5), beside = scene.at(0.05, 0.5);
  CHECK(middle.polarizers.size() == 3);
  CHECK(middle.effects == std::vector<std::string>{"polarization", "dispersion", "calcite_polarizers"});
  CHECK(middle.emissions == std::vector<int>{0});
  CHECK(aside.polarizers.size() == 2);
  CHECK(aside.effects == std::vector<std::string>{"polarization"});
  CHECK(aside.sky);
  CHECK(beside.polarizers == std::vector<int>{*scene.scene.camera.polarizer});
  CHECK(beside.cells.front().weight == 1);  // as heavy as behind the camera's polarizer
}

TEST_CASE("solids in solids, and solids that touch") {
  const std::string inner = "box { <-1, -1, 0>, <1, 1, 1> interior { index { constant 1.7 } rotation { constant 20 } } }";
  const auto nested = load_text(straight_on + orthographic + "box { <-4, -4, -1>, <4, 4, 3>" + glass + "} " + inner);
  const PathRecord through_both = nested.at(0.5, 0.5), through_one = nested.at(0.6, 0.5);
  CHECK(cells_met(through_both) == std::vector<int>{0, 1, 2});
  CHECK(has_effect(through_both, "rotation"));
  CHECK(cells_met(through_one) == std::vector<int>{0, 1});
  CHECK_FALSE(has_effect(through_one, "rotation"));

  const std::string two = straight_on + orthographic + "box { <-4, -4, 0>, <4, 4, 1>" + glass +  //
                          "} box { <-4, -4, 1>, <4, 4, 2>" + glass;
  const auto one = load_text(straight_on + orthographic + "box { <-4, -4, 0>, <4, 4, 2>" + glass + "}");
  const PathRecord across = load_text(two + "}").at(0.5, 0.5);
  const PathRecord joined = load_text(two + "optical_contact on }").at(0.5, 0.5);
  CHECK(cells_met(across) == std::vector<int>{0, 1, 2});
  CHECK(cells_met(joined) == std::vector<int>{0, 1, 2});
  CHECK(across.faces > joined.faces);  // two interfaces against one that does nothing
  CHECK(std::fabs(joined.stokes[0] - one.at(0.5, 0.5).stokes[0]) < 1e-6 * joined.stokes[0]);
}

TEST_CASE("a camera inside a solid: what leaves for the sky at once has been in the surroundings") {
  const std::string camera = "camera { location 0.5*z direction z right 0.1*x up 0.1*y }\n";
  const std::string calcite = "interior { ordinary { constant 1.66 } extraordinary { constant 1.49 } optic_axis <1, 0, 1> }";
  for (const std::string& interior : {glass, calcite}) {
    const auto inside = load_text("global_settings { mm_per_unit 1 wavelengths { 589.3 } } background { spectrum { e } }" +
                                  camera + "box { <-4, -4, 0>, <4, 4, 1>" + interior + "}");
    const PathRecord record = inside.at(0.5, 0.5);
    CHECK(record.cells.front().cell == 1);
    CHECK(cells_met(record) == std::vector<int>{0, 1});
    CHECK(weight_in(record, 0) > 0.4);
    CHECK(weight_in(record, 0) < weight_in(record, 1));
    CHECK(weight_in(record, 1) <= 1 + 1e-12);
    CHECK(faces_of(record, 0) == 0);
    CHECK(record.sky);
    CHECK(has_effect(record, "birefringence") == (interior == calcite));
  }
}

TEST_CASE("a face that shines outwards only is no light to paths inside") {
  const auto seen = [](const std::string& sided, const std::string& direction) {
    return load_text("global_settings { mm_per_unit 1 wavelengths { 589.3 } } background { spectrum { e } }" + orthographic +
                     "box { <-4, -4, 0>, <4, 4, 1>" + glass + "luminous { spectrum { e } face " + direction + sided + "} }")
        .at(0.5, 0.5);
  };
  CHECK(seen("", "z").emissions == std::vector<int>{0});
  CHECK(seen(" one_sided on ", "z").emissions.empty());
  const PathRecord outside = seen(" one_sided on ", "-z");
  CHECK(outside.emissions == std::vector<int>{0});
  CHECK(outside.faces == 0);
}

TEST_CASE("a pixel or a wavelength that there is not") {
  const auto plate = load_text(straight_on + orthographic);
  CHECK_THROWS_AS(plate.at(1, 0.5), std::out_of_range);
  CHECK_THROWS_AS(plate.at(0.5, -0.1), std::out_of_range);
  CHECK_THROWS_AS(plate.at(0.5, 0.5, 400, 1), std::out_of_range);
}
