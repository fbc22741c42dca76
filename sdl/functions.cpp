// `function { }` and `spline { }`: parameters, the kinds of body, and the text of those among items.
#include <algorithm>

#include "parser.hpp"
#include "text.hpp"

namespace nicol::sdl {

// `(a, b)`, or x, y, z by default.
void Parser::read_parameters(Function& f) {
  if (!peek().is('(')) {
    for (Keyword k : {Keyword::k_x, Keyword::k_y, Keyword::k_z}) {
      f.parameters.push_back(static_cast<Symbol>(k));
    }
    return;
  }
  next();
  for (Token token = next_name(); !token.is(')'); token = next_name()) {
    if (token.is(',')) continue;
    const bool letter = token.kind == Kind::word && token.index >= static_cast<Symbol>(Keyword::k_x) &&
                        token.index <= static_cast<Symbol>(Keyword::k_v);
    if (token.kind != Kind::word || (token.keyword_class() != KeywordClass::none && !letter)) {
      fail("parameter identifier", token);
    }
    f.parameters.push_back(token.index);
  }
  if (f.parameters.empty()) throw Failure{last_, "At least one function parameter is required!"};
}

// `function` is read.
FunctionPtr Parser::function_value() {
  const Location where = last_;
  auto f = std::make_shared<Function>();
  read_parameters(*f);
  expect('{');
  Group group(*this, true);
  const Token first = peek();
  if (first.undeclared()) {
    Token name = next();
    if (symbols_.text(name.index) == "internal" && peek().is('(')) {
      next();
      f->kind = Function::Kind::opaque;
      f->what = "internal(" + number_text(number()) + ")";
      expect(')');
      expect('}');
      return f;
    }
    if (peek().is('{')) {
      const FunctionPtr made = block_function(block(name), where);
      expect('}');
      return made;
    }
    push_back(std::move(name));
  }
  if (first.kind == Kind::string) {
    next();
    f->kind = Function::Kind::opaque;
    f->what = "a text";
  } else {
    compile(*f, 0);
  }
  Token close = next();
  if (!close.is('}')) fail_in("function", close);
  return f;
}

FunctionPtr Parser::block_function(const BlockPtr& body, Location where) {
  if (body->name == "spline") return spline_function(body, where);
  auto f = std::make_shared<Function>();
  for (Keyword k : {Keyword::k_x, Keyword::k_y, Keyword::k_z}) {
    f->parameters.push_back(static_cast<Symbol>(k));
  }
  f->kind = Function::Kind::opaque;
  f->what = body->name;
  if (body->name == "transform" && !body->damaged) {
    f->kind = Function::Kind::transform;
    if (!matrix_of(*body, f->matrix)) throw Failure{where, "Illegal transform in a function."};
  }
  return f;
}

namespace {

void collect_knots(const Block& block, Function& f) {
  using Kind = Function::Spline;
  double at = 0;
  bool has_at = false;
  for (const Item& item : block.items) {
    if (const auto* word = item.word()) {
      f.spline = *word == "cubic_spline" ? Kind::cubic : *word == "natural_spline" ? Kind::natural
               : *word == "quadratic_spline" ? Kind::quadratic : Kind::linear;
    } else if (const Block* nested = item.block()) {
      collect_knots(*nested, f);
    } else if (item.number() && !has_at) {
      at = *item.number();
      has_at = true;
    } else if (item.vector() || item.number()) {
      Knot knot{at, {}, {}};
      const Vector* v = item.vector();
      const int size = v ? std::min(v->size, 5) : 3;
      for (std::size_t k = 0; k < static_cast<std::size_t>(size); ++k) {
        knot.value[k] = v ? v->v[k] : *item.number();
      }
      f.knot_size = std::max(f.knot_size, size);
      f.knots.push_back(knot);
      has_at = false;
    }
  }
}

}  // namespace

FunctionPtr Parser::spline_function(const BlockPtr& block, Location where) {
  const auto known = splines_.find(block);
  if (known != splines_.end()) return known->second;
  auto f = std::make_shared<Function>();
  f->kind = Function::Kind::spline;
  f->parameters.push_back(static_cast<Symbol>(Keyword::k_x));
  collect_knots(*block, *f);
  prepare_spline(*f);
  if (f->knots.size() < 2) throw Failure{where, "At least two entries are needed in a spline."};
  splines_.emplace(block, f);
  return f;
}

// A function among items: nobody calls it here, so its text is kept.
BlockPtr Parser::function_text(const Token& name) {
  auto made = std::make_shared<Block>();
  made->name = symbols_.text(name.index);
  made->where = name.where;
  std::string text;
  int depth = 0;
  bool only_string = true;
  do {
    const Token token = next();
    if (token.kind == Kind::end) {
      push_back(token);
      report({token.where, "No matching } in 'function', End of File found instead"});
      throw Halt{};
    }
    if (token.is('{')) ++depth;
    if (token.is('}')) --depth;
    const bool quoted = token.kind == Kind::string;
    only_string = only_string && (quoted || token.is('{') || token.is('}'));
    if (!text.empty()) text += ' ';
    if (quoted) text += only_string ? unescaped(token) : '"' + token.text->text + '"';
    else if (token.kind == Kind::word) text += symbols_.text(token.index);
    else if (token.kind == Kind::number) text += number_text(token.number);
    else text += describe(token);
    if (text.size() > options_.limits.items) throw LimitReached{"Out of memory."};
    made->end_where = token.where;
  } while (depth > 0 || text.back() != '}');
  if (only_string && text.size() >= 4) text = text.substr(2, text.size() - 4);
  add(*made, {text, made->where});
  finish(*made);
  return made;
}

}  // namespace nicol::sdl
