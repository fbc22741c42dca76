// Fragments that do not build or could not be are refused before any picture, by name, place and numbers.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::string front =
    "global_settings { mm_per_unit 1 }\nbackground { spectrum { e } }\ncamera { location -10*z look_at 0 right x }\n";

std::string sheet(const std::string& plugin) { return front + "disc { 0, -z, 5 polarizer { plugin { " + plugin + " } angle 0 } }"; }
std::string box(const std::string& plugin) { return front + "box { -1, 1 interior { ior 1.5 } surface { plugin { " + plugin + " } } }"; }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("OpenCL C that does not build is told at its own file and line") {
  const std::string told = refusal(sheet("\"broken\""));
  CAPTURE(told);
  CHECK(has(told, "scene.pov:4: plugin 'broken' does not build"));
  CHECK(has(told, "/plugins/broken.cl:3:"));
  CHECK(has(told, "no_such_thing"));
}

TEST_CASE("a function that cannot be called as it must be is the fragment's fault, not the driver's") {
  const std::string file = new_folder("brief") + "/brief";
  write(file + ".json", "{ \"name\": \"brief\", \"version\": \"1\", \"nicol\": 1, \"kind\": \"element\", \"meaning\": \"m\" }");
  write(file + ".cl", "FUNCTION void brief_of(void) {}\nFUNCTION void brief(PRIVATE const ElementIn* in) {}\n");
  const std::string told = refusal(sheet("\"brief\""));
  CAPTURE(told);
  CHECK(has(told, "brief.cl: its function 'brief' is not of the form that kernels/fragment.h asks for: "));
  CHECK(!has(told, "driver"));
}

TEST_CASE("a gain is refused with its size") {
  const std::string told = refusal(sheet("\"gain\" factor 1.016"));
  CAPTURE(told);
  CHECK(has(told, "scene.pov:4: plugin 'gain' gains 3.23 % of the light at 450 nm"));
  CHECK(refusal(sheet("\"gain\" factor 0.9")) == "");
  CHECK(has(refusal(sheet("\"gain\" factor 1.016"), true), "gains 3.23 %"));
}

TEST_CASE("a small gain is a warning") {
  const Read scene = read(sheet("\"gain\" factor 1.0002"));
  REQUIRE(scene.loaded);
  const std::string told = check_fragments(*open_device(""), *scene.loaded->features.fragments, {});
  CAPTURE(told);
  CHECK(has(told, "gains 0.04 %"));
}

TEST_CASE("NaN is refused") { CHECK(has(refusal(sheet("\"gain\" factor -1")), "numbers that are not finite")); }

TEST_CASE("absorption hides no gain") {
  for (const char* absorption : {"", "absorption { constant 0.01 }"}) {
    CAPTURE(absorption);
    const auto told = [&](const char* factor) {
      return refusal(front + "box { -1, 1 interior { ior 1.5 " + absorption + " } surface { plugin { \"inner_gain\" factor " + factor + " } } }");
    };
    CHECK(has(told("3"), "plugin 'inner_gain' gains 8"));   // 800 % of what is reflected wholly
    CHECK(told("1") == "");
  }
}

TEST_CASE("what is said to be lossless is held to it") {
  const std::string told = refusal(box("\"dim\" factor 0.95"));
  CAPTURE(told);
  CHECK(has(told, "plugin 'dim' loses"));
  CHECK(has(told, "lossless"));
  CHECK(refusal(box("\"dim\" factor 1")) == "");
}

TEST_CASE("rounding at grazing incidence is no warning") {
  for (const char* film : {"n 1.38 thickness_nm 99.6", "n 2.35 thickness_nm 400", "n 1.45 thickness_nm 25"})
    for (const char* glass : {"1.33", "1.52", "2.42"}) {
      const Read scene = read(front + "box { -1, 1 interior { ior " + glass + " } surface { plugin { \"thin_film\" " + film + " } } }");
      REQUIRE(scene.loaded);
      CAPTURE(film);
      CAPTURE(glass);
      for (const bool real_double : {false, true}) {
        KernelOptions options;
        options.real_double = real_double;
        CHECK(check_fragments(*open_device(""), *scene.loaded->features.fragments, options) == "");
      }
    }
}

TEST_CASE("reciprocity: a rotator like quartz passes, one like Faraday's only where its manifest says so") {
  CHECK(refusal(sheet("\"rotator\" faraday 0")) == "");
  const std::string told = refusal(sheet("\"rotator\" faraday 1"));
  CAPTURE(told);
  CHECK(has(told, "plugin 'rotator' is not reciprocal"));
  CHECK(refusal(sheet("\"faraday\"")) == "");
}

TEST_CASE("light goes through Faraday's rotator one way turned, back again turned on") {
  // the camera sees through the rotator (30 degrees) and back by nothing: only that both sides turn the other way as the picture sees it
  const auto angle = [](const std::string& normal) {
    const Frame f = shoot(front + "disc { 0, " + normal + ", 5 polarizer { plugin { \"faraday\" } angle 0 } }" +
                          "disc { z, -z, 5 luminous { spectrum { e } polarizer { ideal angle 0 } } }");
    return 0.5 * std::atan2(centre(f, 0, 2), centre(f, 0, 1)) * 180 / 3.14159265358979323846;
  };
  CHECK(angle("-z") == doctest::Approx(-angle("z")).epsilon(1e-5));
  CHECK(std::abs(angle("z")) == doctest::Approx(30).epsilon(1e-5));
}

TEST_CASE("surfaces next to crystals and in optical contact are errors with places") {
  const std::string film = "surface { plugin { \"thin_film\" thickness_nm 100 } }";
  const std::string crystal = front + "box { -1, 1 interior { ordinary { constant 1.6 } extraordinary { constant 1.5 } } " + film + " }";
  CHECK(has(read(crystal).errors, "surfaces are for faces between isotropic media"));
  const std::string contact = front + "box { -1, 1 interior { ior 1.5 } " + film + " }\nbox { <-1, 1, -1>, <1, 2, 1> interior { ior 1.6 } optical_contact on }";
  CHECK(has(read(contact).errors, "optical contact"));
  CHECK(has(read(front + "disc { 0, z, 1 " + film + " luminous { spectrum { e } } }").errors, "faces of a solid"));
}

TEST_CASE("an element is no surface, a surface no element") {
  CHECK(has(read(box("\"splitter\" share 0.5")).errors, "\"surface\" is expected"));
  CHECK(has(read(sheet("\"thin_film\" thickness_nm 5")).errors, "\"element\" is expected"));
}

TEST_CASE("parameters: missing, out of range, unknown, at their places") {
  CHECK(has(read(box("\"thin_film\"")).errors, "needs 'thickness_nm'"));
  const std::string told = read(front + "box { -1, 1 interior { ior 1.5 } surface { plugin { \"thin_film\" thickness_nm\n -3 } } }").errors;
  CHECK(has(told, "line 5"));
  CHECK(has(told, "between 0 and 100000 nm"));
  CHECK(has(read(box("\"thin_film\" thicknes_nm 3")).errors, "thickness_nm"));
  CHECK(has(read(box("\"no_such_film\"")).errors, "Cannot find plugin 'no_such_film'"));
}
