// The genuine include files of POV-Ray load, whole chains of them. Needs Debian's povray-includes.
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "parsed.hpp"

using namespace sdl_test;

namespace {

Options with_includes() {
  Options options;
  options.library_paths.push_back(POVRAY_INCLUDES);
  return options;
}

std::string including(const std::string& names, const std::string& then = "") {
  std::string text = "#version 3.7;\n";
  std::string name;
  for (char c : names + ' ') {
    if (c != ' ') name += c;
    else if (!name.empty()) text += "#include \"" + std::exchange(name, "") + "\"\n";
  }
  Parsed parsed(text + then, with_includes());
  return parsed.result.diagnostics.failed() ? parsed.result.diagnostics.text() : parsed.debug + "ok";
}

}  // namespace

TEST_CASE("povray-includes is installed") {
  REQUIRE_MESSAGE(std::filesystem::exists(POVRAY_INCLUDES "/colors.inc"),
                  "install the Debian package povray-includes");
}

TEST_CASE("each include file loads by itself") {
  // Skies and stones take their colours from colors.inc; the others include what they need.
  for (const char* name :
       {"colors.inc", "math.inc", "transforms.inc", "shapes.inc", "consts.inc", "functions.inc", "strings.inc",
        "rand.inc", "arrays.inc", "textures.inc", "finish.inc", "glass.inc", "glass_old.inc", "golds.inc",
        "metals.inc", "colors.inc stones.inc", "colors.inc stones1.inc", "colors.inc stones2.inc", "colors.inc stoneold.inc", "woods.inc", "woodmaps.inc",
        "colors.inc skies.inc", "stars.inc", "shapes2.inc", "shapes3.inc", "shapes_old.inc", "shapesq.inc", "ior.inc",
        "logo.inc", "chars.inc", "debug.inc", "makegrass.inc", "meshmaker.inc", "rad_def.inc", "screen.inc",
        "stage1.inc", "stdcam.inc", "stdinc.inc", "sunpos.inc"}) {
    CAPTURE(name);
    CHECK(including(name) == "ok");
  }
}

TEST_CASE("what they declare works") {
  CHECK(including("colors.inc", "#debug vstr(3, CHSL2RGB(<120,1,.5>), \",\", 1, 2)") == "0.00,1.00,0.00ok");
  CHECK(including("math.inc", "#debug concat(str(clamp(7,0,5),1,0), str(even(4),1,0))") == "21ok");
  CHECK(including("transforms.inc", "#debug vstr(3, vtransform(x, transform { rotate 90*z translate y }) + 1, "
                                    "\",\", 1, 2)") == "1.00,3.00,1.00ok");
  CHECK(including("transforms.inc", "box { 0, 1 Rotate_Around_Trans(90*y, x) }") == "ok");
  CHECK(including("math.inc", "#debug vstr(3, VPerp_Adjust(<1,1,0>, x), \",\", 1, 2)") == "0.00,1.00,0.00ok");
  CHECK(including("glass.inc", "sphere { 0, 1 interior { I_Glass } }") == "ok");
  CHECK(including("shapes.inc", "Round_Box(<0,0,0>, <1,1,1>, .1, 1)") == "ok");
  CHECK(including("strings.inc", "#debug VStr(<1,2,3>)") == "<1.000000,2.000000,3.000000>ok");
}

TEST_CASE("texts handed in come before files, each asked for once") {
  std::vector<std::string> asked;
  Options options = with_includes();
  options.include = [&](const std::string& name) -> std::optional<std::string> {
    asked.push_back(name);
    if (name == "colors.inc") return "#declare Red = 7;";
    if (name == "broken.inc") return "#declare A = 1;\n#declare B = ;";
    return std::nullopt;
  };
  Parsed parsed("#include \"colors.inc\"\n#include \"colors.inc\"\n#include \"consts.inc\"\n#debug str(Red + (pi > 3), 1, 0)", options);
  CHECK(parsed.messages() == "");
  CHECK(parsed.debug == "8");
  CHECK(asked == std::vector<std::string>{"colors.inc", "consts.inc"});
  Parsed broken("#include \"broken.inc\"\n#include \"nowhere.inc\"", options);
  REQUIRE(broken.result.diagnostics.all().size() == 2);
  const Diagnostic& first = broken.result.diagnostics.all()[0];
  CHECK(broken.result.sources.name(first.where.file) == "broken.inc");
  CHECK(first.where.line == 2);
  CHECK(broken.messages().find("Cannot open include file nowhere.inc") != std::string::npos);
}

TEST_CASE("a text handed in is held to the limits of files") {
  Options options;
  options.limits.file_bytes = 100;
  options.include = [](const std::string&) { return std::string(200, ' '); };
  Parsed parsed("#include \"large.inc\"", options);
  CHECK(parsed.result.diagnostics.text().find("it is too large") != std::string::npos);
}
