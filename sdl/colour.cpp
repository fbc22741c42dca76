// Colours: `rgb <...>`, `color red 1 green .5`, `color Ident filter .9`. Always five numbers.
#include <cmath>

#include "parser.hpp"

namespace nicol::sdl {
namespace {

// IEC 61966-2-1: the linear value of an encoded one.
double decoded(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

Numbers five(Numbers n) {
  n.size = 5;
  n.colour = true;
  return n;
}

}  // namespace

// One part, as `rgbt <...>` or `transmit .5`; false if the token begins none.
bool Parser::colour_part(const Token& token, Numbers& c) {
  const auto keyword = static_cast<Keyword>(token.index);
  switch (token.keyword_class()) {
    case KeywordClass::channel: {
      const std::size_t index = token.index - static_cast<Symbol>(Keyword::k_red);
      if (keyword == Keyword::k_gray) return false;
      c.v[index] = number();
      return true;
    }
    case KeywordClass::colour: break;
    default: return false;
  }
  if (keyword == Keyword::k_color || keyword == Keyword::k_colour) {
    c = five(promoted(sum(), 5));
    return true;
  }
  const std::string& name = symbols_.text(token.index);
  const bool encoded = name[0] == 's';
  const bool filter = name.find('f') != std::string::npos;
  const bool transmit = name.find('t') != std::string::npos;
  const int size = 3 + (filter ? 1 : 0) + (transmit ? 1 : 0);
  const Numbers given = promoted(sum(), size);
  for (std::size_t i = 0; i < 3; ++i) c.v[i] = encoded ? decoded(given.v[i]) : given.v[i];
  c.v[3] = filter ? given.v[3] : 0;
  c.v[4] = transmit ? given.v[filter ? 4 : 3] : 0;
  return true;
}

Numbers Parser::colour(Token token) {
  const Nest nest(*this);
  Numbers c = five(Numbers());
  for (;;) {
    const bool is_name = token.is(Keyword::k_color) || token.is(Keyword::k_colour);
    if (is_name) {
      const KeywordClass after = peek().keyword_class();
      if (after == KeywordClass::colour || after == KeywordClass::channel) token = next();
    }
    if (!colour_part(token, c)) fail("color expression", token);
    // `filter` and its kind go on only if a number follows: `filter all` belongs to others.
    if (peek_operator().keyword_class() != KeywordClass::channel) return c;
    token = next();
    if (!starts_expression(peek_operator())) {
      push_back(std::move(token));
      return c;
    }
  }
}

}  // namespace nicol::sdl
