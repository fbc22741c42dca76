// #if, #switch, #while, #for and their ends: jumps between linked lexemes of one frame.
#include <algorithm>
#include <cmath>

#include "parser.hpp"

namespace nicol::sdl {

bool Parser::linked(std::uint32_t at) {
  Frame& f = frame();
  if (f.tokens->lexemes[at].link != no_link) return true;
  const Lexeme& end = f.tokens->lexemes[f.end];
  const Lexeme& opener = f.tokens->lexemes[at];
  report({{f.tokens->file, end.line, end.column, f.call},
          "End of file reached but #end expected.\nthe '#" + symbols_.text(opener.index) +
              "' of line " + std::to_string(opener.line) + " has none"});
  f.position = f.end;
  return false;
}

std::uint32_t Parser::end_of(const Frame& f, std::uint32_t opener) const {
  std::uint32_t at = opener;
  do {
    at = f.tokens->lexemes[at].link;
    if (at == no_link) return f.end;
  } while (static_cast<Keyword>(f.tokens->lexemes[at].index) != Keyword::k_end);
  return at;
}

// After an error in its head, a conditional is read on behind its #end.
void Parser::leave(std::uint64_t serial, std::uint32_t opener) {
  for (Frame& f : frames_) {
    if (f.serial == serial) f.position = std::min(end_of(f, opener) + 1, f.end);
  }
}

// The value of `( ... )` after #if, #elseif, #ifdef, #ifndef.
bool Parser::condition(Keyword keyword) {
  if (keyword == Keyword::k_ifdef) return is_defined();
  if (keyword == Keyword::k_ifndef) return !is_defined();
  expect('(');
  Group group(*this);
  const Numbers value = choice();
  group.close(')');
  return value.v[0] != 0;
}

bool Parser::is_defined() {
  expect('(');
  Group group(*this);
  Token name = next_name();
  CellPtr cell = name.cell;
  while (peek().is('[')) {
    const auto* array = cell ? std::get_if<ArrayPtr>(&cell->value) : nullptr;
    if (!array) fail(")", next());
    cell = subscripted(name, *array);
  }
  group.close(')');
  return cell && !std::holds_alternative<Unset>(cell->value);
}

void Parser::run_if(std::uint32_t at) {
  const std::uint64_t serial = frame().serial;
  const std::uint32_t opener = at;
  if (!linked(at)) return;
  for (;;) {
    const auto keyword = static_cast<Keyword>(frame().tokens->lexemes[at].index);
    bool yes = keyword == Keyword::k_else;
    try {
      if (!yes) yes = condition(keyword);
    } catch (const Failure&) {  // neither branch is right: read on after #end
      leave(serial, opener);
      throw;
    }
    if (frame().serial != serial) throw Failure{last_, "Mis-matched '#if'."};
    if (yes) {
      frame().controls.push_back({opener, at, Keyword::k_if, nullptr, 0, 0});
      return;
    }
    at = frame().tokens->lexemes[at].link;
    if (at == no_link) {
      linked(opener);
      frame().position = frame().end;
      return;
    }
    frame().position = at + 1;
    if (static_cast<Keyword>(frame().tokens->lexemes[at].index) == Keyword::k_end) return;
  }
}

bool Parser::matches_case(Keyword keyword, double value) {
  expect('(');
  Group group(*this);
  const double low = number();
  double high = low;
  if (keyword == Keyword::k_range) {
    accept(',');
    high = number();
  }
  group.close(')');
  return value >= low - slack && value <= high + slack;
}

void Parser::run_switch(std::uint32_t at) {
  const std::uint64_t serial = frame().serial;
  const std::uint32_t opener = at;
  if (!linked(at)) return;
  double value = 0;
  try {
    expect('(');
    Group group(*this);
    value = number();
    group.close(')');
  } catch (const Failure&) {
    leave(serial, opener);
    throw;
  }
  for (;;) {
    if (frame().serial != serial) throw Failure{last_, "Mis-matched '#switch'."};
    const std::uint32_t from = at;
    at = frame().tokens->lexemes[at].link;
    if (at == no_link) {
      frame().position = frame().end;
      return;
    }
    frame().position = at + 1;
    const auto keyword = static_cast<Keyword>(frame().tokens->lexemes[at].index);
    if (from == opener && keyword != Keyword::k_case && keyword != Keyword::k_range) {
      leave(serial, opener);
      throw Failure{last_, "#switch not followed by #case or #range."};
    }
    if (keyword == Keyword::k_end) return;
    bool yes = keyword == Keyword::k_else;
    try {
      yes = yes || matches_case(keyword, value);
    } catch (const Failure&) {
      leave(serial, opener);
      throw;
    }
    if (yes) {
      frame().controls.push_back({opener, at, Keyword::k_switch, nullptr, 0, 0});
      return;
    }
  }
}

void Parser::run_while(std::uint32_t at) {
  const std::uint64_t serial = frame().serial;
  if (!linked(at)) return;
  bool yes = false;
  try {
    yes = condition(Keyword::k_while);
  } catch (const Failure&) {
    leave(serial, at);
    throw;
  }
  if (frame().serial != serial) throw Failure{last_, "Mis-matched '#while'."};
  if (yes) frame().controls.push_back({at, at, Keyword::k_while, nullptr, 0, 0});
  else leave(serial, at);
}

bool Parser::for_goes_on(const Control& control) const {
  const auto* n = std::get_if<Numbers>(&control.counter->value);
  if (!n) return false;
  return control.step > 0 ? n->v[0] < control.stop + slack : n->v[0] > control.stop - slack;
}

// `#for (Name, first, last [, step])`
void Parser::run_for(std::uint32_t at) {
  const std::uint64_t serial = frame().serial;
  if (!linked(at)) return;
  Control control{at, at, Keyword::k_for, nullptr, 0, 1};
  try {
    expect('(');
    Group group(*this);
    Token name = next_name();
    if (name.kind != Kind::word || name.keyword_class() != KeywordClass::none) {
      throw Failure{name.where, "Local variable name expected!"};
    }
    expect(',');
    const double first = number();
    expect(',');
    control.stop = number();
    if (accept(',')) control.step = number();
    if (control.step == 0) throw Failure{name.where, "#for loop increment must be non-zero."};
    group.close(')');
    control.counter = scope_.declare_local(name.index);
    control.counter->value = Numbers(first);
  } catch (const Failure&) {
    leave(serial, at);
    throw;
  }
  if (frame().serial != serial) throw Failure{last_, "Mis-matched '#for'."};
  control.body = frame().position;
  if (for_goes_on(control)) frame().controls.push_back(control);
  else leave(serial, at);
}

// #else, #elseif, #case or #range met while a branch is being read.
void Parser::branch_reached(Keyword keyword, const Token& token) {
  Frame& f = frame();
  const bool in_switch = !f.controls.empty() && f.controls.back().keyword == Keyword::k_switch;
  const bool in_if = !f.controls.empty() && f.controls.back().keyword == Keyword::k_if;
  const bool of_switch = keyword == Keyword::k_case || keyword == Keyword::k_range;
  if (in_switch && keyword != Keyword::k_elseif) {  // a #case without #break goes on into the next
    if (of_switch) matches_case(keyword, 0);
  } else if (in_if && !of_switch) {
    leave(f.serial, f.controls.back().opener);
    f.controls.pop_back();
  } else {
    throw Failure{token.where, of_switch ? "Mis-matched '#case' or '#range'."
                                         : "Mis-matched '#" + symbols_.text(token.index) + "'."};
  }
}

void Parser::end_reached(const Token& token, std::uint32_t at) {
  Frame& f = frame();
  const std::uint32_t opener = f.tokens->lexemes[at].link;
  if (f.controls.empty() || f.controls.back().opener != opener) {
    throw Failure{token.where, "Mis-matched '#end'."};
  }
  Control control = f.controls.back();
  f.controls.pop_back();
  if (control.keyword == Keyword::k_while) {
    f.position = opener + 1;
    run_while(opener);
  } else if (control.keyword == Keyword::k_for) {
    auto* n = std::get_if<Numbers>(&control.counter->value);
    if (!n) return;
    *n = Numbers(n->v[0] + control.step);
    if (!for_goes_on(control)) return;
    f.position = control.body;
    f.controls.push_back(std::move(control));
  }
}

void Parser::run_break(const Token& token) {
  Frame& f = frame();
  while (!f.controls.empty()) {
    const Control control = f.controls.back();
    f.controls.pop_back();
    if (control.keyword != Keyword::k_if) {
      leave(f.serial, control.opener);
      return;
    }
  }
  throw Failure{token.where, "Invalid context for #break"};
}

}  // namespace nicol::sdl
