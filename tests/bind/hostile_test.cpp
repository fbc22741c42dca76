// Trees made to exhaust, built by hand because the parser refuses the like: each ends in an error.
#include "bound.hpp"

namespace nicol {

namespace {

using Pieces = std::vector<decltype(sdl::Item::value)>;

sdl::BlockPtr block(const char* name, const Pieces& pieces) {
  auto b = std::make_shared<sdl::Block>();
  b->name = name;
  for (const auto& piece : pieces) {
    sdl::Item item;
    item.value = piece;
    b->items.push_back(item);
  }
  return b;
}

sdl::Vector vector(double x, double y, double z) {
  sdl::Vector v;
  v.v[0] = x;
  v.v[1] = y;
  v.v[2] = z;
  return v;
}

sdl::BlockPtr interior() { return block("interior", {sdl::Word{"ior"}, 1.5}); }
sdl::BlockPtr box() { return block("box", {vector(0, 0, 0), vector(1, 1, 1), interior()}); }

// 40 levels of blocks that each hold the one before twice.
sdl::BlockPtr doubled(sdl::BlockPtr inner, const char* name, const Pieces& besides = {}) {
  for (int i = 0; i < 40; ++i) {
    Pieces pieces = {inner, inner};
    pieces.insert(pieces.end(), besides.begin(), besides.end());
    inner = block(name, pieces);
  }
  return inner;
}

void check_refused(const sdl::BlockPtr& top, const char* message) {
  sdl::Document document;
  document.items.push_back({});
  document.items[0].value = top;
  const sdl::Sources sources;
  sdl::Diagnostics diagnostics(sources);
  bind(document, {}, diagnostics);
  bool told = false;
  for (const auto& d : diagnostics.all())
    told = told || d.message.find(message) != std::string::npos;
  CHECK_MESSAGE(told, message);
}

}  // namespace

TEST_CASE("shared objects doubled forty times") {
  check_refused(doubled(box(), "union"), "more than 1000000 objects");
  check_refused(doubled(box(), "union", {sdl::Word{"translate"}, vector(1, 0, 0)}),
                "transforms once every");
}

TEST_CASE("shared planes doubled forty times") {
  check_refused(doubled(block("plane", {vector(1, 0, 0), 1.0}), "intersection"),
                "more than 10000 faces");
}

TEST_CASE("unions of nothing doubled forty times") {
  check_refused(doubled(block("union", {}), "union"), "too large");
}

TEST_CASE("interiors, spectra and transforms doubled forty times") {
  const auto inside_box = [](const sdl::BlockPtr& b) {
    return block("box", {vector(0, 0, 0), vector(1, 1, 1), interior(), b});
  };
  check_refused(inside_box(doubled(interior(), "interior")), "too large");
  check_refused(
      inside_box(doubled(block("transform", {sdl::Word{"rotate"}, vector(1, 0, 0)}), "transform")),
      "");
  check_refused(block("background", {doubled(block("spectrum", {sdl::Word{"d65"}}), "spectrum")}),
                "too large");
  check_refused(
      block("surroundings",
            {block("interior", {doubled(block("index", {sdl::Word{"constant"}, 1.5}), "index")})}),
      "too large");
}

TEST_CASE("blocks nested deeper than a stack") {
  sdl::BlockPtr inner = box();
  for (int i = 0; i < 2000; ++i) inner = block("object", {inner});
  check_refused(inner, "deep in each other");
  inner = interior();
  for (int i = 0; i < 2000; ++i) inner = block("interior", {inner});
  check_refused(block("box", {vector(0, 0, 0), vector(1, 1, 1), inner}), "deep in each other");
}

TEST_CASE("thousands of faults are cut short") {
  std::string text = lit;
  for (int i = 0; i < 1000; ++i) text += "sphere { 0, " + std::to_string(i + 1) + " }\n";
  const Bound b = bind_text(text);
  CHECK(b.parsed->diagnostics.all().size() <= 210);
  CHECK(b.text().find("the rest is not shown") != std::string::npos);
}

TEST_CASE("numbers that are none") {
  check_refused(block("box", {vector(0, 0, 0), vector(1, HUGE_VAL, 1), interior()}), "not finite");
  check_refused(block("camera", {sdl::Word{"angle"}, std::nan("")}), "not finite");
  check_refused(block("box", {vector(0, 0, 0), vector(1, 1, 1), sdl::Word{"scale"}, 1e-300,
                              sdl::Word{"scale"}, 1e-300, interior()}),
                "");
}

}  // namespace nicol
