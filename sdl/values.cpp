// What may stand right of `=` or be passed to a macro: blocks, arrays, strings, functions, numbers.
#include <cmath>

#include "parser.hpp"

namespace nicol::sdl {

Value Parser::rvalue(bool is_argument) {
  Token token = next_value();
  if (token.is(Keyword::k_array)) return array_value();
  if (token.is(Keyword::k_function)) return function_value();
  if (starts_string(token)) {
    push_back(std::move(token));
    return string_value();
  }
  if (token.undeclared()) {
    if (peek_operator().is('{')) return layers(token);
    fail_with(token, is_argument ? "Cannot pass uninitialized identifier as macro parameter. "
                                   "Initialize identifier first."
                                 : "Cannot assign uninitialized identifier.");
  }
  if (token.holds<BlockPtr>() && !calls_spline(token)) return token.cell->value;
  if (token.holds<ArrayPtr>()) return copied(token.cell->value, budget_);
  if (token.holds<FunctionPtr>() && !peek_operator().is('(')) return token.cell->value;
  if (token.keyword_class() == KeywordClass::colour ||
      token.keyword_class() == KeywordClass::channel) {
    return colour(std::move(token));
  }
  push_back(std::move(token));
  return sum();
}

// `array [n]... [{ ... }]`
Value Parser::array_value() {
  constexpr std::size_t most_dimensions = 5;  // POV-Ray's
  std::vector<std::size_t> dimensions;
  std::size_t count = 1;
  const Location where = last_;
  const std::size_t most = options_.limits.items;
  while (peek_operator().is('[')) {
    next();
    Group group(*this);
    const double size = number();
    group.close(']');
    if (!(size >= 1)) throw Failure{where, "Invalid dimension size for an array"};
    if (dimensions.size() == most_dimensions) throw Failure{where, "Too many array dimensions"};
    if (size > static_cast<double>(most / count)) throw Failure{where, "Too large an array."};
    dimensions.push_back(static_cast<std::size_t>(size));
    count *= dimensions.back();
  }
  if (dimensions.empty()) {
    throw Failure{where, "An array declaration must have at least one dimension"};
  }
  auto array = std::make_shared<Array>(budget_, dimensions, count);
  if (peek_operator().is('{')) {
    std::size_t at = 0;
    array_initialiser(*array, 0, at);
  }
  return array;
}

void Parser::array_initialiser(Array& array, std::size_t dimension, std::size_t& at) {
  expect('{');
  Group group(*this, true);
  std::size_t stride = 1;
  for (std::size_t d = dimension + 1; d < array.dimensions.size(); ++d) stride *= array.dimensions[d];
  const std::size_t start = at;
  for (std::size_t i = 0; i < array.dimensions[dimension] && !peek().is('}'); ++i) {
    at = start + i * stride;
    if (dimension + 1 < array.dimensions.size()) array_initialiser(array, dimension + 1, at);
    else array.elements[at].value = rvalue(false);
    accept(',');
  }
  Token close = next();
  if (!close.is('}')) fail_in("{", close);
}

// The element of `name[i]...`; the subscripts are next.
CellPtr Parser::subscripted(const Token& name, ArrayPtr array) {
  std::size_t index = 0;
  for (const std::size_t size : array->dimensions) {
    expect('[');
    Group group(*this);
    const double at = std::floor(number() + 1e-10);
    group.close(']');
    if (at < 0) throw Failure{name.where, "Negative subscript"};
    if (!(at < static_cast<double>(size))) {
      throw Failure{name.where, "Array subscript out of range"};
    }
    index = index * size + static_cast<std::size_t>(at);
  }
  return CellPtr(array, &array->elements[index]);
}

TextPtr Parser::make_text(std::string text) {
  return std::make_shared<Text>(budget_, std::move(text));
}

bool Parser::starts_string(const Token& token) const {
  return token.kind == Kind::string || token.holds<TextPtr>() ||
         token.keyword_class() == KeywordClass::string_function;
}

TextPtr Parser::string_value() {
  Token token = next_value();
  if (token.kind == Kind::string) return make_text(unescaped(token));
  if (const auto* text = token.holds<TextPtr>()) return *text;
  if (token.keyword_class() == KeywordClass::string_function) return string_call(token);
  fail("string expression", token);
}

// A file's name: backslashes are what they are.
std::string Parser::raw_string() {
  Token token = next_value();
  if (token.kind == Kind::string) return token.text->text;
  push_back(std::move(token));
  return string_value()->text;
}

bool Parser::calls_spline(const Token& token) {
  const auto* block = token.holds<BlockPtr>();
  return block && (*block)->name == "spline" && peek_operator().is('(');
}

}  // namespace nicol::sdl
