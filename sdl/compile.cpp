// `function { }` read into postfix steps; floats are captured where it is declared.
#include <algorithm>

#include "parser.hpp"
#include "text.hpp"

namespace nicol::sdl {

void Parser::emit(Function& f, Step step) {
  budget_.charge(1);
  f.steps.push_back(std::move(step));
}

namespace {

Step step_of(Step::Op op, std::uint32_t count) {
  Step step;
  step.op = op;
  step.count = count;
  return step;
}

Step number_step(double value) {
  Step step;
  step.number = value;
  return step;
}

}  // namespace

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

// Levels: 0 `? :`, 1 `& |`, 2 relations, 3 `+ -`, 4 `* /`.
void Parser::compile(Function& f, int level) {
  using Op = Step::Op;
  if (level == 5) {
    compile_unary(f);
    return;
  }
  const Nest nest(*this);
  compile(f, level + 1);
  for (;;) {
    const Token& t = peek();
    std::optional<Op> op;
    if (level == 0 && t.is('?')) op = Op::choose;
    if (level == 1) op = t.is('&') ? Op::logical_and : t.is('|') ? Op::logical_or : op;
    if (level == 2) {
      op = t.is('=') ? Op::equal : t.is('<') ? Op::less : t.is('>') ? Op::greater : op;
      op = t.is_mark(mark_le) ? Op::less_equal : t.is_mark(mark_ge) ? Op::greater_equal
         : t.is_mark(mark_ne) ? Op::not_equal : op;
    }
    if (level == 3) op = t.is('+') ? Op::add : t.is('-') ? Op::subtract : op;
    if (level == 4) op = t.is('*') ? Op::multiply : t.is('/') ? Op::divide : op;
    if (!op) return;
    next();
    compile(f, level == 0 ? 0 : level + 1);
    if (*op == Op::choose) {
      expect(':');
      compile(f, 0);
    }
    emit(f, step_of(*op, *op == Op::choose ? 3 : 2));
  }
}

void Parser::compile_unary(Function& f) {
  std::string signs;
  Token token = next();
  for (; token.is('-') || token.is('+') || token.is('!'); token = next()) {
    if (!token.is('+')) signs += static_cast<char>(token.index);
  }
  compile_operand(f, token);
  for (std::size_t i = signs.size(); i-- > 0;) {
    emit(f, step_of(signs[i] == '-' ? Step::Op::negate : Step::Op::logical_not, 1));
  }
}

std::uint32_t Parser::compile_arguments(Function& f) {
  expect('(');
  const Nest nest(*this);
  std::uint32_t count = 0;
  do {
    compile(f, 0);
    ++count;
  } while (accept(','));
  expect(')');
  return count;
}

void Parser::compile_operand(Function& f, const Token& token) {
  if (token.kind == Kind::number) {
    emit(f, number_step(token.number));
    return;
  }
  if (token.is('(')) {
    const Nest nest(*this);
    compile(f, 0);
    expect(')');
    return;
  }
  for (std::size_t i = 0; token.kind == Kind::word && i < f.parameters.size(); ++i) {
    if (f.parameters[i] != token.index) continue;
    Step step = step_of(Step::Op::parameter, 0);
    step.index = static_cast<std::uint32_t>(i);
    emit(f, step);
    return;
  }
  if (const auto* callee = token.holds<FunctionPtr>()) {
    compile_call(f, token, *callee);
    return;
  }
  if (token.keyword_class() == KeywordClass::float_function) {
    Step step = step_of(Step::Op::builtin, compile_arguments(f));
    step.index = token.index;
    const Arity arity = float_builtin_arity(static_cast<Keyword>(token.index));
    const int count = static_cast<int>(step.count);
    if (count < arity.least || (arity.most >= 0 && count > arity.most)) {
      throw Failure{token.where, "Invalid number of parameters: " + std::to_string(count) +
                                     " supplied, " + std::to_string(arity.least) + " required!"};
    }
    emit(f, step);
    return;
  }
  const bool known = token.holds<Numbers>() || token.keyword_class() == KeywordClass::constant;
  if (!known) fail("operand", token);
  const auto* held = token.holds<Numbers>();
  const Numbers value = postfix(held ? *held : constant(token));
  if (value.size != 1) fail("operand", token);
  emit(f, number_step(value.v[0]));
}

void Parser::compile_call(Function& f, const Token& token, FunctionPtr callee) {
  Step step = step_of(Step::Op::call, compile_arguments(f));
  const bool any = callee->kind == Function::Kind::opaque;
  if (!any && step.count != callee->parameters.size()) {
    throw Failure{token.where, "Invalid number of parameters: " + std::to_string(step.count) +
                                   " supplied, " + std::to_string(callee->parameters.size()) +
                                   " required!"};
  }
  f.depth = std::max(f.depth, callee->depth + 1);
  if (f.depth > options_.limits.nesting_depth) throw LimitReached{"Too many nested functions."};
  if (peek().is('.')) {
    next();
    const Token name = next();
    const char* const names[] = {"x u red", "y v green", "z blue", "t filter", "transmit"};
    const std::string wanted = name.kind == Kind::word ? symbols_.text(name.index) : "";
    for (std::uint32_t i = 0; i < 5 && !wanted.empty(); ++i) {
      if ((' ' + std::string(names[i]) + ' ').find(' ' + wanted + ' ') != std::string::npos) step.index = i;
    }
  }
  step.callee = std::move(callee);
  emit(f, step);
}

}  // namespace nicol::sdl
