// nicol's ideal polarizer written as a fragment gives nicol's pictures: on the camera, on a light, as a sheet that rays meet aslant,
// before and behind a solid; and what an element throws back.
#include <doctest/doctest.h>

#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::string front = R"(
global_settings { mm_per_unit 1 max_trace_level 8 adc_bailout 1e-9 }
#declare Glass = interior { index { cauchy 1.5046, 0.0042 } }
camera { location <3, 5, -20> right x angle 30 look_at <0, 0.5, 0> CAMERA }
background { spectrum { d65 scale 0.4 } }
polygon { 5, <-7, -3, 6>, <7, -3, 6>, <7, 6, 6>, <-7, 6, 6>, <-7, -3, 6> luminous { spectrum { a } LIGHT } }
)";

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size())) text.replace(at, word.size(), by);
  return text;
}

std::string scene(const std::string& camera, const std::string& light, const std::string& rest) {
  return replaced(replaced(front, "CAMERA", camera), "LIGHT", light) + rest;
}

const std::string ideal = "polarizer { ideal angle ", own = "polarizer { plugin { \"ideal_element\" } angle ";

// The same scene with nicol's polarizer and with the fragment at the places of %.
double apart(const std::string& text, bool real_double = true) {
  return difference(shoot(replaced(text, "%", ideal), real_double), shoot(replaced(text, "%", own), real_double));
}

}  // namespace

TEST_CASE("on the camera and on a light") {
  CHECK(apart(scene("% 20 }", "% 65 }", "")) < 1e-12);
  CHECK(apart(scene("% 20 }", "% 65 }", "box { -1, 1 rotate 30*y interior { Glass } }")) < 1e-12);
}

TEST_CASE("as a sheet, free and on the faces of solids") {
  const std::string sheet = "polygon { 5, <-2, -2, -4>, <2, -2, -3>, <2, 3, -3>, <-2, 3, -4>, <-2, -2, -4> % 33 } }";
  CHECK(apart(scene("", "% 65 }", sheet + "box { -1, 1 rotate 30*y interior { Glass } }")) < 1e-12);
  const std::string on_face = "box { -1, 1 interior { Glass } } polygon { 5, <-1,-1,-1>, <1,-1,-1>, <1,1,-1>, <-1,1,-1>, <-1,-1,-1> % 33 } }";
  CHECK(apart(scene("", "", on_face)) < 1e-12);
  CHECK(apart(scene("% 12 }", "% 5 }", on_face), false) < 2e-5);
}

TEST_CASE("every number of lanes gives one picture") {
  const std::string text = replaced(scene("% 20 }", "% 65 }", "box { -1, 1 rotate 30*y interior { Glass } }"), "%", own);
  const Frame one = shoot(text, true, "450,500,550,589,650", 8, 1);
  for (const int lanes : {4, 8}) CHECK(difference(one, shoot(text, true, "450,500,550,589,650", 8, lanes)) < 1e-12);
}

TEST_CASE("without polarization an element passes what it passes of unpolarized light") {
  const std::string off = "global_settings { polarization off } ";
  CHECK(apart(off + scene("", "% 65 }", "")) < 1e-12);
}

TEST_CASE("a beam splitter throws light back") {
  // before a dark background, aslant by 45 degrees: a light aside is seen in it, with R of what is seen straight
  const std::string splitter = R"(
    global_settings { mm_per_unit 1 max_trace_level 8 adc_bailout 1e-9 }
    camera { orthographic location <0, 0, -20> right x up y direction z }
    polygon { 5, <-3, -3, -3>, <-3, -3, 3>, <-3, 3, 3>, <-3, 3, -3>, <-3, -3, -3> luminous { spectrum { e } } }
    disc { 0, <-1, 0, -1>, 2 polarizer { plugin { "splitter" share 0.3 } angle 0 } }
  )";
  const std::string straight = R"(
    global_settings { mm_per_unit 1 }
    camera { orthographic location <0, 0, -20> right x up y direction z }
    polygon { 5, <-3, -3, 3>, <3, -3, 3>, <3, 3, 3>, <-3, 3, 3>, <-3, -3, 3> luminous { spectrum { e } } }
  )";
  CHECK(centre(shoot(splitter)) == doctest::Approx(0.3 * centre(shoot(straight))).epsilon(1e-6));
  // behind it, what passes
  const std::string behind = replaced(splitter, "<-3, -3, -3>, <-3, -3, 3>, <-3, 3, 3>, <-3, 3, -3>, <-3, -3, -3>",
                                      "<-3, -3, 3>, <3, -3, 3>, <3, 3, 3>, <-3, 3, 3>, <-3, -3, 3>");
  CHECK(centre(shoot(behind)) == doctest::Approx(0.7 * centre(shoot(straight))).epsilon(1e-6));
}

TEST_CASE("a furnace with a lossless element stays a furnace") {
  // all around radiance 1: whatever way light goes, as much arrives (kernels/README.md, the cut-off)
  const std::string furnace = R"(
    global_settings { mm_per_unit 1 max_trace_level 14 adc_bailout 1e-3 }
    camera { location <3, 5, -20> right x angle 12 look_at <0, 0.5, 0> }
    background { spectrum { e } }
    #declare Glass = interior { ior 1.5 }
    box { -1, 1 rotate 20*y interior { Glass } }
    disc { <0, 0, -3>, <0.3, 0, -1>, 2 polarizer { plugin { "splitter" share 0.4 } angle 20 } }
    box { <-1, 2, -1>, <1, 3, 1> interior { Glass } }
    polygon { 5, <-1,2,-1>, <1,2,-1>, <1,3,-1>, <-1,3,-1>, <-1,2,-1> polarizer { plugin { "splitter" share 0.7 } angle 0 } }
  )";
  const Frame frame = shoot(furnace, true, "589", 4);
  const double full = centre(shoot("global_settings { mm_per_unit 1 } camera { location -z look_at 0 } background { spectrum { e } }", true, "589", 4));
  for (std::size_t i = 0; i < frame.plane(); ++i) {
    CHECK(frame.component(0, 0)[i] / full + frame.cut_off[i] == doctest::Approx(1).epsilon(2e-6));
    CHECK(std::abs(frame.component(1, 0)[i] / full) <= 2e-6 + frame.cut_off[i]);
  }
}
