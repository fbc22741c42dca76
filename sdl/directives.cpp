// What `#word` does, but for those with files of their own.
#include <cmath>
#include <cstdio>
#include <iostream>

#include "parser.hpp"

namespace nicol::sdl {

namespace {

// After an error the others have said themselves where to read on.
bool skips_rest(Keyword keyword) {
  return keyword == Keyword::k_declare || keyword == Keyword::k_local ||
         keyword == Keyword::k_case || keyword == Keyword::k_range ||
         keyword == Keyword::k_version || keyword == Keyword::k_undef ||
         (keyword >= Keyword::k_render && keyword <= Keyword::k_write);
}

}  // namespace

void Parser::directive(const Token& token, std::uint32_t at) {
  const Nest nest(*this);
  const int grouping = grouping_;
  const bool expand = expand_macros_;
  grouping_ = 0;
  expand_macros_ = true;
  const auto keyword = static_cast<Keyword>(token.index);
  const Mark here = mark();
  try {
    switch (keyword) {
      case Keyword::k_declare: declare_directive(false); break;
      case Keyword::k_local: declare_directive(true); break;
      case Keyword::k_undef: undef_directive(); break;
      case Keyword::k_macro: macro_directive(at); break;
      case Keyword::k_include: include_directive(token); break;
      case Keyword::k_if: case Keyword::k_ifdef: case Keyword::k_ifndef: run_if(at); break;
      case Keyword::k_switch: run_switch(at); break;
      case Keyword::k_while: run_while(at); break;
      case Keyword::k_for: run_for(at); break;
      case Keyword::k_else: case Keyword::k_elseif: case Keyword::k_case: case Keyword::k_range:
        branch_reached(keyword, token);
        break;
      case Keyword::k_end: end_reached(token, at); break;
      case Keyword::k_break: run_break(token); break;
      case Keyword::k_default: default_directive(token); break;
      case Keyword::k_version: version_directive(token); break;
      default: message_directive(keyword, token); break;
    }
  } catch (const Failure& failure) {
    report(failure);
    if (skips_rest(keyword)) {
      recover(here, Skip::directive);
    } else {
      unwind(here);
      pushed_.clear();
      groups_lost_ = braces_lost_ = 0;
      trim_controls();
    }
  }
  grouping_ = grouping;
  expand_macros_ = expand;
}

void Parser::message_directive(Keyword keyword, const Token& token) {
  if (keyword != Keyword::k_debug && keyword != Keyword::k_warning && keyword != Keyword::k_error) {
    throw Failure{token.where, '#' + symbols_.text(token.index) + " is not supported."};
  }
  const std::string text = string_value()->text;
  if (keyword == Keyword::k_warning) {
    result_.diagnostics.warning(token.where, text);
  } else if (keyword == Keyword::k_error) {
    result_.diagnostics.error(token.where, "Parse halted by #error directive: " + text);
    throw Halt{};
  } else if (options_.debug) {
    options_.debug(text);
  } else {
    std::cerr << text;
  }
}

// `#version 3.7;` or `#version unofficial 3.7;`
void Parser::version_directive(const Token& token) {
  if (peek().undeclared() && symbols_.text(peek().index) == "unofficial") next();
  if (peek().undeclared() && symbols_.text(peek().index) == "patch") next();
  const double wanted = number();
  if (!(wanted < 3.8 - 1e-10)) {
    char text[100];
    std::snprintf(text, sizeof text, "Your scene file requires POV-Ray version %g or later!", wanted);
    result_.diagnostics.error(token.where, text);
    throw Halt{};
  }
  version_ = wanted;
  if (!peek_operator().is(';')) {
    warn(token.where, "All #version and #declares of float, vector, and color require semi-colon "
                      "';' at end.");
    return;
  }
  next();
}

void Parser::default_directive(const Token& token) {
  Token open = next();
  if (!open.is('{')) fail("{", open);
  auto made = std::make_shared<Block>();
  made->name = "#default";
  made->where = token.where;
  made->defaults = defaults_++;
  items(*made, '}');
  finish(*made);
  add_statement({BlockPtr(std::move(made)), token.where});
}

}  // namespace nicol::sdl
