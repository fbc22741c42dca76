// Expressions of `function { }` as postfix steps; floats are captured where it is declared.
#include <algorithm>

#include "parser.hpp"

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
      const std::string padded = ' ' + std::string(names[i]) + ' ';
      if (padded.find(' ' + wanted + ' ') != std::string::npos) step.index = i;
    }
  }
  step.callee = std::move(callee);
  emit(f, step);
}

}  // namespace nicol::sdl
