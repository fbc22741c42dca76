// Bad scenes and what is said about them: the message, and the line it names.
#include "bound.hpp"

namespace nicol {

namespace {

struct Bad {
  const char* text;  // line 1 is a good scene; the fault is on the line given
  int line;
  const char* message;
};

const Bad bad[] = {
    {"box { 0, 1 interior { ior 1.5\n roation { constant 3 } } }", 3,
     "unknown block 'roation' in 'interior'; did you mean 'rotation'?"},
    {"box { 0, 1 interior { iors 1.5 } }", 2,
     "unknown word 'iors' in 'interior'; did you mean 'ior'?"},
    {"global_settings {\n error 1.5 }", 3, "'error' must lie between 0 and 1 (0.001 is 0.1 %)"},
    {"crystl { facet x, 1 }", 2, "unknown block 'crystl' in 'scene'; did you mean 'crystal'?"},
    {"box { 0, 1 interior { ior \"1.5\" } }", 2,
     "Expected 'numeric expression', string literal found instead"},
    {"box { 0, 1 interior { ior <1, 2, 3> } }", 2,
     "Expected 'numeric expression', 3-vector found instead"},
    {"box { 0 interior { ior 1.5 } }", 2,
     "Expected 'vector expression', 'interior' block found instead"},
    {"box { 0, 1, 2 interior { ior 1.5 } }", 2,
     "Expected a word or block of 'box', number 2 found instead"},
    {"box { 0, 1 rotate \"x\" interior { ior 1.5 } }", 2,
     "Expected 'vector expression', string literal found instead"},
    {"box { 0, 1 }", 2,
     "box has no interior with an index; nicol renders transparent crystals, polarizers and "
     "lights"},
    {"box { 0, 1 interior { rotation { constant 3 } } }", 2,
     "this interior has no index: 'ior' or 'index { }' gives it one, 'ordinary { }' and "
     "'extraordinary { }' or 'alpha { }', 'beta { }' and 'gamma { }' those of a crystal"},
    {"box { 0, 1 interior { index { } } }", 2, "Expected a formula or table in 'index'"},
    {"box { 0, 1 interior { index { formula 2, 1, 2 } } }", 2,
     "'index': formula 2 takes 1 + 2m coefficients, 2 given"},
    {"box { 0, 1 interior { index { table { 500, 1.5, 400, 1.6 } } } }", 2,
     "the wavelengths of a table must ascend; 400 comes after 500"},
    {"box { 0, 1 interior { index { table { 500, 1.5, 600 } } } }", 2,
     "a table is a list of pairs (wavelength in nm, value), 3 numbers found instead"},
    {"box { 0, 1 interior { index { table { 400, 1.5, 700, 1.6 } } } }", 2,
     "'index' has no value at 380 nm and 4 more of the scene's wavelengths"},
    {"box { 0, 1 interior { ior 1.5 absorption { constant -1 } } }", 2,
     "'absorption': an absorption must not be negative"},
    {"plane { y, 0 }", 2,
     "a plane alone is infinite, and nothing of it can be rendered; cut a solid from planes with "
     "'intersection', or use 'polygon' or 'disc'"},
    {"intersection { plane { 0, 1 } interior { ior 1.5 } }", 2, "Degenerate plane normal."},
    {"sphere { 0, 1 interior { ior 1.5 } }", 2,
     "nicol does not render 'sphere' yet; it renders box, prism, crystal, polygon, disc, unions of "
     "these, and merge, intersection and difference of solids with flat faces"},
    {"box { 0, 1 interior { ior 1.5 } inverse }", 2,
     "an inverse solid fills all of space; inside an intersection it cuts"},
    {"difference { box { 0, 2 }\n sphere { 0, 1 } interior { ior 1.5 } }", 3,
     "nicol does not render 'sphere' yet; it renders box, prism, crystal, polygon, disc, unions of "
     "these, and merge, intersection and difference of solids with flat faces"},
    {"merge { interior { ior 1.5 } }", 2, "'merge' holds no solid"},
    {"merge { box { 0, 1 }\n disc { 0, y, 1 } interior { ior 1.5 } }", 3,
     "a 'disc' has no inside, so it neither cuts nor is cut"},
    {"difference { box { 0, 2 } box { 0, 1 } luminous { } interior { ior 1.5 } }", 2,
     "faces of a solid that is not convex cannot shine; lay a luminous polygon on them"},
    {"difference { box { 0, 2 } box { 0, 1 } }", 2,
     "difference has no interior with an index; nicol renders transparent crystals, polarizers and "
     "lights"},
    {"prism { cubic_spline 0, 1, 4, <0,0>, <1,0>, <0,1>, <0,0> interior { ior 1.5 } }", 2,
     "a prism with 'cubic_spline' is not rendered; 'linear_spline' with 'linear_sweep' is"},
    {"polygon { 5, 0, x, y, 0 luminous { } }", 2,
     "this Polygon announces 5 points, 4 found instead"},
    {"polygon { 3, 0, x, 0 luminous { } }", 2, "Polygon needs at least three points."},
    {"polygon { 4, 0, x, y, 0 }", 2,
     "this polygon neither shines ('luminous { }') nor polarizes ('polarizer { }'); nicol does not "
     "render "
     "opaque surfaces"},
    {"polygon { 4, 0, x, y, 0 luminous { } polarizer { angle 0 } }", 2,
     "a light's polarizer is written inside 'luminous { }'"},
    {"disc { 0, y, 1, 2 luminous { } }", 2, "the hole of a disc must be smaller than the disc"},
    {"disc { 0, y, 1 polarizer { axis y } }", 2,
     "the polarizer's 'axis' stands along the normal of its plane"},
    {"disc { 0, y, 1 polarizer { calcite } }", 2, "Expected 'angle' or 'axis' in 'polarizer'"},
    {"disc { 0, y, 1 polarizer { angle 3 projection sideways } }", 2,
     "Expected 'transmission' or 'absorption', 'sideways' found instead"},
    {"box { 0, 1 luminous { face <1, 1, 0> } interior { ior 1.5 } }", 2,
     "'face' is as near to two faces, or to none: name one by its outward normal"},
    {"disc { 0, y, 1 luminous { spectrum { line 900 } } }", 2, ""},
    {"camera { angle 180 }", 2, "Viewing angle has to be smaller than 180 degrees."},
    {"camera { location 1 look_at 1 }", 2, "Camera location and look_at point must be different."},
    {"camera { fisheye angle 90 }", 2, "nicol has two cameras, 'perspective' and 'orthographic'"},
    {"camera { right 0 }", 2,
     "the camera's 'right', 'up' and 'direction' must not vanish or be parallel"},
    {"global_settings { mm_per_unit 0 }", 2,
     "'mm_per_unit' must be greater than 0, 0 found instead"},
    {"global_settings { max_trace_level 2.5 }", 2,
     "'max_trace_level' must be a whole number from 1 to 4096, 2.5 found instead"},
    {"global_settings { wavelengths { from 700 to 400 step 20 } }", 2,
     "wavelengths run from the shorter to the longer by a step greater than 0"},
    {"global_settings { wavelengths { 580, 580 } }", 2, "the same wavelength is given twice"},
    {"global_settings { wavelengths { from 1 to 800 step 0.001 } }", 2,
     "more than 1024 wavelengths"},
    {"expect { xyz <1, 1, 1> within 0.1 }", 2,
     "Expected 'source' and a string in 'expect': who says so?"},
    {"expect { xyz <1, 1, 1> source \"me\" }", 2, "Expected 'within' and a tolerance in 'expect'"},
    {"expect { relative_radiance 585, 1 within 0.1 source \"me\" }", 2,
     "585 nm is not among the scene's wavelengths; the nearest is 580"},
    {"expect { xyz <1, 1, 1> at <2, 0> within 0.1 source \"me\" }", 2,
     "'at' lies outside the picture (0 to 1 from the left and from the top)"},
    {"luminous { }", 2, "'luminous' belongs inside an object: a polygon, a disc, a box"},
    {"object { rotate x }", 2, "Expected an object in 'object', } found instead"},
    {"crystal { interior { ior 1.5 } }", 2, "Expected 'facet' or 'form', } of 'crystal' found instead"},
};

}  // namespace

TEST_CASE("bad scenes: each is told, in these words, at this place") {
  for (const Bad& b : bad) {
    const Bound bound = bind_text("background { rgb 1 }\n" + std::string(b.text));
    INFO(b.text, "\n", bound.text());
    const auto& all = bound.parsed->diagnostics.all();
    bool told = false;
    for (const auto& d : all)
      told =
          told || (d.severity == sdl::Severity::error && static_cast<int>(d.where.line) == b.line &&
                   (d.message == b.message || (!*b.message && !d.message.empty())));
    CHECK(told);
    CHECK(bound.count(sdl::Severity::error) == 1);
  }
}

TEST_CASE("all errors of a scene, not only the first") {
  const Bound b = bind_text(
      "background { rgb 1 }\nsphere { 0, 1 }\nbox { 0, 1 }\ncamera { angel 3 }\nbox { 0, 1 "
      "interior { ior x } }");
  CHECK(b.count(sdl::Severity::error) == 4);
}

TEST_CASE("a fault in a shared block is told once") {
  const Bound b = bind_text(
      lit + "#declare B = box { 0, 1 }\n#for (I, 1, 100) object { B translate I*x } #end");
  CHECK(b.count(sdl::Severity::error) == 1);
}

TEST_CASE("what POV-Ray has and nicol has not is named once each") {
  const Bound b = bind_text(lit +
                            "light_source { 0, rgb 1 } light_source { 1, rgb 1 } fog { distance 3 }"
                            "box { 0, 1 pigment { rgb 1 } finish { phong 1 }" +
                            glass + "}");
  CHECK(b.count(sdl::Severity::warning) == 4);
  CHECK(b.count(sdl::Severity::error) == 0);
}

TEST_CASE("an empty or dark scene is told of") {
  CHECK(bind_text(lit).text().find("No objects in scene.") != std::string::npos);
  CHECK(bind_text("box { 0, 1" + glass + "}").text().find("nothing shines") != std::string::npos);
}

}  // namespace nicol
