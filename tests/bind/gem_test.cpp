// `gem { }` and scenes/include/cuts.inc: facets counted on the exact solids.
#include "built.hpp"

#include <filesystem>
#include <fstream>

namespace nicol {

namespace {

const std::string cuts = "#include \"cuts.inc\"\n";

double tan_deg(double angle_deg) { return std::tan(angle_deg * 3.14159265358979323846 / 180); }

std::size_t facets(const Built& b, std::size_t cell) { return b.cell(cell).face_count; }

}  // namespace

TEST_CASE("the standard brilliant has 57 facets and a girdle of 16; a culet makes it 58") {
  const Built b = build_text(cuts + "object { Standard_Brilliant(6.5, 0.53, 34.5, 40.75)" + glass +
                             "} object { Brilliant(6.5, 0.53, 34.5, 40.75, 0.5, 0.75, 0.02, 0.02)" +
                             glass + "translate 10*x }");
  REQUIRE(b.cells() == 2);
  CHECK(facets(b, 0) == 57 + 16);
  CHECK(facets(b, 1) == 58 + 16);
  CHECK(b.smallest_area(0) > 0.01);
  // Tolkowsky (1919): crown 16.2 %, pavilion 43.1 % of the diameter; the girdle adds 2 %.
  double top = 0, bottom = 0, widest = 0;
  for (int f = 0; f < b.cell(0).face_count; ++f) {
    for (const Vec3& p : b.geometry.faces[b.cell(0).first_face + f].corners) {
      top = std::max(top, p.y);
      bottom = std::min(bottom, p.y);
      widest = std::max(widest, std::hypot(p.x, p.z));
    }
  }
  CHECK(widest == doctest::Approx(3.25).epsilon(1e-12));
  CHECK(top == doctest::Approx(6.5 * (0.01 + 0.47 / 2 * tan_deg(34.5))).epsilon(1e-12));
  CHECK(bottom == doctest::Approx(-6.5 * (0.01 + 0.5 * tan_deg(40.75))).epsilon(1e-12));
}

TEST_CASE("step cut and trillion have all their facets") {
  const Built b = build_text(cuts + "object { Step_Cut(6, 8, 0.6, 0.15, 46, 60, 0.03)" + glass +
                             "} object { Trillion(6, 0.55, 38, 43, 0.03)" + glass +
                             "translate 20*x }");
  REQUIRE(b.cells() == 2);
  CHECK(facets(b, 0) == 24 + 1 + 8 + 24);
  CHECK(facets(b, 1) == 9 + 1 + 9 + 9);
  CHECK(b.smallest_area(0) > 0.01);
  CHECK(b.smallest_area(1) > 0.01);
}

TEST_CASE("a gem stands table up, tooth 0 away from the viewer, and its crystal's c along the table's normal") {
  const Built b = build_text("gem { table 1 culet 2 facet { angle 90 index 96, 48 distance 3 }"
                             " facet { angle 90, index 24, 72, distance 4 }"
                             " interior { ordinary { constant 1.5 } extraordinary { constant 1.6 } } }");
  REQUIRE(b.cells() == 1);
  CHECK(facets(b, 0) == 6);
  CHECK(b.volume(0) == doctest::Approx(3 * 6 * 8).epsilon(1e-14));
  check_near(b.medium(0).frame_at(0)[2], {0, 1, 0});
}

TEST_CASE("size is the width across the girdle; meet puts a facet through a point") {
  const Built b = build_text("gem { facet { angle 90 index 24, 48, 72, 96 distance 3 } table 1"
                             " facet { angle -45 index 24, 48, 72, 96 meet <3, -1, 0> } size 2" +
                             glass + "}");
  REQUIRE(b.cells() == 1);
  // Prism of 2 x 2 x 2/3 over a pyramid of height 1.
  CHECK(b.volume(0) == doctest::Approx(4 * 2 / 3.0 + 4 / 3.0).epsilon(1e-13));
}

TEST_CASE("a cut is read from GemCad's text, found beside the scene's libraries") {
  const std::string name = "nicol_gem_test_" + std::to_string(std::hash<std::string>()(__FILE__)) + ".asc";
  const auto path = std::filesystem::temp_directory_path() / name;
  std::ofstream(path) << "GemCad 5.0\ng 96 0.0\ny 4 y\nI 1.54\n"
                         "a -90 1.0 96 24 48 72\na 0 0.5 96\na -45 0.8 96 24 48 72 n P\n";
  BindOptions options;
  options.library_paths = {std::filesystem::temp_directory_path().string()};
  const Bound b = bind_clean(lit + "gem { gemcad \"" + name + "\"" + glass + "}", options);
  CHECK(std::get<ConvexShape>(b.scene.objects.at(0).shape).faces.size() == 9);
  std::ofstream(path) << "g 96 0\na 41 x 3\n";
  CHECK(bind_text(lit + "gem { gemcad \"" + name + "\"" + glass + "}", options)
            .text()
            .find("line 2: expected the distance of a facet, 'x' found instead") != std::string::npos);
  std::filesystem::remove(path);
  const auto binary = std::filesystem::path(path).replace_extension(".gem");
  std::ofstream(binary) << "x";
  CHECK(bind_text(lit + "gem { gemcad \"" + binary.string() + "\"" + glass + "}")
            .text()
            .find("'.gem' is GemCad's binary format, which is not published") != std::string::npos);
  std::filesystem::remove(binary);
}

TEST_CASE("bad gems are told what is wrong") {
  struct Bad {
    std::string text;
    const char* message;
  };
  const Bad bad[] = {
      {"gem { facet { angle 41 distance 1 }" + glass + "}", "a facet has 'index'"},
      {"gem { facet { index 96 distance 1 }" + glass + "}", "a facet has 'angle'"},
      {"gem { facet { angle 41 index 96 }" + glass + "}", "a facet has 'distance' or 'meet'"},
      {"gem { facet { angle 41 index 96 distance 1 meet <1,0,0> }" + glass + "}",
       "a facet has 'distance' or 'meet', not both"},
      {"gem { facet { angle 91 index 96 distance 1 }" + glass + "}",
       "a facet's angle lies between -90 and 90 degrees from the girdle plane"},
      {"gem { index_gear 0 }", "a gear has at least one tooth"},
      {"gem { size 3" + glass + "}", "Expected 'facet', } of 'gem' found instead"},
      {"gem { facet { angle 41 index 96 distance 1 } size 3" + glass + "}",
       "'size' needs a girdle: facets of angle 90"},
      {"gem { facet { angle 90 index 24, 48, 72, 96 distance 1 } table 1" + glass + "}",
       "this gem is open towards <0, -1, 0>: no facet closes it there"},
      {"gem { gemcad \"no_such_cut.asc\"" + glass + "}", "Cannot find file 'no_such_cut.asc'."}};
  for (const Bad& row : bad) {
    const Bound b = bind_text(lit + row.text);
    CAPTURE(std::string(row.message));
    CHECK_MESSAGE(b.text().find(row.message) != std::string::npos, b.text());
    CHECK(b.parsed->diagnostics.failed());
  }
}

}  // namespace nicol
