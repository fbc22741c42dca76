// Numbers and vectors. Comparisons and logic exist only inside parentheses, as in POV-Ray; there `&`
// and `|` share one level, left to right.
#include <cmath>
#include <limits>

#include "parser.hpp"

namespace nicol::sdl {
namespace {

template <typename Combine>
Numbers combined(const Numbers& a, const Numbers& b, Combine combine) {
  const int size = std::max(a.size, b.size);
  Numbers p = promoted(a, size);
  const Numbers q = promoted(b, size);
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) p.v[i] = combine(p.v[i], q.v[i]);
  p.colour = a.colour || b.colour;
  return p;
}

}  // namespace

// `c ? a : b`
Numbers Parser::choice() {
  const Nest nest(*this);
  const Numbers first = logic();
  if (!accept('?')) return first;
  const Numbers yes = choice();
  expect(':');
  const Numbers no = choice();
  return first.v[0] != 0 ? yes : no;
}

Numbers Parser::logic() {
  Numbers left = relation();
  for (;;) {
    const bool both = peek().is('&');
    if (!both && !peek().is('|')) return left;
    next();
    const Numbers right = relation();
    const bool a = left.v[0] != 0, b = right.v[0] != 0;
    left = Numbers((both ? a && b : a || b) ? 1.0 : 0.0);
  }
}

bool Parser::compared(std::uint32_t mark, int order) const {
  switch (mark) {
    case '=': return order == 0;
    case mark_ne: return order != 0;
    case '<': return order < 0;
    case '>': return order > 0;
    case mark_le: return order <= 0;
    default: return order >= 0;
  }
}

namespace {
bool is_relation(const Token& token) {
  return token.is('=') || token.is('<') || token.is('>') || token.is_mark(mark_le) ||
         token.is_mark(mark_ge) || token.is_mark(mark_ne);
}
}  // namespace

Numbers Parser::relation() {
  Token start = next_value();
  if (starts_string(start)) {
    push_back(std::move(start));
    const TextPtr left = string_value();
    Token mark = next();
    if (!is_relation(mark)) fail("string comparison operator", mark);
    const int order = left->text.compare(string_value()->text);
    return Numbers(compared(mark.index, order) ? 1.0 : 0.0);
  }
  push_back(std::move(start));
  Numbers left = sum();
  while (is_relation(peek())) {
    const Token mark = next();
    const Numbers right = sum();
    if (left.size > 1 || right.size > 1) {
      throw Failure{mark.where, "Float expected but vector or color expression found."};
    }
    const double a = left.v[0], b = right.v[0];
    const bool strict = mark.is('<') || mark.is('>');
    const int order = !strict && std::fabs(a - b) < slack ? 0 : a < b ? -1 : a > b ? 1 : a == b ? 0 : 2;
    left = Numbers(order == 2 ? (mark.is_mark(mark_ne) ? 1.0 : 0.0)
                              : (compared(mark.index, order) ? 1.0 : 0.0));
  }
  return left;
}

// `first`: an operand that was read already.
Numbers Parser::sum(std::optional<Numbers> first) {
  Numbers left = product_of(first);
  for (;;) {
    const Token& op = peek_operator();
    if (op.is('+')) {
      next();
      left = combined(left, product_of({}), [](double a, double b) { return a + b; });
    } else if (op.is('-')) {
      next();
      left = combined(left, product_of({}), [](double a, double b) { return a - b; });
    } else {
      return left;
    }
  }
}

Numbers Parser::product_of(std::optional<Numbers> first) {
  Numbers left = first ? postfix(*first) : factor();
  for (;;) {
    const Token& op = peek_operator();
    if (op.is('*')) {
      next();
      left = combined(left, factor(), [](double a, double b) { return a * b; });
    } else if (op.is('/')) {
      const Location where = next().where;
      left = divided(left, factor(), where);
    } else {
      return left;
    }
  }
}

Numbers Parser::divided(const Numbers& a, const Numbers& b, Location where) {
  const int size = std::max(a.size, b.size);
  bool by_zero = false;
  const Numbers q = promoted(b, size);
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) by_zero = by_zero || q.v[i] == 0;
  if (by_zero) warn(where, "Divide by zero.");
  return combined(a, b, [](double p, double d) {
    return d == 0 ? std::numeric_limits<double>::infinity() : p / d;
  });
}

Numbers Parser::factor() {
  std::string signs;  // kept, not recursed into: there may be a million
  Token token = next_value();
  for (; token.is('-') || token.is('+') || token.is('!'); token = next_value()) {
    if (!token.is('+')) signs += static_cast<char>(token.index);
  }
  Numbers value = primary(std::move(token));
  for (std::size_t i = signs.size(); i-- > 0;) {
    for (int k = 0; k < value.size; ++k) {
      double& c = value.v[static_cast<std::size_t>(k)];
      c = signs[i] == '-' ? -c : c == 0 ? 1.0 : 0.0;
    }
  }
  return value;
}

Numbers Parser::primary(Token token) {
  if (token.kind == Kind::number) return postfix(Numbers(token.number));
  if (token.is('(')) {
    Group group(*this);
    const Numbers value = choice();
    group.close(')');
    return postfix(value);
  }
  if (token.is('<')) {
    const Location where = token.where;
    const std::vector<double> numbers = components();
    if (numbers.size() > 5) throw Failure{where, "Too many components in vector!"};
    Numbers value;
    value.size = static_cast<int>(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) value.v[i] = numbers[i];
    return postfix(value);
  }
  if (const auto* n = token.holds<Numbers>()) return postfix(*n);
  if (token.holds<FunctionPtr>() || calls_spline(token)) {
    const Value callee = token.cell->value;
    return postfix(call(token, callee));
  }
  switch (token.keyword_class()) {
    case KeywordClass::constant: return postfix(constant(token));
    case KeywordClass::float_function: return postfix(float_call(token));
    case KeywordClass::other_function: return postfix(other_call(token));
    case KeywordClass::colour: return colour(std::move(token));
    default: break;
  }
  if (token.is(Keyword::k_version)) return postfix(Numbers(version_));
  fail("numeric expression", token);
}

Numbers Parser::postfix(Numbers value) {
  while (peek_operator().is('.')) {
    next();
    value = member(value);
  }
  return value;
}

Numbers Parser::member(const Numbers& value) {
  Token name = next();
  int index = -1;
  if (name.is(Keyword::k_gray)) {  // ITU-R BT.601 weights, as POV-Ray has them
    return Numbers(0.297 * value.v[0] + 0.589 * value.v[1] + 0.114 * value.v[2]);
  }
  if (name.is(Keyword::k_x) || name.is(Keyword::k_u) || name.is(Keyword::k_red)) index = 0;
  if (name.is(Keyword::k_y) || name.is(Keyword::k_v) || name.is(Keyword::k_green)) index = 1;
  if (name.is(Keyword::k_z) || name.is(Keyword::k_blue)) index = 2;
  if (name.is(Keyword::k_t) || name.is(Keyword::k_filter)) index = 3;
  if (name.is(Keyword::k_transmit)) index = 4;
  if (index < 0) {
    fail("x, y, z or color component", name);
  }
  if (index >= value.size) throw Failure{name.where, "Bad operands for period operator."};
  return Numbers(value.v[static_cast<std::size_t>(index)]);
}

// What stands between `<` and `>`: floats, commas where wanted.
std::vector<double> Parser::components() {
  Group group(*this);
  std::vector<double> numbers;
  do {
    numbers.push_back(number());
    const bool comma = accept(',');
    if (!comma && !peek().is('>') && !starts_expression(peek())) fail(">", next());
    if (numbers.size() > options_.limits.items) throw LimitReached{"Out of memory."};
  } while (!peek().is('>'));
  if (numbers.size() == 1) fail("numeric expression", next());
  group.close('>');
  return numbers;
}

double Parser::number() {
  const Location where = peek().where;
  const Numbers value = sum();
  if (value.size != 1) {
    throw Failure{where, "Float expected but vector or color expression found."};
  }
  return value.v[0];
}

Numbers Parser::vector3() {
  Numbers value = promoted(sum(), 3);
  value.size = 3;
  return value;
}

bool Parser::starts_expression(const Token& token) const {
  if (token.kind == Kind::number) return true;
  if (token.is('<') || token.is('(') || token.is('-') || token.is('+') || token.is('!')) return true;
  if (token.holds<Numbers>() || token.holds<FunctionPtr>() || token.holds<ArrayPtr>() ||
      token.holds<Broken>() || token.is(Keyword::k_version)) {
    return true;
  }
  if (const auto* block = token.holds<BlockPtr>()) return (*block)->name == "spline";
  switch (token.keyword_class()) {
    case KeywordClass::constant: case KeywordClass::float_function:
    case KeywordClass::other_function: case KeywordClass::colour:
      return true;
    default: return false;
  }
}

}  // namespace nicol::sdl
