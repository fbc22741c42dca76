// `crystal { }` with a lattice: words to solids, orientation, hands, twins, and what bad text is told.
#include "built.hpp"

namespace nicol {

namespace {

const std::string uniaxial =
    " interior { ordinary { constant 1.54 } extraordinary { constant 1.55 } rotation { constant 20 } } ";
const std::string quartz = "crystal { axial_ratio { 1.09997 } point_group \"32\" ";
const std::string prism_and_tips =
    "form { 1,0,-1,0, 0.5 } form { <1,0,-1,1>, 1 } form { <0,1,1>, 1 } ";

Vec3 normal_of(const Built& b, std::size_t cell, int shape_face) {
  const Cell& c = b.cell(cell);
  for (int f = c.first_face; f < c.first_face + c.face_count; ++f)
    if (b.geometry.faces[f].shape_face == shape_face) return b.geometry.faces[f].plane.normal;
  FAIL("no face ", shape_face);
  return {};
}

double offset_of(const Built& b, std::size_t cell, int shape_face) {
  const Cell& c = b.cell(cell);
  for (int f = c.first_face; f < c.first_face + c.face_count; ++f) {
    const Face& face = b.geometry.faces[f];
    if (face.shape_face == shape_face)
      return face.plane.offset_mm + dot(face.plane.normal, c.centre_mm);
  }
  FAIL("no face ", shape_face);
  return 0;
}

}  // namespace

TEST_CASE("quartz stands with c up, and its first prism face at 30 degrees to the viewer") {
  const Built b = build_text(quartz + prism_and_tips + "size 4" + uniaxial + "}");
  REQUIRE(b.cells() == 1);
  CHECK(b.cell(0).face_count == 18);
  // (10-10): the normal lies at 30 degrees from X (the viewer, +z of the world) towards Y (right, +x).
  check_near(normal_of(b, 0, 0), {0.5, 0, std::sqrt(0.75)});
  CHECK(offset_of(b, 0, 0) == doctest::Approx(2).epsilon(1e-14));
  CHECK(offset_of(b, 0, 6) == doctest::Approx(4).epsilon(1e-14));
  check_near(b.medium(0).frame_at(0)[2], {0, 1, 0});
  // All twelve faces of the tips meet in two corners, exactly: no slivers.
  CHECK(b.smallest_area(0) > 0.5);
}

TEST_CASE("right quartz has x at the upper right of m below r, left quartz at the upper left") {
  const std::string x_and_s = prism_and_tips + "form { \"51-61\", 0.55 } form { \"11-21\", 0.83 } ";
  const Built right = build_text(quartz + x_and_s + uniaxial + "}");
  const Built left = build_text(quartz + "left " + x_and_s + uniaxial + "}");
  REQUIRE(right.cells() == 1);
  CHECK(right.cell(0).face_count == 30);
  CHECK(left.cell(0).face_count == 30);
  // Seen along the normal of the first m = (10-10), up is c; to the right is c x m in the world. With
  // r = (10-11) above it, x = (51-61) lies to the right, and the left crystal's to the left.
  const Vec3 up{0, 1, 0}, m{0.5, 0, std::sqrt(0.75)}, to_the_right = cross(up, m);
  const auto x_side = [&](const Built& b) {
    const Cell& c = b.cell(0);
    double side = 0;
    for (int f = c.first_face; f < c.first_face + c.face_count; ++f) {
      const Face& face = b.geometry.faces[f];
      const Vec3 n = face.plane.normal;
      if (face.shape_face >= 18 && face.shape_face < 24 && dot(n, m) > 0.95 && n.y > 0)
        side = dot(n, to_the_right);
    }
    return side;
  };
  CHECK(x_side(right) > 0.05);
  CHECK(x_side(left) < -0.05);
  CHECK(x_side(left) == doctest::Approx(-x_side(right)));
}

TEST_CASE("left mirrors the forms, enantiomorph the medium as well") {
  const Built left = build_text(quartz + "left " + prism_and_tips + uniaxial + "}");
  const Built both = build_text(quartz + "enantiomorph " + prism_and_tips + uniaxial + "}");
  CHECK(left.medium(0).gyration[2][0] > 0);
  CHECK(both.medium(0).gyration[2][0] == -left.medium(0).gyration[2][0]);
}

TEST_CASE("forms of cubes and rhombohedra enclose the volumes of textbooks") {
  // Octahedron with planes at distance 1: 4 sqrt(3); rhombic dodecahedron: 4 sqrt(2).
  const Built b = build_text("crystal { cdl \"cubic[m3m]:octahedron\"" + glass +
                             "} crystal { system \"cubic\" form { <1,1,0> }" + glass +
                             "translate 9*x } crystal { axial_ratio { 0.8543 } point_group \"-3m\""
                             " form { <1,0,1> }" + glass + "translate 18*x }"
                             "crystal { cell { 1, 101.9128 } rhombohedral point_group \"-3m\""
                             " form { <1,0,0> }" + glass + "translate 27*x }");
  REQUIRE(b.cells() == 4);
  CHECK(b.volume(0) == doctest::Approx(4 * std::sqrt(3.0)).epsilon(1e-13));
  CHECK(b.volume(1) == doctest::Approx(4 * std::sqrt(2.0)).epsilon(1e-13));
  CHECK(b.cell(2).face_count == 6);
  CHECK(b.volume(3) == doctest::Approx(b.volume(2)).epsilon(1e-4));
}

TEST_CASE("a polished facet cuts a crystal of a lattice; inside an intersection it keeps its axes") {
  const Built b = build_text(quartz + prism_and_tips + "facet <0,0,1>, 0.25 facet <0,0,-1>, 0.25" +
                             uniaxial + "} intersection { " + quartz + prism_and_tips +
                             "} box { <-5,-0.25,-5>, <5,0.25,5> }" + uniaxial + "translate 9*x }");
  REQUIRE(b.cells() == 2);
  CHECK(b.cell(0).face_count == 8);
  CHECK(b.cell(1).face_count == 8);
  CHECK(b.volume(0) == doctest::Approx(b.volume(1)).epsilon(1e-12));
}

TEST_CASE("faces shine by their indices") {
  const Built b = build_text(quartz + prism_and_tips + uniaxial +
                             "luminous { face <1,0,1> spectrum { d65 } } }");
  REQUIRE(b.bound.scene.objects.size() == 1);
  REQUIRE(b.bound.scene.objects[0].face_emissions.size() == 1);
  CHECK(b.bound.scene.objects[0].face_emissions[0].face == 6);
}

TEST_CASE("twins: two individuals in optical contact, each with its axes and hand") {
  struct Row {
    const char* law;
    double cosine_of_c;  // between the axes c
    bool other_hand;
  };
  for (const Row& row : {Row{"japan", std::cos(84.5527 / 180 * 3.14159265358979), false},
                         Row{"dauphine", 1, false}, Row{"brazil", 1, true}}) {
    CAPTURE(std::string(row.law));
    const Built b = build_text(quartz + prism_and_tips + "twin { law \"" + row.law + "\" } size 4" +
                               uniaxial + "}");
    REQUIRE(b.cells() == 2);
    CHECK(b.volume(0) == doctest::Approx(b.volume(1)).epsilon(1e-9));
    CHECK(b.patches(Patch::Behind::cell_contact) >= 2);
    CHECK(b.patches(Patch::Behind::cell_gap) == 0);
    const Vec3 c0 = b.medium(0).frame_at(0)[2], c1 = b.medium(1).frame_at(0)[2];
    CHECK(std::abs(dot(c0, c1)) == doctest::Approx(row.cosine_of_c).epsilon(1e-4));
    // Both prisms stand along their own axes c.
    for (std::size_t i : {0, 1}) {
      const Vec3 c = b.medium(i).frame_at(0)[2];
      int prism_faces = 0;
      for (int f = b.cell(i).first_face; f < b.cell(i).first_face + b.cell(i).face_count; ++f) {
        const Face& face = b.geometry.faces[f];
        if (face.shape_face >= 6) continue;
        ++prism_faces;
        CHECK(std::abs(dot(face.plane.normal, c)) < 1e-12);
      }
      CHECK(prism_faces >= 3);  // half a hexagon
    }
    const double g0 = b.medium(0).gyration[2][0], g1 = b.medium(1).gyration[2][0];
    CHECK(g1 == (row.other_hand ? -g0 : g0));
  }
}

TEST_CASE("lamellae alternate; penetration twins stand out of each other") {
  const Built lamellae = build_text(
      "crystal { axial_ratio { 0.63347, 0.5577, 94.05, 116.4833, 88.15 } point_group \"-1\""
      " form { <0,1,0>, 0.8 } form { <0,0,1>, 1 } form { <1,1,0>, 1 } form { <1,-1,0>, 1 }"
      " twin { law \"albite\" individuals 5 thickness 0.2 }" + glass + "}");
  CHECK(lamellae.cells() == 5);
  CHECK(lamellae.patches(Patch::Behind::cell_contact) == 8);
  // Two cubes of edge 2 turned by 60 degrees about [111]: together 8 + 6 pyramids' worth, 8 * 5/4.
  const Built fluorite =
      build_text("crystal { cdl \"cubic[m3m]:{100} | twin(fluorite)\"" + glass + "}");
  REQUIRE(fluorite.cells() >= 2);
  double volume = 0;
  for (std::size_t i = 0; i < fluorite.cells(); ++i) volume += fluorite.volume(i);
  CHECK(volume == doctest::Approx(10).epsilon(1e-12));
}

TEST_CASE("CDL with a lattice; without one a ratio is taken and told") {
  const Bound b = bind_text(lit + "crystal { cdl \"trigonal[32]:{10-10}@1.0 + {10-11}@1.6\"" + glass + "}");
  CHECK_FALSE(b.parsed->diagnostics.failed());
  CHECK(b.text().find("no 'axial_ratio' or 'cell': c/a = 1.1 is taken") != std::string::npos);
  bind_clean(lit + "crystal { axial_ratio { 1.1 } cdl \"trigonal[32]:{10-10}@1.0 + {10-11}@1.6\"" +
             glass + "}");
}

TEST_CASE("bad crystals are told what is wrong, at its place") {
  struct Bad {
    std::string text;
    const char* message;
  };
  const std::string end = glass + "}";
  const Bad bad[] = {
      {"crystal { axial_ratio { 1.1 } point_group \"m3n\" form { <1,0,0> }" + end,
       "unknown point group 'm3n' in 'crystal'; did you mean 'm3'?"},
      {"crystal { system \"trigonl\" form { <1,0,0> }" + end,
       "unknown crystal system 'trigonl' in 'crystal'; did you mean 'trigonal'?"},
      {"crystal { system \"cubic\" point_group \"32\" form { <1,0,0> }" + end,
       "point group '32' is trigonal, not cubic"},
      {quartz + "form { 1,0,1,1, 0.5 }" + end,
       "Miller-Bravais indices (h k i l) need h + k + i = 0; here i must be -1"},
      {quartz + "form { <0,0,0>, 0.5 }" + end, "a face with all indices zero is none"},
      {quartz + "form { <1,0.5,0>, 0.5 }" + end, "indices of a face are whole numbers up to 1000"},
      {quartz + "form { <1,0,0>, -1 }" + end,
       "the distance of a form is positive, -1 found instead"},
      {quartz + "form { 1,0,0,1 }" + end, "four numbers may be h, k, l, distance or h, k, i, l"},
      {quartz + "form { <1,0,0> }" + end,
       "this crystal is open towards [0 0 1]: no form or face closes it there"},
      {"crystal { facet x, 1 facet -x, 1 facet y, 1 facet -y, 1 facet z, 1" + end,
       "this crystal is open towards <0, 0, -1> (X, Y, Z): no facet closes it there"},
      {"crystal { cell { 5, 6, 7, 90, 100, 90 } point_group \"32\" form { <1,0,1> }" + end,
       "this cell has not the symmetry of point group 32: trigonal means a = b, alpha = beta = "
       "90, gamma = 120"},
      {"crystal { cell { 1, 1, 1, 30, 30, 90 } point_group \"1\" form { <1,0,1> }" + end,
       "no cell has these angles: its edges would lie in one plane"},
      {"crystal { axial_ratio { 1.1 } point_group \"mmm\" form { <1,0,1> }" + end,
       "'axial_ratio' is c/a (tetragonal, trigonal, hexagonal) or a/b, c/b"},
      {"crystal { point_group \"mmm\" form { <1,0,1> }" + end,
       "the orthorhombic system needs 'axial_ratio' or 'cell'"},
      {"crystal { axial_ratio { 1.1 } form { <1,0,1> }" + end,
       "forms need a 'point_group' (or 'system') to find their faces"},
      {"crystal { cdl \"trigonal[32]:{10-10}@1.0 + {1010}\"" + end,
       "CDL, character 29: Miller-Bravais indices (h k i l) need h + k + i = 0"},
      {"crystal { system \"cubic\" form { <1,0,-1,0>, 1 }" + end,
       "four indices (h k i l) belong to hexagonal axes"},
      {quartz + prism_and_tips + "twin { law \"japan\" individuals 900 thickness 0.001 }" + end,
       "a twin with more than 10000 faces in all its individuals"},
      {"crystal { facet x, 1 size 3" + end, "'size' belongs to a crystal of forms"},
      {"crystal { facet x, 1 left" + end, "'left' and 'enantiomorph' belong to a crystal of forms"},
      {quartz + prism_and_tips + "twin { law \"japn\" }" + end,
       "unknown twin law 'japn' in 'twin'; did you mean 'japan'?"},
      {quartz + prism_and_tips + "twin { contact <1,0,0> }" + end,
       "a twin has a 'law', or an 'axis', 'normal' or 'plane': one of them"},
      {"intersection { " + quartz + prism_and_tips + "twin { law \"japan\" } } box { -1, 1 }" + end,
       "a twin cannot be cut; 'facet' inside it cuts its individuals"}};
  for (const Bad& row : bad) {
    const Bound b = bind_text(lit + row.text);
    CAPTURE(std::string(row.message));
    CHECK_MESSAGE(b.text().find(row.message) != std::string::npos, b.text());
    CHECK(b.parsed->diagnostics.failed());
  }
}

TEST_CASE("the vocabulary lists the words of crystals, twins and gems") {
  const std::string words = vocabulary();
  for (const char* word : {"`point_group", "`axial_ratio { }`", "`cell { }`", "`form { }`", "`cdl",
                           "### twin", "`contact", "### gem", "`gemcad", "`index_gear", "`meet"}) {
    CAPTURE(std::string(word));
    CHECK(words.find(word) != std::string::npos);
  }
}

TEST_CASE("too many faces are refused") {
  std::string text = "crystal { system \"cubic\" ";
  for (int i = 1; i <= 260; ++i) text += "form { <" + std::to_string(i) + ",300,700> } ";
  const Bound b = bind_text(lit + text + glass + "}");
  CHECK(b.text().find("a crystal with more than 10000 faces") != std::string::npos);
}

}  // namespace nicol
