// Any bytes are a scene: parsed, printed and parsed again, bound, built to solids, packed. Whatever is
// wrong with it is told; nothing crashes, hangs or is undefined. Bytes that begin with a zero are not text:
// scenes are made of them (grammar.hpp), which get as far as the solids more often. TELL=1: what is said of it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "host/bind/bind.hpp"
#include "host/features.hpp"
#include "host/pack.hpp"
#include "host/solids/solids.hpp"
#include "sdl/parse.hpp"
#include "tests/fuzz/grammar.hpp"
#include "tests/fuzz/mutator.hpp"

namespace {

using namespace nicol;

// Every word of the language and of what bind reads.
const std::vector<std::string>& words() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
#define KEYWORD(name, kind) list.emplace_back(std::string(#kind) == "directive" ? "#" #name : #name);
#include "sdl/keywords.def"
#undef KEYWORD
    const std::string tables = vocabulary();
    for (std::size_t at = tables.find("| `"); at != std::string::npos; at = tables.find("| `", at + 3))
      list.push_back(tables.substr(at + 3, tables.find_first_of(" `", at + 3) - at - 3));
    return list;
  }();
  return all;
}

std::size_t faces_of(const ConvexShape& shape) { return shape.faces.size(); }
std::size_t faces_of(const PrismShape& shape) {
  std::size_t count = 2;
  for (const auto& contour : shape.contours) count += contour.size();
  return count;
}
std::size_t faces_of(const PolygonShape& shape) {
  std::size_t count = 1;
  for (const auto& contour : shape.contours) count += contour.size();
  return count;
}
std::size_t faces_of(const DiscShape&) { return 1; }
std::size_t faces_of(const MeshShape& shape) { return shape.faces.size(); }
std::size_t faces_of(const CsgShape::Node& node) {
  // each operand of a tree may cut all the others
  std::size_t count = std::visit([](const auto& leaf) { return faces_of(leaf); }, node.leaf);
  for (const CsgShape::Node& operand : node.operands) count += 2 * faces_of(operand);
  return count;
}
std::size_t faces_of(const CsgShape& shape) { return faces_of(shape.root); }

// Larger scenes are right to take their time.
bool is_small(const Scene& scene) {
  std::size_t faces = 0;
  for (const Object& object : scene.objects)
    faces += std::visit([](const auto& shape) { return faces_of(shape); }, object.shape);
  return scene.objects.size() <= 16 && faces <= 120 && scene.lambda_nm.size() <= 200;
}

void build(const Scene& scene, sdl::Diagnostics& diagnostics) {
  const Geometry geometry = build_geometry(scene, diagnostics);
  if (diagnostics.failed()) return;
  const Features features = decide_features(scene, geometry);
  for (int lanes : {1, 8}) pack(scene, geometry, features.mask, 8, 6, lanes);
}

void print_and_parse(const sdl::Result& result, const sdl::Options& options) {
  std::size_t weight = 0;
  for (const sdl::Item& item : result.document.items) weight += item.block()->weight;
  if (weight > 2000) return;
  sdl::Result again;
  parse_text("again.pov", print(result.document), options, again);
  if (again.diagnostics.failed() || !equal(result.document, again.document)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sdl::Options options;
  options.limits.steps = 60'000;
  options.limits.items = 60'000;
  options.limits.file_bytes = 1 << 20;
  for (const char* folder : {"include", "founding", "gems", "conical"})
    options.library_paths.push_back(std::string(NICOL_SCENES) + "/" + folder);
  options.debug = [](const std::string&) {};
  const std::string text = size > 0 && data[0] == 0 ? fuzz::scene_of_bytes(data + 1, size - 1)
                                                    : std::string(reinterpret_cast<const char*>(data), size);
  sdl::Result result;
  parse_text("fuzz.pov", text, options, result);
  if (!result.diagnostics.failed()) print_and_parse(result, options);
  BindOptions bind_options;
  bind_options.width = 8;
  bind_options.height = 6;
  bind_options.library_paths = options.library_paths;
  const Scene scene = bind(result.document, bind_options, result.diagnostics);
  if (!result.diagnostics.failed() && is_small(scene)) build(scene, result.diagnostics);
  const std::string told = result.diagnostics.text();
  if (result.diagnostics.failed() && told.empty()) std::abort();
  if (std::getenv("TELL")) std::fprintf(stderr, "%s\n%s", text.c_str(), told.c_str());
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (size > 0 && data[0] == 0) return LLVMFuzzerMutate(data, size, most);
  return fuzz::mutate_input(data, size, most, seed, words());
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size, const std::uint8_t* two,
                                                 std::size_t two_size, std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  if (one_size == 0 || two_size == 0 || one[0] == 0 || two[0] == 0) return 0;
  return fuzz::cross_over(one, one_size, two, two_size, out, most, seed, words());
}
