// What a manifest may say: every fault is told with its file, line and column.
#include <doctest/doctest.h>

#include "host/fragments/manifest.hpp"
#include "tests/fragments/shots.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

const std::string source = "FUNCTION void x(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {}\n";

// What reading this manifest, with this OpenCL C beside it, ends with; "" if all is well. The folder's name is left out.
std::string told(const std::string& json, const std::string& text = source) {
  const std::string folder = new_folder("manifests");
  write(folder + "/x.json", json);
  write(folder + "/x.cl", text);
  try {
    read_manifest(folder + "/x.json");
  } catch (const ManifestError& error) {
    const std::string what = error.what();
    CHECK(what.compare(0, folder.size() + 1, folder + "/") == 0);
    return what.substr(folder.size() + 1);
  }
  return "";
}

std::string with(const std::string& more) {
  return "{ \"name\": \"x\", \"version\": \"1\", \"nicol\": 1, \"kind\": \"element\", \"meaning\": \"m\"" + more + " }";
}

bool begins(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

}  // namespace

TEST_CASE("a manifest that says all there is to say") {
  CHECK(told(with(R"(, "source": "s", "needs": ["reflection", "fp64"], "reciprocal": false, "lossless": true,
    "parameters": [{ "name": "a", "unit": "nm", "default": 2, "min": 1, "max": 3, "meaning": "m" }])")) == "");
  const Manifest made = read_manifest(std::string(NICOL_SCRATCH_FOLDER) + "/manifests/x.json");
  CHECK(made.fragment->reflects);
  CHECK(made.fragment->needs_fp64);
  CHECK(!made.fragment->reciprocal);
  CHECK(made.fragment->lossless);
  CHECK(made.fragment->text == source);
  REQUIRE(made.parameters.size() == 1);
  CHECK(made.parameters[0].number == 2);
  CHECK(made.parameters[0].least == 1);
}

TEST_CASE("faults with their places") {
  CHECK(begins(told("{ \"name\":\n  oops }"), "x.json:2:3: this is not JSON"));
  CHECK(begins(told("[]"), "x.json:1:1: a manifest is an object"));
  CHECK(begins(told(with(",\n \"colour\": 1")), "x.json:2:2: 'colour' is no key of a manifest"));
  CHECK(begins(told("{ \"version\": \"1\" }"), "x.json:1:1: 'name' is missing"));
  CHECK(begins(told("{ \"name\": \"two words\" }"), "x.json:1:3: 'two words' is no name"));
  CHECK(begins(told("{ \"name\": \"x\", \"version\": \"1\", \"nicol\": 7 }"), "x.json:1:32: written for version 7"));
  CHECK(begins(told(with(", \"kind\": \"lens\"")), "x.json:1:"));
  CHECK(begins(told(with(",\n\"needs\": [\"luck\"]")), "x.json:2:1: \"luck\" is nothing that"));
  CHECK(begins(told(with(",\n\"parameters\": [{ \"name\": \"a\", \"meaning\": \"m\", \"min\": 2, \"max\": 1 }]")), "x.json:2:26: 'min', 'default' and 'max'"));
  CHECK(begins(told(with(",\n\"parameters\": [{ \"name\": \"a\", \"meaning\": \"m\", \"step\": 2 }]")), "x.json:2:47: 'step' is no key of a parameter"));
  CHECK(begins(told(with(",\n\"lossless\": 1")), "x.json:2:1: 'lossless' is true or false"));
  CHECK(begins(told("{ \"version\": \"1\",\n \"name\": \"y\" }"), "x.json:2:2: 'name' is 'y', but the manifest's file is 'x.json'"));
  CHECK(begins(told(with(""), "\n#include \"portable.h\"\n"), "x.cl:2: a fragment includes nothing"));
}

TEST_CASE("faults of parameters stand at the parameter") {
  const auto of_two = [](const std::string& second) {
    return told(with(",\n\"parameters\": [\n{ \"name\": \"x\", \"meaning\": \"} \\\" {\" },\n { " + second + " }]"));
  };
  CHECK(of_two("\"name\": \"depth\"") == "x.json:4:2: 'meaning' is missing in the parameter 'depth'");
  CHECK(of_two("\"meaning\": \"m\"") == "x.json:4:2: 'name' is missing in a parameter");
  CHECK(of_two("\"name\": \"depth\", \"meaning\": 3") == "x.json:4:21: 'meaning' is a text");
  CHECK(begins(of_two("\"name\": \"x\", \"meaning\": \"m\""), "x.json:4:12: the parameter 'x' stands here twice"));
}

TEST_CASE("OpenCL C that lacks the function, or has names that could be others'") {
  const std::string other = "FUNCTION void x2(PRIVATE const ElementIn* in, GLOBAL const scalar* parameter, PRIVATE ElementOut* out) {}  // x\n";
  const std::string missing = told(with(""), other);
  CHECK(begins(missing, "x.json:1:3: "));
  CHECK(missing.find("/x.cl has no function 'x'") != std::string::npos);
  CHECK(begins(told(with(""), source + "FUNCTION real helper(real a) { return a; }\n"), "x.cl:2: 'helper' must begin with 'x'"));
  CHECK(begins(told(with(""), source + "FUNCTION real x_f(real a) { return x_f(a); }\n"), "x.cl:2: 'x_f' calls itself"));
}

TEST_CASE("a surface is reciprocal and reflects anyway") {
  const std::string surface = "{ \"name\": \"x\", \"version\": \"1\", \"nicol\": 1, \"kind\": \"surface\", \"meaning\": \"m\"";
  CHECK(begins(told(surface + ",\n\"reciprocal\": false }"), "x.json:2:1: a surface is reciprocal"));
  CHECK(begins(told(surface + ",\n\"needs\": [\"reflection\"] }"), "x.json:2:1: "));
  CHECK(told(surface + " }") == "");
}

TEST_CASE("a manifest alone") {
  const std::string folder = new_folder("alone");
  write(folder + "/x.json", with(""));
  CHECK_THROWS_WITH_AS(read_manifest(folder + "/x.json"), doctest::Contains("x.cl' cannot be read"), ManifestError);
}

TEST_CASE("a scene tells a manifest's faults at its own place") {
  write(new_folder("faulty") + "/faulty.json", "{ \"name\": }");
  const std::string errors =
      read("camera { location -z look_at 0 }\ndisc { 0, z, 1 polarizer { plugin { \"faulty\" } angle 0 } }").errors;
  CHECK(errors.find("line 2") != std::string::npos);
  CHECK(errors.find("faulty.json:1:11: this is not JSON") != std::string::npos);
}
