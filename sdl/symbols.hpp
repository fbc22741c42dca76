// Words as numbers: every distinct word of a parse has one, and the keywords come first.
#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace nicol::sdl {

using Symbol = std::uint32_t;

enum class Keyword : Symbol {
#define KEYWORD(name, kind) k_##name,
#include "keywords.def"
#undef KEYWORD
  count
};

enum class KeywordClass : std::uint8_t {
  none, directive, constant, colour, channel, maker, float_function, other_function, string_function
};

KeywordClass class_of(Symbol symbol);

class Symbols {
 public:
  Symbols();
  Symbol intern(std::string_view text);
  const std::string& text(Symbol symbol) const { return texts_[symbol]; }
  std::size_t size() const { return texts_.size(); }

 private:
  std::deque<std::string> texts_;  // a deque: the map's views stay valid
  std::unordered_map<std::string_view, Symbol> index_;
};

}  // namespace nicol::sdl
