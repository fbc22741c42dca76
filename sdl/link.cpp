// Joins conditional directives within a file, so that skipping text is one jump:
// #if -> #elseif -> #else -> #end, #switch -> #case -> ... -> #end, #while -> #end, #macro -> #end,
// and #end back to what it ends. What has no partner keeps no_link.
#include "lexer.hpp"

namespace nicol::sdl {
namespace {

struct Open {
  std::uint32_t opener, last;  // last: the branch that waits for its link
  Keyword keyword;
};

bool opens(Keyword k) {
  return k == Keyword::k_if || k == Keyword::k_ifdef || k == Keyword::k_ifndef ||
         k == Keyword::k_switch || k == Keyword::k_while || k == Keyword::k_for ||
         k == Keyword::k_macro;
}

bool branches(Keyword k, Keyword opener) {
  const bool in_if = opener == Keyword::k_if || opener == Keyword::k_ifdef ||
                     opener == Keyword::k_ifndef;
  if (k == Keyword::k_else) return in_if || opener == Keyword::k_switch;
  if (k == Keyword::k_elseif) return in_if;
  if (k == Keyword::k_case || k == Keyword::k_range) return opener == Keyword::k_switch;
  return false;
}

}  // namespace

void link_directives(TokenFile& tokens) {
  std::vector<Open> open;
  auto& lexemes = tokens.lexemes;
  for (std::uint32_t i = 0; i < lexemes.size(); ++i) {
    if (lexemes[i].kind != Kind::directive) continue;
    const auto keyword = static_cast<Keyword>(lexemes[i].index);
    if (opens(keyword)) {
      open.push_back({i, i, keyword});
    } else if (keyword == Keyword::k_end && !open.empty()) {
      lexemes[open.back().last].link = i;
      lexemes[i].link = open.back().opener;
      open.pop_back();
    } else if (!open.empty() && branches(keyword, open.back().keyword)) {
      lexemes[open.back().last].link = i;
      open.back().last = i;
    }
  }
}

}  // namespace nicol::sdl
