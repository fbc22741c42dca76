// The table of words, opened with the keywords in the order of their enumeration.
#include "symbols.hpp"

namespace nicol::sdl {
namespace {

struct Row {
  std::string_view name;
  KeywordClass kind;
};

constexpr Row rows[] = {
#define KEYWORD(name, kind) {#name, KeywordClass::kind},
#include "keywords.def"
#undef KEYWORD
};

}  // namespace

KeywordClass class_of(Symbol symbol) {
  return symbol < static_cast<Symbol>(Keyword::count) ? rows[symbol].kind : KeywordClass::none;
}

Symbols::Symbols() {
  for (const Row& row : rows) intern(row.name);
}

Symbol Symbols::intern(std::string_view text) {
  const auto found = index_.find(text);
  if (found != index_.end()) return found->second;
  const auto symbol = static_cast<Symbol>(texts_.size());
  texts_.emplace_back(text);
  index_.emplace(texts_.back(), symbol);
  return symbol;
}

}  // namespace nicol::sdl
