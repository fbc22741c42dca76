// Cuts scene text into lexemes: comments nest, commas and blanks separate, directives are `#` and a word.
#include "lexer.hpp"

#include <charconv>
#include <cstdio>

namespace nicol::sdl {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Lexer {
 public:
  Lexer(std::string_view text, TokenFile& out, Symbols& symbols, std::size_t most)
      : text_(text), out_(out), symbols_(symbols), most_(most) {}

  void run() {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") advance(3);
    while (skip_blanks()) {
      if (out_.lexemes.size() >= most_) {
        hard_error("Too many tokens in one file.");
        break;
      }
      one();
      end_line_ = line_;
      end_column_ = column();
    }
    // The end is told where the last word ended, not after the blank lines that follow it.
    Lexeme& end = push(Kind::end);
    if (end_line_ > 0) {
      end.line = end_line_;
      end.column = end_column_;
    }
  }

 private:
  char at(std::size_t ahead = 0) const {
    return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
  }
  bool more() const { return position_ < text_.size(); }

  void advance(std::size_t count = 1) {
    for (; count > 0 && more(); --count, ++position_) {
      if (text_[position_] == '\n') {
        ++line_;
        line_start_ = position_ + 1;
      }
    }
  }

  std::uint32_t column() const { return static_cast<std::uint32_t>(position_ - line_start_ + 1); }

  Lexeme& push(Kind kind, std::uint32_t index = 0) {
    Lexeme lexeme;
    lexeme.kind = kind;
    lexeme.line = line_;
    lexeme.column = column();
    lexeme.index = index;
    out_.lexemes.push_back(lexeme);
    return out_.lexemes.back();
  }

  void hard_error(std::string message) {
    out_.errors.push_back({line_, column(), std::move(message)});
  }

  // Blanks and comments; false at the end of the text.
  bool skip_blanks() {
    while (more()) {
      if (is_blank(at())) advance();
      else if (at() == '/' && at(1) == '/') skip_line();
      else if (at() == '/' && at(1) == '*') skip_comment();
      else return true;
    }
    return false;
  }

  void skip_line() {
    while (more() && at() != '\n') advance();
  }

  void skip_comment() {
    const LexicalError open{line_, column(), "No */ closing comment found."};
    int depth = 0;
    do {
      if (at() == '/' && at(1) == '*') {
        ++depth;
        advance(2);
      } else if (at() == '*' && at(1) == '/') {
        --depth;
        advance(2);
      } else {
        advance();
      }
    } while (depth > 0 && more());
    if (depth > 0) out_.errors.push_back(open);
  }

  void one() {
    const char c = at();
    if (is_letter(c)) word(Kind::word);
    else if (is_digit(c) || (c == '.' && is_digit(at(1)))) number();
    else if (c == '"') string();
    else if (c == '#') directive();
    else mark();
  }

  void word(Kind kind) {
    std::size_t length = 0;
    while (is_letter(at(length)) || is_digit(at(length))) ++length;
    push(kind, symbols_.intern(text_.substr(position_, length)));
    advance(length);
  }

  void number() {
    std::size_t length = 0;
    while (is_digit(at(length))) ++length;
    if (at(length) == '.') {
      ++length;
      while (is_digit(at(length))) ++length;
      if (at(length) == '.') hard_error("Unexpected additional '.' in floating-point number");
    }
    const std::size_t mantissa = length;
    if (at(length) == 'e' || at(length) == 'E') {
      ++length;
      if (at(length) == '+' || at(length) == '-') ++length;
      while (is_digit(at(length))) ++length;
    }
    double value = 0;
    const char* first = text_.data() + position_;
    const auto read = std::from_chars(first, first + length, value);
    if (read.ec == std::errc::result_out_of_range) {
      const bool tiny = length > mantissa + 1 && at(mantissa + 1) == '-';
      value = tiny ? 0.0 : 1e308 * 10;
    }
    push(Kind::number).number = value;
    advance(length);
    while (at() == '.' && !out_.errors.empty() && out_.errors.back().line == line_) {
      advance();
      while (is_digit(at())) advance();
    }
  }

  void string() {
    const LexicalError open{line_, column(), "No end quote for string."};
    push(Kind::string, static_cast<std::uint32_t>(out_.strings.size()));
    advance();
    const std::size_t start = position_;
    while (more() && at() != '"') advance(at() == '\\' ? 2 : 1);
    out_.strings.emplace_back(text_.substr(start, position_ - start));
    if (more()) advance();
    else out_.errors.push_back(open);
  }

  void directive() {
    std::size_t blanks = 1;
    while (is_blank(at(blanks)) && at(blanks) != '\n') ++blanks;
    std::size_t length = 0;
    while (is_letter(at(blanks + length))) ++length;
    const Symbol symbol = symbols_.intern(text_.substr(position_ + blanks, length));
    if (length == 0 || class_of(symbol) != KeywordClass::directive) {
      advance();  // as in POV-Ray, a `#` before anything else is nothing
      return;
    }
    push(Kind::directive, symbol).link = no_link;
    advance(blanks + length);
  }

  void mark() {
    const char c = at();
    const bool equals = at(1) == '=';
    if (equals && (c == '<' || c == '>' || c == '!')) {
      push(Kind::mark, c == '<' ? mark_le : c == '>' ? mark_ge : mark_ne);
      advance(2);
      return;
    }
    const auto byte = static_cast<unsigned char>(c);
    push(byte > 32 && byte < 127 ? Kind::mark : Kind::bad, byte);
    advance();
  }

  std::string_view text_;
  TokenFile& out_;
  Symbols& symbols_;
  std::size_t most_;
  std::size_t position_ = 0, line_start_ = 0;
  std::uint32_t line_ = 1, end_line_ = 0, end_column_ = 0;
};

}  // namespace

std::shared_ptr<TokenFile> tokenise(std::string_view text, std::uint32_t file, Symbols& symbols,
                                    std::size_t most) {
  auto tokens = std::make_shared<TokenFile>();
  tokens->file = file;
  Lexer(text, *tokens, symbols, most).run();
  link_directives(*tokens);
  return tokens;
}

}  // namespace nicol::sdl
