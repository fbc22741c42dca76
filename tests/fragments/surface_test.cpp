// A surface that hands Fresnel's amplitudes through changes nothing, on faces of every kind; one on single faces counts on those alone.
#include <doctest/doctest.h>

#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::string front = R"(
global_settings { mm_per_unit 1 max_trace_level 12 adc_bailout 1e-9 }
#declare Glass = interior { index { cauchy 1.5046, 0.0042 } }
#declare Smoke = interior { index { constant 1.45 } absorption { constant 0.05 } }
#declare Active = interior { index { constant 1.6 } rotation { biot 7.2 } }
camera { location <3, 5, -20> right x angle 25 look_at <0, 0.5, 0> polarizer { ideal angle 20 } }
background { spectrum { d65 scale 0.4 } }
polygon { 5, <-7, -3, 6>, <7, -3, 6>, <7, 6, 6>, <-7, 6, 6>, <-7, -3, 6> luminous { spectrum { a } } }
)";

const std::string bare = "surface { plugin { \"bare_face\" } }";

// The same scene without and with the surface at the places of %.
double apart(const std::string& rest, const std::string& surface, bool real_double) {
  std::string with = front + rest, without = front + rest;
  for (std::size_t at = with.find('%'); at != std::string::npos; at = with.find('%')) with.replace(at, 1, surface);
  for (std::size_t at = without.find('%'); at != std::string::npos; at = without.find('%')) without.erase(at, 1);
  return difference(shoot(without, real_double), shoot(with, real_double));
}

}  // namespace

TEST_CASE("Fresnel's amplitudes handed through") {
  const std::string boxes = R"(
    box { -1, 1 rotate 30*y interior { Glass } % }
    box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> rotate 10*x interior { Smoke } % }
    box { <2, -1, -1>, <4, 1, 1> interior { Active } % }
    box { <2, 1, -1>, <4, 2, 1> interior { Glass } % }
  )";
  CHECK(apart(boxes, bare, true) < 1e-12);
  CHECK(apart(boxes, bare, false) < 2e-5);
}

TEST_CASE("one face among bare ones, and the last surface counts") {
  const std::string box = "box { -1, 1 rotate 30*y interior { Glass } % }";
  const std::string film = "surface { plugin { \"thin_film\" n 1.38 thickness_nm 100 } ";
  CHECK(apart(box, film + "face -z }", true) > 1e-3);
  CHECK(apart(box, film + "face -z } " + bare, true) < 1e-12);
  CHECK(apart(box, film + "face -z } surface { plugin { \"bare_face\" } face <0.1, 0, -1> }", true) < 1e-12);
  CHECK(apart(box, film + "face -z } surface { plugin { \"bare_face\" } face y }", true) > 1e-3);
}

TEST_CASE("a surface that hides another is told") {
  const auto told = [](const std::string& surfaces) { return read(front + "box { -1, 1 interior { Glass } " + surfaces + " }").errors; };
  const std::string on_front = "surface { plugin { \"bare_face\" } face -z }", on_top = "surface { plugin { \"bare_face\" } face y }";
  CHECK(told(bare + on_front + on_top) == "");
  CHECK(told(on_front + bare).find("worn by all faces: those before it are not seen") != std::string::npos);
  CHECK(told(bare + bare).find("worn by all faces: those before it are not seen") != std::string::npos);
  CHECK(told(on_front + on_front).find("Two surfaces for the same face: the last one is worn") != std::string::npos);
}

TEST_CASE("solids that are not convex wear it all over") {
  CHECK(apart("difference { box { -1, 1 } box { <0, 0, -2>, <2, 2, 2> } interior { Glass } % }", bare, true) < 1e-12);
  CHECK(apart("prism { 0, 1, 4, <0,0>, <1,0>, <0,1>, <0,0> interior { Glass } % }", bare, true) < 1e-12);
}
