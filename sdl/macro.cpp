// #macro, and calling one: its body's lexemes become the innermost frame.
#include "parser.hpp"

namespace nicol::sdl {

void Parser::macro_directive(std::uint32_t at) {
  if (!linked(at)) return;
  const std::uint32_t end = frame().tokens->lexemes[at].link;
  try {
    Token name = next_name();
    if (name.kind != Kind::word || name.keyword_class() != KeywordClass::none ||
        (name.cell && !name.holds<MacroPtr>() && !name.holds<Broken>())) {
      fail("undeclared identifier", name);
    }
    auto macro = std::make_shared<Macro>();
    macro->name = symbols_.text(name.index);
    expect('(');
    for (Token token = next_name(); !token.is(')'); token = next_name()) {
      if (token.is(',')) continue;
      if (token.kind != Kind::word || token.keyword_class() != KeywordClass::none) {
        fail("identifier or expression.", token);
      }
      macro->parameters.push_back(token.index);
    }
    macro->tokens = frame().tokens;
    macro->begin = frame().position;
    macro->end = end;
    if (macro->begin > end) throw Failure{name.where, "End of file reached but #end expected."};
    frame().position = end + 1;
    scope_.declare(name.index)->value = MacroPtr(std::move(macro));
  } catch (const Failure& failure) {
    report(failure);
    pushed_.clear();
    frame().position = end + 1;
  }
}

// The chain of calls that leads here; one call from one place is one entry however often it happens.
std::uint32_t Parser::call_index(const Token& name, const Macro& macro) {
  const Location& w = name.where;
  const std::pair<std::uint32_t, std::array<std::uint32_t, 4>> key{
      name.index, {w.file, w.line, w.column, w.call}};
  const auto found = call_indices_.find(key);
  if (found != call_indices_.end()) return found->second;
  constexpr std::size_t most_calls = 1'000'000;
  if (call_indices_.size() >= most_calls) return w.call;
  const std::uint32_t index = result_.sources.push_call(macro.name, w);
  call_indices_.emplace(key, index);
  return index;
}

void Parser::call_macro(const Token& name, MacroPtr macro) {
  const Nest nest(*this);
  const bool held = holding_;
  holding_ = false;
  std::vector<CellPtr> arguments;
  expect('(');
  {
    Group group(*this);
    const std::size_t wanted = macro->parameters.size();
    while (arguments.size() < wanted) {
      if (peek().is(')')) {
        throw Failure{peek().where, "Expected " + std::to_string(wanted) +
                                        " parameters but only " +
                                        std::to_string(arguments.size()) + " found."};
      }
      arguments.push_back(argument());
      accept(',');
    }
    group.close(')');
  }
  holding_ = held;
  int running = 0;
  for (const Frame& f : frames_) running += f.macro ? 1 : 0;
  if (running >= options_.limits.macro_depth) {
    throw Failure{name.where, "Too many nested symbol tables"};
  }
  push_frame(macro->tokens, macro->begin, macro->end, call_index(name, *macro), true);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    scope_.bind(macro->parameters[i], arguments[i]);
  }
}

// Exactly one identifier (or array element) is passed by reference, all else by value.
CellPtr Parser::argument() {
  Token token = next_value();
  if (token.cell && !token.holds<FunctionPtr>()) {
    const Token& after = peek();
    if (after.is(',') || after.is(')')) return token.cell;
  }
  push_back(token);
  auto cell = std::make_shared<Cell>();
  cell->value = rvalue(true);
  return cell;
}

}  // namespace nicol::sdl
