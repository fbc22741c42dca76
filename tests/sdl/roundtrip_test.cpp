// parse(print(x)) is x: for random trees, and for what random scene texts yield.
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "parsed.hpp"

using namespace sdl_test;

namespace {

double random_number() {
  const int kind = *rc::gen::inRange(0, 6);
  if (kind == 0) return *rc::gen::inRange(-3, 4);
  if (kind == 1) return *rc::gen::arbitrary<double>();
  if (kind == 2) return std::ldexp(*rc::gen::arbitrary<double>(), *rc::gen::inRange(-1100, 1000));
  if (kind == 3) return *rc::gen::element(HUGE_VAL, -HUGE_VAL, std::nan(""), -0.0, 5e-324);
  return *rc::gen::inRange(-1000, 1000) / 64.0;
}

Vector random_vector() {
  Vector v;
  v.colour = *rc::gen::inRange(0, 3) == 0;
  v.size = v.colour ? 5 : *rc::gen::inRange(2, 6);
  for (int i = 0; i < v.size; ++i) v.v[static_cast<std::size_t>(i)] = random_number();
  return v;
}

std::string random_word() {
  return *rc::gen::element<std::string>("rotate", "box", "filter", "transmit", "all", "ior", "a_1", "min", "range", "red",
                                       "srgb");
}

Item random_item(int depth);

BlockPtr random_block(int depth) {
  auto block = std::make_shared<Block>();
  const int kind = depth > 0 ? *rc::gen::inRange(0, 8) : 2;
  if (kind == 0) {
    block->name = "<";  // more numbers than a vector has
    for (int i = *rc::gen::inRange(6, 15); i > 0; --i) block->items.push_back({random_number(), {}});
    return block;
  }
  block->name = kind == 1 ? "[" : *rc::gen::element<std::string>("sphere", "texture", "_x9", "interior");
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) block->items.push_back(random_item(depth + 1));
  return block;
}

Item random_item(int depth) {
  switch (*rc::gen::inRange(0, depth < 5 ? 5 : 4)) {
    case 0: return {Word{random_word()}, {}};
    case 1: return {random_number(), {}};
    case 2: return {random_vector(), {}};
    case 3: return {*rc::gen::arbitrary<std::string>(), {}};
    default: return {random_block(depth), {}};
  }
}

// Text made of pieces that belong to the language, in any order.
std::string random_text() {
  static const std::vector<std::string> pieces{
      "sphere { ", "box { ", "} ", "} ", "} ", "0, ", "1 ", "-2.5 ", "<1,2,3> ", "x*30 ", "rotate ", "rgb 1 ",
      "color red 1 ", "filter .5 ", "[0 ", "] ", "\"text\" ", "#declare A = 3; ", "A ", "A*2 ",
      "#declare T = texture { a 1 } ", "T ", "#if (A > 2) ", "#else ", "#end ", "#for (i, 0, 2) ",
      "i ", "#macro M(P) P 1 #end ", "M(4) ", "M(A) ", "#while (0) ", "matrix <1,2,3,4,5,6,7,8,9,10,11,12> ",
      "<1,2,3,4,5,6,7> ", "function { x + y } ", "union { ", ", ", "on ", "sin(1) ", "concat(\"a\",\"b\") ",
      "#switch (1) #case (1) ", "#break ", "#local A = <1,2>; ", "#undef A ", "pi "};
  std::string text;
  for (int i = *rc::gen::inRange(0, 30); i > 0; --i) text += *rc::gen::elementOf(pieces);
  return text;
}

}  // namespace

TEST_CASE("random trees print to text that parses to the same trees") {
  const bool holds = rc::check("parse(print(tree)) = tree", [] {
    Document document;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) document.items.push_back({random_block(0), {}});
    const std::string text = print(document);
    Parsed again(text);
    RC_LOG() << text << again.messages();
    RC_ASSERT(again.messages().empty());
    RC_ASSERT(equal(document, again.result.document));
  });
  CHECK(holds);
}

TEST_CASE("what random texts yield prints to text that parses to the same") {
  int good = 0;
  const bool holds = rc::check("parse(print(parse(text))) = parse(text)", [&good] {
    Options options;
    options.limits.steps = 20'000;
    const std::string text = random_text();
    Parsed first(text, options);
    if (first.result.diagnostics.failed()) return;
    ++good;
    Parsed again(print(first.result.document));
    RC_LOG() << text << again.messages();
    RC_ASSERT(again.messages().empty());
    RC_ASSERT(equal(first.result.document, again.result.document));
  });
  CHECK(holds);
  CHECK(good > 3);
}

TEST_CASE("trees that differ are not equal") {
  CHECK(tree_of("a { 1 }", "a { 1 }") == "same");
  for (const char* other : {"a { 2 }", "b { 1 }", "a { 1 1 }", "a { <1,1> }", "a { \"1\" }", "a { one }", "a {}",
                            "a { 1 } a { 1 }"}) {
    CHECK(tree_of("a { 1 }", other) != "same");
  }
  CHECK(tree_of("a { rgb <1,2,3> }", "a { <1,2,3,0,0> }") != "same");
}
