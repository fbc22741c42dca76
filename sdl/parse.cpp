// The whole of a scene: statements until the text ends, whatever happens on the way.
#include "parse.hpp"

#include "parser.hpp"

namespace nicol::sdl {

Parser::Parser(const Options& options, Result& result)
    : options_(options), result_(result), budget_(options.limits.items),
      steps_left_(options.limits.steps), bytes_left_(options.limits.total_bytes) {
  stop_.kind = Kind::stop;
  predeclare();
}

void Parser::predeclare() {
  const auto number = [this](const char* name, double value) {
    scope_.declare(symbols_.intern(name))->value = Numbers(value);
  };
  number("image_width", options_.image_width);
  number("image_height", options_.image_height);
  number("clock_delta", options_.clock_delta);
  number("frame_number", options_.frame_number);
  number("initial_frame", options_.initial_frame);
  number("final_frame", options_.final_frame);
  number("initial_clock", options_.initial_clock);
  number("final_clock", options_.final_clock);
  for (const auto& [name, value] : options_.declares) number(name.c_str(), value);
}

void Parser::run_file(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  scene_folder_ = slash == std::string::npos ? "" : path.substr(0, slash);
  std::string why;
  const TokenFilePtr tokens = load(path, path, why);
  if (tokens) {
    run(tokens);
    return;
  }
  const std::uint32_t file = result_.sources.add(path, "");
  result_.diagnostics.error({file, 1, 1, 0}, "Cannot open input file.\n" + why);
}

void Parser::run_text(const std::string& name, std::string text) {
  if (text.size() > options_.limits.file_bytes) {
    const std::uint32_t file = result_.sources.add(name, "");
    result_.diagnostics.error({file, 1, 1, 0}, "Cannot open input file.\nit is too large");
    return;
  }
  const std::size_t slash = name.rfind('/');
  scene_folder_ = slash == std::string::npos ? "" : name.substr(0, slash);
  run(take_text(name, std::move(text)));
}

void Parser::run(TokenFilePtr tokens) {
  try {
    const auto name = result_.sources.name(tokens->file);
    scope_.declare(symbols_.intern("input_file_name"))->value = make_text(name);
    const auto end = static_cast<std::uint32_t>(tokens->lexemes.size() - 1);
    push_frame(tokens, 0, end, 0, false);
    for (;;) {
      const Mark here = mark();
      try {
        if (peek().kind == Kind::end) break;
        statement();
      } catch (const Failure& failure) {
        report(failure);
        recover(here, Skip::statement);
      }
    }
  } catch (const LimitReached& limit) {
    result_.diagnostics.error(last_, limit.message);
  } catch (const Halt&) {
  }
}

// A block, or a declared one by its name.
void Parser::statement() {
  Token token = next_value();
  Item item;
  item.where = token.where;
  if (const auto* declared = token.holds<BlockPtr>()) {
    item.value = *declared;
  } else if (token.undeclared() && peek().is('{')) {
    item.value = block(token);
  } else if (is_reserved(token)) {
    const Token after = next();
    fail_with(after, "Missing { after '" + describe(token) + "', " + describe(after) +
                         " found instead");
  } else {
    fail("object or directive", token);
  }
  add_statement(std::move(item));
}

void Parser::add_statement(Item item) {
  document_weight_ += std::get<BlockPtr>(item.value)->weight;
  if (document_weight_ > most_weight()) throw LimitReached{"Too many objects."};
  budget_.charge(1);
  result_.document.items.push_back(std::move(item));
}

namespace {
template <typename Run>
void guarded(Result& result, Run run) {
  try {
    run();
  } catch (const std::exception& error) {  // no memory, or a file that vanishes while it is read
    result.diagnostics.error({}, std::string("Out of memory.\n") + error.what());
  }
}
}  // namespace

void parse_file(const std::string& path, const Options& options, Result& result) {
  guarded(result, [&] { Parser(options, result).run_file(path); });
}

void parse_text(const std::string& name, std::string text, const Options& options, Result& result) {
  guarded(result, [&] { Parser(options, result).run_text(name, std::move(text)); });
}

}  // namespace nicol::sdl
