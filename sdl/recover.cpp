// Errors: worded as POV-Ray words them, told once, and skipped to where reading on makes sense.
#include <algorithm>
#include <cstdio>

#include "parser.hpp"

namespace nicol::sdl {

void Parser::report(const Failure& failure) {
  if (failure.message.empty()) return;
  constexpr std::size_t steps_of_failure = 100;  // unwinding and the search for the nearest word take that long
  steps_left_ -= std::min(steps_left_, steps_of_failure);
  const Location& at = failure.where;
  if (!told_.insert({failure.message, {at.file, at.line, at.column}}).second) return;
  result_.diagnostics.error(at, failure.message);
  // A loop may wait for what the error has prevented: what is left is read to find more errors only.
  constexpr std::size_t steps_after_error = 2'000'000;
  steps_left_ = std::min(steps_left_, steps_after_error);
  if (result_.diagnostics.error_count() >= options_.most_errors) {
    result_.diagnostics.note(at, "Too many errors; the rest of the scene was not read.");
    throw Halt{};
  }
}

void Parser::warn(Location where, const std::string& message) {
  if (told_.insert({message, {where.file, where.line, where.column}}).second) {
    result_.diagnostics.warning(where, message);
  }
}

bool Parser::is_reserved(const Token& token) const {
  if (!token.undeclared()) return false;
  const auto& words = options_.reserved;
  return std::find(words.begin(), words.end(), symbols_.text(token.index)) != words.end();
}

std::string Parser::describe(const Token& token) const {
  switch (token.kind) {
    case Kind::end: return "End of File";
    case Kind::number: return "float function 'float constant'";
    case Kind::string: return "string literal";
    case Kind::mark:
      if (token.is(',')) return ", ";
      if (token.index == mark_le) return "<=";
      if (token.index == mark_ge) return ">=";
      if (token.index == mark_ne) return "!=";
      return std::string(1, static_cast<char>(token.index));
    case Kind::directive: case Kind::stop: return "#";
    default: break;
  }
  const std::string name = "'" + (token.kind == Kind::word ? symbols_.text(token.index) : "") + "'";
  switch (token.keyword_class()) {
    case KeywordClass::float_function: case KeywordClass::other_function:
      return (token.index >= static_cast<Symbol>(Keyword::k_max_extent) ? "vector function "
                                                                        : "float function ") + name;
    case KeywordClass::constant:
      return (token.index <= static_cast<Symbol>(Keyword::k_v) ? "vector function "
                                                               : "float function ") + name;
    case KeywordClass::colour: case KeywordClass::channel: return "color keyword " + name;
    case KeywordClass::maker: case KeywordClass::string_function: return symbols_.text(token.index);
    default: break;
  }
  if (is_reserved(token)) return symbols_.text(token.index);
  if (!token.cell) return "undeclared identifier " + name;
  const std::string kind = kind_name(token.cell->value);
  if (kind == "float identifier") return "float function '" + kind + "'";
  if (kind == "vector identifier") return "vector function '" + kind + "'";
  return kind;
}

// The nearest known word to one that means nothing.
std::string Parser::hint(const Token& token) const {
  if (!token.undeclared()) return "";
  std::vector<std::string> known = options_.reserved;
  scope_.each_name([&](Symbol s) { known.push_back(symbols_.text(s)); });
  for (Symbol s = 0; s < static_cast<Symbol>(Keyword::count); ++s) {
    if (class_of(s) != KeywordClass::directive) known.push_back(symbols_.text(s));
  }
  const std::string near = nearest_word(symbols_.text(token.index), known);
  return near.empty() ? "" : "\ndid you mean '" + near + "'?";
}

void Parser::fail_with(const Token& found, const std::string& message) {
  const Token copy = found;
  if (copy.kind != Kind::stop) push_back(copy);
  if (copy.holds<Broken>() || (names_unknown_ && copy.undeclared())) throw Failure{copy.where, ""};
  if (copy.kind == Kind::bad) {
    char text[64];
    std::snprintf(text, sizeof text, "Illegal character in input file, value is %02x.", copy.index);
    pushed_.pop_back();
    throw Failure{copy.where, text};
  }
  throw Failure{copy.where, message + hint(copy)};
}

void Parser::fail(const std::string& expected, const Token& found) {
  fail_with(found, "Expected '" + expected + "', " + describe(found) + " found instead");
}

void Parser::fail_in(const std::string& block, const Token& found) {
  fail_with(found, "No matching } in '" + block + "', " + describe(found) + " found instead");
}

Parser::Mark Parser::mark() {
  return {frames_.back().serial, grouping_, nesting_, expand_macros_, holding_};
}

// Back to the frame of the mark, if it still lives.
void Parser::unwind(const Mark& to) {
  bool alive = false;
  for (const Frame& f : frames_) alive = alive || f.serial == to.serial;
  if (alive && frames_.back().serial != to.serial) {
    pushed_.clear();
    while (frames_.back().serial != to.serial) pop_frame();
  }
  grouping_ = to.grouping;
  nesting_ = to.nesting;
  expand_macros_ = to.expand_macros;
  holding_ = to.holding;
}

// Forgets the #if and #while that skipping has left.
void Parser::trim_controls() {
  Frame& f = frame();
  while (!f.controls.empty()) {
    const std::uint32_t opener = f.controls.back().opener;
    if (f.position > opener && f.position <= end_of(f, opener)) return;
    f.controls.pop_back();
  }
}

// A token with nothing executed; what was pushed back comes first.
Token Parser::raw_token() {
  if (!pushed_.empty()) return next();
  Frame& f = frame();
  Token token;
  if (f.position >= f.end) return token;
  token = token_from(f, f.tokens->lexemes[f.position]);
  if (token.kind == Kind::word && class_of(token.index) == KeywordClass::none) {
    token.cell = scope_.find(token.index);
  }
  ++f.position;
  ++fetched_;
  take_step();
  return token;
}

bool Parser::stops(const Token& token, Skip skip, bool moved) {
  if (token.kind == Kind::directive) return true;
  if (token.is('}')) return skip != Skip::statement || nesting_ > 0;
  if (token.is(',') && skip == Skip::item) return true;
  if (moved && token.holds<MacroPtr>()) return true;  // its call may yield the next thing
  if (!token.undeclared() && !token.holds<BlockPtr>()) return false;
  const Lexeme* after = pushed_.empty() ? peek_lexeme() : nullptr;
  const bool opens = after && after->kind == Kind::mark && after->index == '{';
  if (opens) return true;
  return skip == Skip::item && moved && token.undeclared();
}

// Whether reading may go on at the token, which is not yet passed.
bool Parser::ends(const Skipping& s, const Token& token) {
  const bool macro = token.holds<MacroPtr>() != nullptr;
  const bool in_group = s.groups > 0 && (token.is(',') || token.undeclared() || macro);
  if (s.braces == s.braces_lost && token.kind == Kind::directive) return true;
  if (s.braces != 0) return false;
  if (!in_group && stops(token, s.skip, s.moved)) return true;
  return !(in_group && macro) && stops(token, Skip::statement, s.moved);
}

// False once the token was the last one to pass.
bool Parser::pass(Skipping& s, const Token& token) const {
  s.moved = true;
  if (token.is('{')) ++s.braces;
  if (token.is('}')) --s.braces;
  if (s.braces == 0 && (token.is(')') || token.is('>') || token.is(']'))) --s.groups;
  if (s.braces == 0 && (token.is('(') || token.is('<') || token.is('['))) ++s.groups;
  const bool last = s.braces <= 0 && token.is(';') && s.skip == Skip::directive;
  s.braces = std::max(s.braces, 0);
  return !last;
}

// Skips to where the next item, statement or directive may begin. Brackets that the failed one left
// open are closed first, if they close: the sign of a new block ends them too.
void Parser::recover(const Mark& to, Skip skip) {
  unwind(to);
  Skipping s{skip, groups_lost_, braces_lost_, braces_lost_, false};
  groups_lost_ = braces_lost_ = 0;
  const bool stuck = recovered_at_ == fetched_;  // nothing was read since: one token must go
  for (bool more = true; more;) {
    Frame& f = frame();
    const std::uint32_t before = f.position;
    const bool was_pushed = !pushed_.empty();
    if (!was_pushed && f.position >= f.end) break;
    Token token = raw_token();
    const bool at_end = token.kind == Kind::end;
    if (at_end || ((s.moved || !stuck) && ends(s, token))) {
      if (was_pushed) push_back(std::move(token));
      else f.position = before;
      break;
    }
    more = pass(s, token);
  }
  trim_controls();
  recovered_at_ = fetched_;
}

}  // namespace nicol::sdl
