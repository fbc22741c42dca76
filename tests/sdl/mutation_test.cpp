// Scenes damaged at random, for a few seconds: no crash, no hang, and good ones still print and parse.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "parsed.hpp"

using namespace sdl_test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const auto& entry : fs::directory_iterator(fs::path(SDL_TEST_FOLDER) / "bad")) {
    if (entry.path().extension() != ".pov") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  for (const char* good :
       {"#version 3.7; #declare T = texture { a } texture { b } #macro M(A, B) sphere { A*x, B "
        "texture { T } } #end #for (i, 0, 3) M(i, 1) #end",
        "#declare F = function(a) { sin(a)*2 } box { 0, F(1) }",
        "#declare I = 0; union { #while (I < 3) box { I, I+1 } #declare I = I+1; #end }",
        "camera { location <0, 1, -5> look_at 0 right x*image_width/image_height angle 45 }",
        "#declare A = array[2] {1, 2} #if (A[1] > 1) sphere { A[0]*y, A[1] } #else a { } #end",
        "light_source { <1,2,3>, rgb <1,1,1>*.5 spotlight } plane { y, -1 pigment { checker } }"}) {
    for (int copies = 0; copies < 6; ++copies) texts.emplace_back(good);
  }
  return texts;
}

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

std::string damaged(std::string text, const std::string& other, Random& random) {
  static const std::string marks = "{}[]()<>#;,.\"+-*/!&|?:=\\ \n0129xyzAe_$\xc3\x80";
  for (std::size_t i = below(random, below(random, 6)) + 1; i > 0; --i) {
    const std::size_t at = below(random, text.size()), length = below(random, 20);
    switch (below(random, 5)) {
      case 0: text.insert(at, 1, marks[below(random, marks.size())]); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(below(random, text.size()), length)); break;
      case 3: text.insert(at, other.substr(below(random, other.size()), length * 2)); break;
      default:
        if (!text.empty()) text[at] = static_cast<char>(random());
        break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("damaged scenes") {
  const std::vector<std::string> texts = seeds();
  Random random(20240607);
  Options options;
  options.limits.steps = 50'000;
  options.limits.items = 50'000;
  const int count = 6000;
  int good = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = damaged(texts[below(random, texts.size())], texts[below(random, texts.size())], random);
    Parsed parsed(text, options);
    parsed.result.diagnostics.text();
    if (parsed.result.diagnostics.failed()) continue;
    ++good;
    CAPTURE(text);
    Parsed again(print(parsed.result.document));
    REQUIRE(again.messages() == "");
    REQUIRE(equal(parsed.result.document, again.result.document));
  }
  MESSAGE(count << " damaged scenes, " << good << " still good");
  CHECK(good > 20);
}
