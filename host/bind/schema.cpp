// The reader of blocks: see schema.hpp.
#include "host/bind/schema.hpp"

#include <cmath>
#include <cstring>

namespace nicol {

namespace {

const char* expected_name(char kind) {
  switch (kind) {
    case 'n':
    case 'N':
    case 'b':
      return "numeric expression";
    case 'v':
    case 'V':
    case 'm':
    case 't':
      return "vector expression";
    case 'p':
    case 'P':
      return "2D vector expression";
    case 'c':
      return "color expression";
    case 'd':
      return "vector expression', 'a', 'b' or 'c";
    case 's':
      return "string expression";
    default:
      return "word";
  }
}

// Walks the items of one block.
class Reader {
 public:
  Reader(Context& context, const sdl::Block& block, const Schema& schema)
      : context_(context), block_(block), schema_(schema) {}

  void read() {
    while (at_ < block_.items.size()) {
      const sdl::Item& item = block_.items[at_];
      context_.step(item.where);
      if (const std::string* word = item.word()) read_word(*word);
      else if (const sdl::Block* inner = item.block()) read_inner(*inner);
      else read_bare_value();
    }
  }

 private:
  bool is_value() const {
    return at_ < block_.items.size() && !block_.items[at_].word() && !block_.items[at_].block();
  }

  void skip_values() {
    while (is_value()) ++at_;
  }

  void read_word(const std::string& word) {
    const Location where = block_.items[at_].where;
    ++at_;
    if (const Rule* rule = schema_.find(word, false)) return apply(*rule, where);
    if (const Ignored* ignored = schema_.find_ignored(word)) {
      tell_ignored(*ignored, word, where);
    } else {
      complain_unknown("word", word, where);
    }
    skip_values();
  }

  void read_inner(const sdl::Block& inner) {
    const Location where = block_.items[at_].where;
    ++at_;
    if (schema_.take_block && schema_.take_block(inner)) return;
    if (const Rule* rule = schema_.find(inner.name, true)) {
      Args args;
      args.where = inner.where.line ? inner.where : where;
      args.block = &inner;
      return rule->act(args);
    }
    if (schema_.inherits && inner.name == schema_.block)
      return read_block(context_, inner, schema_);
    if (const Ignored* ignored = schema_.find_ignored(inner.name)) {
      tell_ignored(*ignored, inner.name, where);
    } else {
      complain_unknown("block", inner.name, where);
    }
  }

  void read_bare_value() {
    const sdl::Item& item = block_.items[at_];
    const Rule* rule = schema_.find("", false);
    if (rule && !bare_done_) {
      bare_done_ = true;
      return apply(*rule, item.where);
    }
    context_.error(item.where, "Expected a word or block of '" + block_.name + "', " +
                                   describe(item) + " found instead");
    skip_values();
  }

  void apply(const Rule& rule, Location where) {
    Args args;
    args.where = where;
    for (const char* kind = rule.kinds; *kind; ++kind) {
      if (!take(*kind, args)) return skip_values();
    }
    rule.act(args);
  }

  bool missing(char kind) {
    const bool at_end = at_ >= block_.items.size();
    const Location where = at_end ? block_.end_where : block_.items[at_].where;
    context_.error(where,
                   std::string("Expected '") + expected_name(kind) + "', " +
                       (at_end ? "} of '" + block_.name + "'" : describe(block_.items[at_])) +
                       " found instead");
    return false;
  }

  bool finite(double number) {
    if (std::isfinite(number)) return true;
    context_.error(block_.items[at_].where, "this number is not finite");
    return false;
  }

  bool take(char kind, Args& args) {
    switch (kind) {
      case '*':
        skip_values();
        return true;
      case 'N':
      case 'V':
      case 'P':
        return take_many(kind, args);
      case 'b':
        return take_switch(args);
      case 'w':
      case 's':
        return take_text(kind, args);
      case 'd':
        return take_direction(args);
      default:
        return take_one(kind, args);
    }
  }

  bool take_many(char kind, Args& args) {
    const char one = kind == 'N' ? 'n' : kind == 'V' ? 'v' : 'p';
    if (!is_value()) return missing(kind);
    while (is_value()) {
      context_.step(block_.items[at_].where);
      if (kind == 'N' && block_.items[at_].vector()) {  // <380, 1> counts as two numbers
        if (!take_one('t', args)) return false;
        args.numbers.insert(args.numbers.end(), args.tuple.begin(), args.tuple.end());
      } else if (!take_one(one, args)) {
        return false;
      }
    }
    return true;
  }

  bool take_switch(Args& args) {
    if (!is_value()) {
      args.numbers.push_back(1);
      return true;
    }
    return take_one('n', args);
  }

  bool take_text(char kind, Args& args) {
    if (at_ >= block_.items.size()) return missing(kind);
    const sdl::Item& item = block_.items[at_];
    const std::string* text = kind == 'w' ? item.word() : item.string();
    if (!text) return missing(kind);
    args.text = *text;
    ++at_;
    return true;
  }

  bool take_direction(Args& args) {
    const std::string* word = at_ < block_.items.size() ? block_.items[at_].word() : nullptr;
    if (!word) return components().size() == 3 ? take_one('v', args) : missing('d');
    if (*word != "a" && *word != "b" && *word != "c") return missing('d');
    args.vectors.push_back({double(*word == "a"), double(*word == "b"), double(*word == "c")});
    ++at_;
    return true;
  }

  // Components of the number or vector at hand; empty if it is neither, or not finite.
  std::vector<double> components() {
    std::vector<double> v;
    if (!is_value()) return v;
    const sdl::Item& item = block_.items[at_];
    if (const double* number = item.number()) v = {*number};
    if (const sdl::Vector* vector = item.vector())
      v.assign(vector->v.begin(), vector->v.begin() + vector->size);
    return v;
  }

  bool take_one(char kind, Args& args) {
    std::vector<double> v = components();
    if (v.empty()) return missing(kind);
    for (double c : v)
      if (!finite(c)) return false;
    const bool scalar = block_.items[at_].number() != nullptr;
    const bool fits = kind == 'n'   ? scalar
                      : kind == 'm' ? v.size() == 12
                      : kind == 'p' ? scalar || v.size() == 2
                      : kind == 't' ? true
                                    : scalar || (v.size() <= 5 && (kind == 'c' || v.size() <= 3));
    if (!fits) return missing(kind);
    store(kind, scalar, v, args);
    ++at_;
    return true;
  }

  static void store(char kind, bool scalar, std::vector<double>& v, Args& args) {
    if (kind == 't') {
      args.tuple = std::move(v);
      return;
    }
    if (kind == 'n' || kind == 'm') {
      args.numbers.insert(args.numbers.end(), v.begin(), v.end());
      return;
    }
    v.resize(3, scalar ? v[0] : 0);
    if (kind == 'v') args.vectors.push_back({v[0], v[1], v[2]});
    if (kind == 'p') args.points.push_back({v[0], v[1]});
    if (kind == 'c') args.colour = {v[0], v[1], v[2]};
  }

  void tell_ignored(const Ignored& ignored, const std::string& word, Location where) {
    std::string message = ignored.reason;
    if (message.empty()) return;
    const std::size_t hole = message.find("%s");
    if (hole != std::string::npos) message.replace(hole, 2, "'" + word + "'");
    if (ignored.warns) context_.warn_once(ignored.reason + word, where, message);
    else context_.note_once(ignored.reason, where, message);
  }

  void complain_unknown(const std::string& what, const std::string& name, Location where) {
    if (schema_.lenient) return tell_ignored({schema_.lenient, true, {}}, name, where);
    std::vector<std::string> known = schema_.known_blocks;
    for (const Rule& rule : schema_.rules)
      if (*rule.name) known.push_back(rule.name);
    context_.error(where, unknown(what, name, "'" + std::string(schema_.block) + "'", known));
  }

  Context& context_;
  const sdl::Block& block_;
  const Schema& schema_;
  std::size_t at_ = 0;
  bool bare_done_ = false;
};

}  // namespace

const Rule* Schema::find(std::string_view name, bool as_block) const {
  for (const Rule& rule : rules)
    if (name == rule.name && (std::strcmp(rule.kinds, "{}") == 0) == as_block) return &rule;
  return nullptr;
}

const Ignored* Schema::find_ignored(std::string_view name) const {
  for (const Ignored& group : ignored)
    for (const char* word : group.words)
      if (name == word) return &group;
  return nullptr;
}

void read_block(Context& context, const sdl::Block& block, const Schema& schema) {
  const Context::Depth depth(context, block.where);
  context.step(block.where, context.limits.block_steps);
  Reader(context, block, schema).read();
}

std::string describe(const sdl::Item& item) {
  if (const std::string* word = item.word()) return "'" + *word + "'";
  if (const double* number = item.number()) return "number " + to_text(*number);
  if (const sdl::Vector* vector = item.vector())
    return vector->colour ? "color expression" : std::to_string(vector->size) + "-vector";
  if (item.string()) return "string literal";
  return "'" + item.block()->name + "' block";
}

std::string unknown(const std::string& what, const std::string& name, const std::string& place,
                    const std::vector<std::string>& known) {
  std::string message = "unknown " + what + " '" + name + "' in " + place;
  const std::string near = sdl::nearest_word(name, known);
  if (!near.empty()) return message + "; did you mean '" + near + "'?";
  std::string list;
  for (const std::string& word : known)
    if (list.find("'" + word + "'") == std::string::npos)
      list += (list.empty() ? "'" : ", '") + word + "'";
  return list.empty() ? message : message + "; known here: " + list;
}

}  // namespace nicol
