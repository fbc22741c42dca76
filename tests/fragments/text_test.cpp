// Fragments are in a kernel's text only where a scene names them.
#include <doctest/doctest.h>

#include "host/effects.hpp"
#include "host/opencl/kernel_source.hpp"
#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::string front = "global_settings { mm_per_unit 1 }\nbackground { spectrum { e } }\ncamera { location -10*z look_at 0 right x }\n";
const std::string grid = "disc { 3*z, -z, 5 polarizer { plugin { \"wire_grid\" } angle 0 } }\n";
const std::string film = "box { -1, 1 interior { ior 1.5 } surface { plugin { \"thin_film\" thickness_nm 100 } } }\n";

std::string text_for(const std::string& scene) {
  const Read made = read(scene);
  REQUIRE_MESSAGE(made.loaded, made.errors);
  return expand_includes("trace.cl", made.loaded->features.contents().fragment_text());
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a scene without plugins has the kernels as they are") {
  const std::string plain = expand_includes("trace.cl");
  CHECK(text_for(front + "box { -1, 1 interior { ior 1.5 } }") == plain);
  CHECK(!has(plain, "#define FRAGMENTS_HERE 1"));
  CHECK((read(front + "disc { 0, z, 1 polarizer { ideal angle 3 } }").loaded->features.fragments == nullptr));
}

TEST_CASE("what is named is there, once, and nothing else") {
  const std::string text = text_for(front + grid + film + "box { <2, 0, 0>, <3, 1, 1> interior { ior 1.5 } surface { plugin { \"thin_film\" thickness_nm 7 } } }");
  CHECK(has(text, "wire_grid/wire_grid.cl\""));
  CHECK(text.find("FUNCTION void thin_film(") == text.rfind("FUNCTION void thin_film("));
  CHECK(!has(text_for(front + film), "wire_grid"));
}

TEST_CASE("two fragments and three uses in one picture, beside the same alone") {
  const std::string both = front + grid + film;
  CHECK(difference(shoot(both, true), shoot(both, false)) < 1e-4);
  CHECK(difference(shoot(both), shoot(front + film)) > 0.05);   // the sky all around: the grid takes 8 % of it
  CHECK(difference(shoot(both), shoot(front + grid)) > 1e-3);
}

TEST_CASE("kernel_text keeps a file's name as it is") {
  auto fragment = std::make_shared<Fragment>();
  fragment->name = "f";
  fragment->file = "a \"b\"\\c.cl";
  CHECK(has(kernel_text({fragment}), "#line 1 \"a \\\"b\\\"\\\\c.cl\""));
}

TEST_CASE("left out, elements are ideal polarizers and faces are bare") {
  const Read made = read(front + grid + film);
  REQUIRE(made.loaded);
  const Scene without = without_effect(made.loaded->scene, "fragments");
  CHECK((without.polarizers[0].kind == Polarizer::Kind::ideal));
  CHECK((decide_features(without, made.loaded->geometry).fragments == nullptr));
}
