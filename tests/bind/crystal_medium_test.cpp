// Crystals in interior { }: principal indices, frames, activity, absorption per axis, their errors.
#include "bound.hpp"
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/optics/crystal.hpp"

namespace nicol {

namespace {

const std::string at_589 = "global_settings { wavelengths { 589.3 } }\n" + lit;
const std::string uniaxial = " ordinary { constant 1.5 } extraordinary { constant 1.6 } ";
const std::string biaxial =
    " alpha { constant 1.5 } beta { constant 1.6 } gamma { constant 1.7 } ";

Medium medium(const std::string& interior, const std::string& transforms = "",
              const std::string& before = at_589) {
  const Bound b = bind_clean(before + "box { 0, 1 interior { " + interior + " } " + transforms + " }");
  REQUIRE(b.scene.media.size() == 2);
  return b.scene.media[1];
}

std::string told(const std::string& interior, const std::string& before = at_589) {
  const Bound b = bind_text(before + "box { 0, 1 interior { " + interior + " } }");
  CHECK(b.parsed->diagnostics.failed());
  return b.text();
}

void check_frame(const Medium& m, Vec3 first, Vec3 second, Vec3 third, std::size_t at = 0) {
  const OpticFrame& frame = m.frame_at(at);
  check_near(frame[0], first);
  check_near(frame[1], second);
  check_near(frame[2], third);
  CHECK(dot(cross(frame[0], frame[1]), frame[2]) == doctest::Approx(1));
}

// Where a crystal's Cartesian direction points in the world of an object without transforms.
Vec3 crystal(Vec3 v) {
  return transform_direction(to_world(1), transform_direction(from_crystal(), v));
}

bool says(const std::string& text, const std::string& words) {
  INFO(text);
  return text.find(words) != std::string::npos;
}

// Right quartz at 589.3 nm (Ghosh 1999; Lowry 1935).
const std::string quartz = " ordinary { constant 1.54424 } extraordinary { constant 1.55335 } "
                           "rotation { constant 21.7 } ";

}  // namespace

TEST_CASE("uniaxial: values 0 and 1 are ordinary, axis 2 is the crystal's Z") {
  const Medium m = medium(uniaxial);
  CHECK(m.symmetry == Medium::Symmetry::uniaxial);
  CHECK(m.n[0][0] == 1.5);
  CHECK(m.n[1][0] == 1.5);
  CHECK(m.n[2][0] == 1.6);
  CHECK_FALSE(m.is_active());
  check_frame(m, crystal({1, 0, 0}), crystal({0, 1, 0}), crystal({0, 0, 1}));
}

TEST_CASE("biaxial: alpha, beta, gamma along X, Y, Z, in the order of the text") {
  const Medium m = medium("gamma { constant 1.4 } alpha { constant 1.5 } beta { constant 1.6 }");
  CHECK(m.symmetry == Medium::Symmetry::biaxial);
  CHECK(m.n[0][0] == 1.5);
  CHECK(m.n[1][0] == 1.6);
  CHECK(m.n[2][0] == 1.4);
  check_frame(m, crystal({1, 0, 0}), crystal({0, 1, 0}), crystal({0, 0, 1}));
}

TEST_CASE("frames turn with the object; a right angle is exact; stretching does not count") {
  const Medium plain = medium(uniaxial);
  // POV-Ray: 90 degrees about y take x to -z and z to x. In the world z is negated.
  const auto about_y = [](Vec3 v) { return Vec3{-v.z, v.y, v.x}; };
  for (const char* transforms : {"rotate 90*y", "rotate 90*y scale 3", "translate 5*x rotate 90*y",
                                 "scale <1, 20, 3> rotate 90*y", "rotate 45*y rotate 45*y"}) {
    INFO(transforms);
    const Medium m = medium(uniaxial, transforms);
    for (int i = 0; i < 3; ++i) check_near(m.frame[0][i], about_y(plain.frame[0][i]), 1e-15);
  }
  const Medium exact = medium(uniaxial, "scale <1, 20, 3> rotate 90*y");
  for (int i = 0; i < 3; ++i) check_near(exact.frame[0][i], about_y(plain.frame[0][i]), 0);
}

TEST_CASE("a sheared crystal keeps the rotation of the polar decomposition") {
  // diag(2, 1, 1/2) in axes turned by 30 degrees about z, then turned by 40 more.
  const Medium sheared = medium(
      uniaxial, "rotate 30*z scale <2, 1, 0.5> rotate -30*z rotate <20, 0, 40>");
  const Medium turned_only = medium(uniaxial, "rotate <20, 0, 40>");
  for (int i = 0; i < 3; ++i) check_near(sheared.frame[0][i], turned_only.frame[0][i], 1e-14);
  medium(uniaxial, "scale <1e-200, 1, 1e200>");  // ends
}

TEST_CASE("a mirrored object turns its crystal, which keeps its hand") {
  const std::string text = "box { 0, 1 interior {" + quartz + "} scale <-1, 1, 1> }";
  const Bound b = bind_text(at_589 + text);
  CHECK(says(b.text(), "transforms mirror this box"));
  CHECK_FALSE(b.parsed->diagnostics.failed());
  const Medium& m = b.scene.media[1];
  CHECK(m.gyration[2][0] > 0);
  CHECK(dot(cross(m.frame[0][0], m.frame[0][1]), m.frame[0][2]) == doctest::Approx(1));
}

TEST_CASE("optic_axis is in the object's axes and turns with it") {
  const Medium m = medium(uniaxial + "optic_axis <0, 2, 0>", "rotate 90*z");
  check_near(m.frame[0][2], {-1, 0, 0}, 1e-15);
  check_near(medium(uniaxial + "optic_axis z").frame[0][2], {0, 0, -1}, 0);
}

TEST_CASE("optic_frame: vectors, crystal axes, one left out") {
  const Medium words = medium(biaxial + "optic_frame { alpha c beta a gamma b }");
  check_frame(words, crystal({0, 0, 1}), crystal({1, 0, 0}), crystal({0, 1, 0}));
  const Medium two = medium(biaxial + "optic_frame { gamma <0, 1, 0> alpha 5*z }");
  check_frame(two, crystal({0, 0, 1}), crystal({1, 0, 0}), crystal({0, 1, 0}));
  const Medium left = medium(biaxial + "optic_frame { alpha a beta c gamma b }");
  check_frame(left, crystal({1, 0, 0}), crystal({0, 0, 1}), crystal({0, -1, 0}));
}

TEST_CASE("monoclinic: the frame turns with the wavelength, right-handed about its axis") {
  const Bound b = bind_clean("global_settings { wavelengths { 400 500 600 } }" + lit +
                             "box { 0, 1 interior { " + biaxial +
                             "optic_frame { alpha a gamma c turn about b "
                             "table { 400, 0, 500, 30, 600, 90 } } } }");
  const Medium& m = b.scene.media[1];
  REQUIRE(m.frame.size() == 3);
  check_frame(m, crystal({1, 0, 0}), crystal({0, 1, 0}), crystal({0, 0, 1}), 0);
  const double c = std::sqrt(0.75), s = 0.5;
  check_frame(m, crystal({c, 0, -s}), crystal({0, 1, 0}), crystal({s, 0, c}), 1);
  check_frame(m, crystal({0, 0, -1}), crystal({0, 1, 0}), crystal({1, 0, 0}), 2);
}

TEST_CASE("quartz: the rotation along the axis becomes g33, ratio gives g11") {
  const Medium m = medium(quartz + "gyration { ratio -0.449 }");
  REQUIRE(m.is_active());
  CHECK(m.rotation_deg_per_mm[0] == 0);
  // 2 n kappa with kappa = rho lambda/(2 pi) = 3.552e-5.
  CHECK(m.gyration[2][0] == doctest::Approx(2 * 1.54424 * 3.552e-5).epsilon(2e-4));
  CHECK(rotation_of_gyration(m.gyration[2][0], m.n[0][0], 589.3) == doctest::Approx(21.7));
  CHECK(m.gyration[0][0] == doctest::Approx(-0.449 * m.gyration[2][0]));
  CHECK(m.gyration[1][0] == m.gyration[0][0]);
  for (int i : {3, 4, 5}) CHECK(m.gyration[i][0] == 0);
  const Medium plain = medium(quartz);
  CHECK(plain.gyration[0][0] == plain.gyration[2][0]);
}

TEST_CASE("left changes every sign; twice is right again") {
  CHECK(medium(quartz + "left").gyration[2][0] < 0);
  CHECK(medium(quartz + "left left").gyration[2][0] > 0);
  CHECK(medium("ior 1.5 rotation { constant 3 } left").rotation_deg_per_mm[0] == -3);
  const std::string declared = at_589 + "#declare Q = interior {" + quartz + "left } ";
  CHECK(medium("Q left", "", declared).gyration[2][0] > 0);
}

TEST_CASE("gyration by tensor: at all wavelengths, scaled, by table") {
  const std::string two = "global_settings { wavelengths { 400 800 } }" + lit;
  const auto g = [&](const std::string& text) {
    return medium(biaxial + "gyration { " + text + " }", "", two).gyration;
  };
  const auto constant = g("tensor 1e-5, 2e-5, 3e-5, 4e-5, 5e-5, 6e-5");
  for (int i = 0; i < 6; ++i) {
    CHECK(constant[i][0] == doctest::Approx((i + 1) * 1e-5));
    CHECK(constant[i][1] == constant[i][0]);
  }
  const auto scaled = g("tensor 1e-5, 2e-5, 3e-5, 0, 0, 0 at 800");
  CHECK(scaled[0][0] == doctest::Approx(2e-5));
  CHECK(scaled[2][1] == doctest::Approx(3e-5));
  const auto table = g("table { 400, 1e-5, 0, 0, 0, 0, 0, 800, 3e-5, 0, 0, 0, 0, 7e-5 } scale 2");
  CHECK(table[0][1] == doctest::Approx(6e-5));
  CHECK(table[5][1] == doctest::Approx(14e-5));
  // Class -42m: nothing along the axis, opposite signs along a and b.
  CHECK(medium(uniaxial + "gyration { tensor 1e-4, -1e-4, 0, 0, 0, 0 }").gyration[1][0] == -1e-4);
}

TEST_CASE("the second individual of a twin: turned in crystal axes, of the other hand") {
  Affines half_turn;
  append_rotation(half_turn, {0, 0, 180});
  const CrystalFrame second{half_turn[0], true};
  const Orientation one = orientation_of({}), two = orientation_of({}, second);
  check_near(two.crystal[0], -one.crystal[0], 0);
  check_near(two.crystal[2], one.crystal[2], 0);
  CHECK(two.opposite_hand);
  CHECK_FALSE(one.opposite_hand);
  // A mirror instead of a turn lays the tensor as its inversion does.
  const CrystalFrame mirror{scaling({1, 1, -1}), true};
  check_near(orientation_of({}, mirror).crystal[0], two.crystal[0], 0);
  check_near(orientation_of({}, mirror).crystal[2], two.crystal[2], 0);
}

TEST_CASE("opposite hands of one interior are two media, equal orientations one") {
  Bound b = bind_clean(at_589 + "#declare Q = interior {" + quartz + "}" +
                       "box { 0, 1 interior { Q } } box { 2, 3 interior { Q } rotate 360*y }"
                       "box { 4, 5 interior { Q } rotate 90*x }");
  CHECK(b.scene.media.size() == 3);
  CHECK(b.scene.objects[0].medium == b.scene.objects[1].medium);
  sdl::Block interior;
  sdl::Result parsed;
  sdl::parse_text("q.pov", "box { 0, 1 interior {" + quartz + "} }", test_options(), parsed);
  const sdl::Block* block = parsed.document.items[0].block();
  for (const sdl::Item& item : block->items)
    if (item.block()) interior = *item.block();
  const BindOptions options;
  Context context(b.scene, options, parsed.diagnostics);
  Orientation o = orientation_of({});
  const int right = *bind_medium(context, interior, o);
  o.opposite_hand = true;
  const int left = *bind_medium(context, interior, o);
  CHECK(right != left);
  CHECK(b.scene.media[right].gyration[2][0] == -b.scene.media[left].gyration[2][0]);
}

TEST_CASE("isotropic media have no orientation") {
  const Bound b = bind_clean(at_589 + "box { 0, 1" + glass + "} box { 2, 3" + glass +
                             "rotate 30*x }");
  CHECK(b.scene.media.size() == 2);
}

TEST_CASE("absorption along principal axes") {
  const auto k = [](double per_mm) { return extinction(per_mm, 589.3); };
  const Medium o_e = medium(uniaxial + "absorption { ordinary { constant 2 } extraordinary { table "
                                       "{ 400, 3, 700, 3 } } }");
  CHECK(o_e.k[0][0] == doctest::Approx(k(2)));
  CHECK(o_e.k[1][0] == doctest::Approx(k(2)));
  CHECK(o_e.k[2][0] == doctest::Approx(k(3)));
  const Medium every = medium(biaxial + "absorption { constant 1 } extinction { alpha { constant "
                                        "1e-4 } beta { constant 2e-4 } gamma { constant 0 } }");
  CHECK(every.k[0][0] == doctest::Approx(k(1) + 1e-4));
  CHECK(every.k[1][0] == doctest::Approx(k(1) + 2e-4));
  CHECK(every.k[2][0] == doctest::Approx(k(1)));
  const Medium rest = medium(uniaxial + "absorption { constant 0 extraordinary { constant 7 } }");
  CHECK(rest.k[0][0] == 0);
  CHECK(rest.k[2][0] == doctest::Approx(k(7)));
}

TEST_CASE("indices may cross with the wavelength") {
  const std::string two = "global_settings { wavelengths { 400 700 } }" + lit;
  const Medium m = medium("ordinary { constant 1.5 } extraordinary { table 400, 1.4, 700, 1.6 }", "",
                          two);
  CHECK(m.n[2][0] < m.n[0][0]);
  CHECK(m.n[2][1] > m.n[0][1]);
}

TEST_CASE("range: a warning where the scene goes beyond it") {
  CHECK(medium(uniaxial + "range 400, 700").range_nm[1] == 700);
  const Bound b = bind_text(at_589 + "box { 0, 1 interior { ior 1.5 name \"glass\" range 600, 700 } }");
  CHECK_FALSE(b.parsed->diagnostics.failed());
  CHECK(says(b.text(), "589.3 nm lies outside the range of 'glass', 600 to 700 nm"));
}

TEST_CASE("polarization off with a crystal is told once") {
  const Bound b = bind_text("global_settings { polarization off wavelengths { 589.3 } }" + lit +
                            "box { 0, 1 interior { " + uniaxial + " } }");
  CHECK(b.count(sdl::Severity::warning) == 1);
  CHECK(says(b.text(), "'polarization off' with a crystal"));
}

TEST_CASE("surroundings are isotropic") {
  const Bound b = bind_text(at_589 + "surroundings { interior {" + uniaxial + "} } box { 0, 1" +
                            glass + "}");
  CHECK(says(b.text(), "the surroundings must be isotropic"));
}

TEST_CASE("words that do not go together are errors that say so") {
  CHECK(says(told("ordinary { constant 1.5 }"), "a uniaxial medium needs 'extraordinary' as well"));
  CHECK(says(told("extraordinary { constant 1.5 }"), "needs 'ordinary' as well"));
  CHECK(says(told("alpha { constant 1.5 } gamma { constant 1.6 }"),
             "a biaxial medium needs 'beta' as well"));
  CHECK(says(told("ior 1.5" + uniaxial), "one index ('ior', 'index { }') or principal indices"));
  CHECK(says(told(biaxial + "index { constant 1.5 }"), "one index"));
  CHECK(says(told(uniaxial + biaxial), "uniaxial ('ordinary', 'extraordinary') or biaxial"));
  CHECK(says(told(biaxial + "rotation { constant 3 }"), "'gyration { tensor"));
  CHECK(says(told("ior 1.5 gyration { tensor 1, 1, 1, 0, 0, 0 }"), "has a 'rotation', no 'gyration'"));
  CHECK(says(told(uniaxial + "gyration { ratio 0.5 }"), "'ratio' is that of g11 to the g33"));
  CHECK(says(told(quartz + "gyration { tensor 1, 1, 1, 0, 0, 0 }"), "or a tensor, not both"));
  CHECK(says(told(quartz + "gyration { ratio 1 tensor 1, 1, 1, 0, 0, 0 }"), "not both"));
  CHECK(says(told(uniaxial + "gyration { tensor 1, 2, 3, 0, 0, 0 }"), "no uniaxial crystal has this"));
  CHECK(says(told(uniaxial + "gyration { tensor 1, 1, 1, 0, 1, 0 }"), "no uniaxial crystal has this"));
  CHECK(says(told(uniaxial + "gyration { tensor 1, 2, 3 }"), "6 numbers, 3 found instead"));
  CHECK(says(told(uniaxial + "gyration { table { 400, 1, 2 } }"), "rows of 7 numbers"));
  CHECK(says(told(uniaxial + "gyration { scale 2 }"), "Expected 'tensor', 'table' or 'ratio'"));
  CHECK(says(told(uniaxial + "gyration { tensor 1, 1, 1, 0, 0, 0 at -5 }"), "greater than 0"));
  CHECK(says(told(uniaxial + "optic_axis x gyration { tensor 1, -1, 0, 0, 0, 0 }"),
             "turn the object instead"));
}

TEST_CASE("frames and absorption that do not belong are errors") {
  CHECK(says(told(uniaxial + "optic_frame { alpha a beta b }"), "has an 'optic_axis'"));
  CHECK(says(told("ior 1.5 optic_frame { alpha a beta b }"), "has no 'optic_frame'"));
  CHECK(says(told("ior 1.5 optic_axis x"), "has no 'optic_axis'"));
  CHECK(says(told(uniaxial + "optic_axis 0"), "zero vector"));
  CHECK(says(told(biaxial + "optic_axis x"), "a biaxial crystal has two optic axes"));
  CHECK(says(told(biaxial + "optic_frame { alpha a }"), "needs two of"));
  CHECK(says(told(biaxial + "optic_frame { alpha <1, 0, 0> beta <1e-5, 1, 0> }"),
             "'alpha' and 'beta' must be perpendicular"));
  CHECK(says(told(biaxial + "optic_frame { alpha 0*x beta y }"), "zero vector"));
  CHECK(says(told(biaxial + "optic_frame { alpha d beta y }"), "'d' found instead"));
  CHECK(says(told(biaxial + "optic_frame { turn about b }"), "axes that turn need both"));
  CHECK(says(told(biaxial + "optic_frame { turn about b table 400, 0, 500, 1 }"),
             "'turn' has no value at 589.3 nm"));
  CHECK(says(told(biaxial + "optic_frame { alpha a beta c gamma b } gyration { tensor 0,0,0,0,0,1 }"),
             "need a right-handed 'optic_frame'"));
  CHECK(says(told(uniaxial + "absorption { alpha { constant 1 } }"), "no index along it"));
  CHECK(says(told("ior 1.5 absorption { ordinary { constant 1 } }"), "no index along it"));
  CHECK(says(told(biaxial + "extinction { alpha { constant 1 } }"), "leaves the others unsaid"));
  CHECK(says(told(uniaxial + "absorption { constant 0 ordinary { constant -1 } }"),
             "an absorption must not be negative"));
  CHECK(says(told("ior 1.5 range 700, 400"), "'range' takes the shortest"));
}

}  // namespace nicol
