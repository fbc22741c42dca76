// Bad scenes and all that is said of them, byte by byte: bad/NAME.pov and bad/NAME.txt.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "parsed.hpp"

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE_MESSAGE(in, path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("what is said of bad scenes") {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SDL_TEST_FOLDER) / "bad")) {
    if (entry.path().extension() != ".pov") continue;
    ++count;
    CAPTURE(entry.path().filename().string());
    nicol::sdl::Result result;
    nicol::sdl::parse_text(entry.path().filename().string(), content(entry.path()), {}, result);
    fs::path expected = entry.path();
    CHECK(result.diagnostics.text() == content(expected.replace_extension(".txt")));
  }
  CHECK(count >= 35);
}
