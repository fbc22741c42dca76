// Blocks and their items. Words keep no meaning here; declared names are replaced by what they hold.
#include "parser.hpp"

namespace nicol::sdl {

// `name` is read, `{` is next.
BlockPtr Parser::block(const Token& name) {
  if (name.is(Keyword::k_function)) return function_text(name);
  const Nest nest(*this);
  expect('{');
  auto made = std::make_shared<Block>();
  made->name = symbols_.text(name.index);
  made->where = name.where;
  made->defaults = defaults_;
  items(*made, '}');
  finish(*made);
  return made;
}

void Parser::finish(Block& b) {
  for (const Item& item : b.items) {
    const Block* child = item.block();
    b.weight += child ? child->weight : 1;
    if (child && child->depth >= b.depth) b.depth = child->depth + 1;
    if (b.weight > most_weight()) throw LimitReached{"Too many objects."};
  }
  if (b.depth > options_.limits.nesting_depth) throw LimitReached{"Too many nested '{' braces."};
}

// Items up to the closing mark; an error in one does not keep the others from being read.
void Parser::items(Block& b, char closer) {
  const int grouping = grouping_;
  grouping_ = 0;
  for (;;) {
    const Mark here = mark();
    try {
      if (peek().is(closer)) break;
      if (peek().kind == Kind::end) {
        report({peek().where, "No matching } in '" + b.name + "', End of File found instead"});
        throw Halt{};
      }
      if (!accept(',')) item(b);
    } catch (const Failure& failure) {
      report(failure);
      b.damaged = true;
      recover(here, Skip::item);
      if (closer == ']' && peek_lexeme() && pushed_.empty()) {
        if (accept('}')) break;
      }
    }
  }
  b.end_where = next().where;
  grouping_ = grouping;
}

void Parser::add(Block& b, Item item) {
  const auto* text = item.string();
  budget_.charge(1 + (text ? text->size() / 32 : 0));
  b.items.push_back(std::move(item));
}

void Parser::item(Block& b) {
  Token token = next_value();
  if (token.is('[')) {
    list_item(b, token);
  } else if (token.kind == Kind::word && !token.cell && !token.is(Keyword::k_version)) {
    word_item(b, std::move(token));
  } else {
    value_item(b, std::move(token));
  }
}

// A word that is no name: a block, a plain word, or one of the language's own.
void Parser::word_item(Block& b, Token token) {
  const Token& after = peek();
  bool plain = false;
  switch (token.keyword_class()) {
    case KeywordClass::none: case KeywordClass::directive: case KeywordClass::maker:
      if (after.is('{') || token.is(Keyword::k_function)) {
        Item made{block(token), token.where};
        add(b, std::move(made));
        return;
      }
      plain = true;
      break;
    case KeywordClass::channel:
      plain = token.index > static_cast<Symbol>(Keyword::k_blue) || !starts_expression(after);
      break;
    case KeywordClass::colour:  // `assumed_gamma srgb` is no colour
      plain = token.is(Keyword::k_srgb) && !starts_expression(after);
      break;
    case KeywordClass::float_function: case KeywordClass::other_function:
    case KeywordClass::string_function:
      plain = !after.is('(');
      break;
    case KeywordClass::constant: break;
  }
  if (plain) add(b, {Word{symbols_.text(token.index)}, token.where});
  else value_item(b, std::move(token));
}

// A word or a string stands where a number was needed, as the operator after it shows.
void Parser::fail_before(const Token& word, const Token& after) {
  if (names_unknown_ && word.undeclared()) throw Failure{word.where, ""};
  push_back(after);
  throw Failure{word.where, "Expected 'numeric expression', " + describe(word) + " found instead" +
                                hint(word)};
}

namespace {

Item number_item(const Numbers& n, Location where) {
  if (n.size == 1) return {n.v[0], where};
  Vector v;
  v.size = n.size;
  v.colour = n.colour;
  for (std::size_t i = 0; i < 5; ++i) v.v[i] = static_cast<int>(i) < n.size ? n.v[i] : 0;
  return {v, where};
}

}  // namespace

void Parser::value_item(Block& b, Token token) {
  const Location where = token.where;
  if (starts_string(token)) {
    push_back(std::move(token));
    add(b, {string_value()->text, where});
  } else if (token.is('<')) {
    list_item(b, token);
  } else if (token.holds<BlockPtr>() && !calls_spline(token)) {
    add(b, {*token.holds<BlockPtr>(), where});
  } else if (token.keyword_class() == KeywordClass::colour ||
             token.keyword_class() == KeywordClass::channel) {
    add(b, number_item(colour(std::move(token)), where));
  } else if (starts_expression(token)) {
    push_back(std::move(token));
    add(b, number_item(sum(), where));
  } else {
    const Item* before = b.items.empty() ? nullptr : &b.items.back();
    const bool operates = token.is('*') || token.is('/') || token.is('.');
    if (operates && before && (before->word() || before->string())) {  // meant as a number
      Token meant;
      meant.kind = before->word() ? Kind::word : Kind::string;
      if (before->word()) meant.index = symbols_.intern(*before->word());
      meant.where = before->where;
      fail_before(meant, token);
    }
    fail_in(b.name, token);
  }
}

// `[ items ]`, or `< numbers >`: a vector that may go on as an expression, a matrix, or a long list.
void Parser::list_item(Block& b, const Token& open) {
  if (open.is('[')) {
    const Nest nest(*this);
    auto list = std::make_shared<Block>();
    list->name = "[";
    list->where = open.where;
    items(*list, ']');
    finish(*list);
    add(b, {BlockPtr(std::move(list)), open.where});
    return;
  }
  const std::vector<double> numbers = components();
  const std::string* before = b.items.empty() ? nullptr : b.items.back().word();
  if (before && *before == "matrix") {
    if (numbers.size() != 12) {
      throw Failure{open.where, "Expected '12 numbers', " + std::to_string(numbers.size()) +
                                    " found instead"};
    }
    Vector matrix;
    matrix.size = 12;
    for (std::size_t i = 0; i < 12; ++i) matrix.v[i] = numbers[i];
    add(b, {matrix, open.where});
  } else if (numbers.size() > 5) {
    auto list = std::make_shared<Block>();
    list->name = "<";
    list->where = open.where;
    for (double n : numbers) add(*list, {n, open.where});
    finish(*list);
    add(b, {BlockPtr(std::move(list)), open.where});
  } else {
    Numbers first;
    first.size = static_cast<int>(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) first.v[i] = numbers[i];
    add(b, number_item(sum(first), open.where));
  }
}

// `texture { } texture { }` declared as one thing.
BlockPtr Parser::layers(const Token& name) {
  BlockPtr first = block(name);
  if (first->name != "texture" || !another_layer()) return first;
  auto all = std::make_shared<Block>();
  all->name = "textures";
  all->where = first->where;
  all->defaults = first->defaults;
  add(*all, {first, first->where});
  while (another_layer()) {
    const Token next_name = next();
    add(*all, {block(next_name), next_name.where});
  }
  all->end_where = last_;
  finish(*all);
  return all;
}

// Whether a further `texture` follows, behind the conditionals that may stand around it.
bool Parser::another_layer() {
  const Symbol texture = symbols_.intern("texture");
  if (pushed_.empty()) {
    const Lexeme* lexeme = peek_lexeme();
    if (!lexeme) return false;
    if (lexeme->kind == Kind::word) return lexeme->index == texture;
    if (lexeme->kind != Kind::directive || frame().position >= frame().end) return false;
    const auto keyword = static_cast<Keyword>(lexeme->index);
    const auto& controls = frame().controls;
    const bool in_if = !controls.empty() && controls.back().keyword == Keyword::k_if;
    const bool conditional = keyword == Keyword::k_if || keyword == Keyword::k_ifdef ||
                             keyword == Keyword::k_ifndef ||
                             (in_if && (keyword == Keyword::k_else || keyword == Keyword::k_elseif ||
                                        keyword == Keyword::k_end));
    if (!conditional) return false;
  }
  const Token& after = peek_operator();
  return after.undeclared() && after.index == texture;
}

}  // namespace nicol::sdl
