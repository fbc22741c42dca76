// Tokens: lexemes of the innermost frame, with directives executed and macros called on the way.
#include <exception>

#include "parser.hpp"

namespace nicol::sdl {

Parser::Nest::Nest(Parser& parser) : parser_(parser) {
  if (parser.nesting_ >= parser.options_.limits.nesting_depth) {
    throw LimitReached{"Too many nested '{' braces."};
  }
  ++parser.nesting_;
}

void Parser::Group::close(char mark) {
  parser_.expect(mark);
  open = false;
  --parser_.grouping_;
}

Parser::Group::~Group() {
  if (!open) return;
  --parser_.grouping_;
  if (std::uncaught_exceptions() > 0) ++(braces ? parser_.braces_lost_ : parser_.groups_lost_);
}

void Parser::push_frame(TokenFilePtr tokens, std::uint32_t begin, std::uint32_t end,
                        std::uint32_t call, bool macro) {
  if (!frames_.empty()) scope_.open();
  frames_.push_back({std::move(tokens), begin, end, call, next_serial_++, macro, {}});
}

void Parser::pop_frame() {
  frames_.pop_back();
  scope_.close();
}

void Parser::take_step() {
  if (steps_left_ == 0) {
    if (result_.diagnostics.failed()) throw Halt{};
    throw LimitReached{"The scene takes too many steps: does a loop never end?"};
  }
  --steps_left_;
}

Token Parser::token_from(const Frame& from, const Lexeme& lexeme) const {
  Token token;
  token.kind = lexeme.kind;
  token.index = lexeme.index;
  token.where = {from.tokens->file, lexeme.line, lexeme.column, from.call};
  if (lexeme.kind == Kind::number) token.number = lexeme.number;
  return token;
}

Token Parser::next() {
  if (pushed_.empty()) return fetch();
  Token token = std::move(pushed_.back());
  pushed_.pop_back();
  return token;
}

const Token& Parser::peek() {
  if (pushed_.empty()) {
    Token token = fetch();
    pushed_.push_back(std::move(token));
  }
  return pushed_.back();
}

const Token& Parser::peek_operator() {
  if (!pushed_.empty()) return pushed_.back();
  const bool before = holding_;
  holding_ = grouping_ == 0;
  Token token = fetch();
  holding_ = before;
  if (token.kind == Kind::stop) return stop_;
  pushed_.push_back(std::move(token));
  return pushed_.back();
}

namespace {

// Directives that leave the flow of text alone, so that they can wait for a value to be complete.
bool can_wait(std::uint32_t keyword) {
  switch (static_cast<Keyword>(keyword)) {
    case Keyword::k_declare: case Keyword::k_local: case Keyword::k_undef: case Keyword::k_macro:
    case Keyword::k_include: case Keyword::k_default: case Keyword::k_version:
    case Keyword::k_debug: case Keyword::k_warning: case Keyword::k_error:
      return true;
    default:
      return false;
  }
}

}  // namespace

Token Parser::fetch() {
  for (;;) {
    Frame& from = frames_.back();
    if (from.position >= from.end) {
      if (frames_.size() > 1) {
        pop_frame();
        continue;
      }
      last_ = token_from(from, from.tokens->lexemes[from.end]).where;
      Token token;
      token.where = last_;
      return token;
    }
    const std::uint32_t at = from.position;
    const Lexeme& lexeme = from.tokens->lexemes[at];
    Token token = token_from(from, lexeme);
    if (lexeme.kind == Kind::directive && holding_ && can_wait(lexeme.index)) {
      token.kind = Kind::stop;
      stop_ = token;
      return token;
    }
    ++from.position;
    ++fetched_;
    take_step();
    last_ = token.where;
    if (lexeme.kind == Kind::directive) {
      if (run_directive(token, at)) return next();
      continue;
    }
    if (lexeme.kind == Kind::string) token.text = make_text(from.tokens->strings[lexeme.index]);
    if (lexeme.kind == Kind::word && expand(token)) continue;
    return token;
  }
}

// True if it has left a token to be read first.
bool Parser::run_directive(const Token& token, std::uint32_t at) {
  const bool held = holding_;
  holding_ = false;
  directive(token, at);
  holding_ = held;
  return !pushed_.empty();
}

bool Parser::expand(Token& token) {
  if (class_of(token.index) != KeywordClass::none) return false;
  token.cell = scope_.find(token.index);
  const auto* macro = token.holds<MacroPtr>();
  if (macro && expand_macros_) {
    call_macro(token, *macro);
    return true;
  }
  if (!deprecated_.empty() && expand_macros_) read_deprecation(token);
  return false;
}

Token Parser::next_name() {
  const bool before = expand_macros_;
  expand_macros_ = false;
  Token token = next();
  expand_macros_ = before;
  return token;
}

Token Parser::next_held(bool expand) {
  const bool expanded = expand_macros_, held = holding_;
  const Lexeme* lexeme = pushed_.empty() ? peek_lexeme() : nullptr;
  expand_macros_ = expand;
  holding_ = lexeme && lexeme->kind == Kind::directive;
  Token token = next();
  expand_macros_ = expanded;
  holding_ = held;
  return token;
}

Token Parser::next_value() {
  Token token = next();
  while (const auto* array = token.holds<ArrayPtr>()) {
    if (!peek_operator().is('[')) break;
    token.cell = subscripted(token, *array);
    token.kind = Kind::value;
    if (std::holds_alternative<Unset>(token.cell->value)) {
      throw Failure{token.where, "Attempt to access uninitialized array element."};
    }
  }
  return token;
}

// The lexeme that comes next if nothing is pushed back, seen through the ends of macros.
const Lexeme* Parser::peek_lexeme() const {
  for (std::size_t i = frames_.size(); i-- > 0;) {
    const Frame& f = frames_[i];
    if (f.position < f.end) return &f.tokens->lexemes[f.position];
    if (!f.macro) return nullptr;
  }
  return nullptr;
}

void Parser::expect(char mark) {
  Token token = next();
  if (!token.is(mark)) fail(std::string(1, mark), token);
}

bool Parser::accept(char mark) {
  if (!peek().is(mark)) return false;
  next();
  return true;
}

}  // namespace nicol::sdl
