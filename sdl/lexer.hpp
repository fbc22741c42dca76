// A file as an array of lexemes, made once; loops and macros are ranges of it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "symbols.hpp"

namespace nicol::sdl {

enum class Kind : std::uint8_t {
  end,        // nothing more
  number,
  string,     // `index` into TokenFile::strings, as written (escapes not yet read)
  word,       // `index` is its symbol
  mark,       // punctuation; `index` is the character, or one of the two-character marks below
  directive,  // `#word`; `index` is the keyword, `link` the lexeme to go on with (see link.cpp)
  bad,        // an illegal byte; an error only if somebody wants it
  value,      // made by the parser: a value already read
  stop        // made by the parser: a directive that must wait
};

constexpr std::uint32_t mark_le = 256, mark_ge = 257, mark_ne = 258;
constexpr std::uint32_t no_link = 0xffffffffu;

struct Lexeme {
  Kind kind = Kind::end;
  std::uint32_t line = 0, column = 0;
  std::uint32_t index = 0;
  union {
    double number = 0;
    std::uint32_t link;
  };
};

struct LexicalError {
  std::uint32_t line, column;
  std::string message;
};

struct TokenFile {
  std::uint32_t file = 0;  // in Sources
  std::vector<Lexeme> lexemes;  // ends with Kind::end
  std::vector<std::string> strings;
  std::vector<LexicalError> errors;  // those that count even in skipped text
};

using TokenFilePtr = std::shared_ptr<const TokenFile>;

// Cuts text into lexemes, at most `most` of them.
std::shared_ptr<TokenFile> tokenise(std::string_view text, std::uint32_t file, Symbols& symbols,
                                    std::size_t most);

// Joins every #if, #while, #macro... to its #else, #case, #end.
void link_directives(TokenFile& tokens);

}  // namespace nicol::sdl
