// #declare, #local and #undef.
#include "parser.hpp"

namespace nicol::sdl {

// `#declare [deprecated [once] ["message"]] Name[i]... = value`
void Parser::declare_directive(bool local) {
  Token name = next_held(false);
  Deprecation deprecation{"", false};
  const bool deprecated = name.undeclared() && symbols_.text(name.index) == "deprecated";
  if (deprecated) {
    name = next_held(false);
    if (name.undeclared() && symbols_.text(name.index) == "once") {
      deprecation.once = true;
      name = next_held(false);
    }
    if (name.kind == Kind::string) {
      deprecation.message = name.text->text;
      name = next_held(false);
    }
  }
  if (name.kind != Kind::word || is_reserved(name) || name.holds<MacroPtr>() ||
      name.keyword_class() != KeywordClass::none) {
    fail("undeclared identifier", name);
  }
  CellPtr element;
  const auto* array = name.holds<ArrayPtr>();
  while (array && peek().is('[')) {
    element = subscripted(name, *array);
    array = std::get_if<ArrayPtr>(&element->value);
  }
  Token equals = next_held(true);
  if (!equals.is('=')) fail("=", equals);
  assign(name, local, element != nullptr, element);
  if (deprecated) {
    if (deprecation.message.empty()) {
      deprecation.message = "The identifier '" + symbols_.text(name.index) +
                            "' was declared with '#declare deprecated ...'.";
    }
    deprecated_[name.index] = deprecation;
  }
}

namespace {

// What an array may hold beside what it holds already.
std::size_t family(const Value& value) {
  const auto* n = std::get_if<Numbers>(&value);
  return value.index() * 2 + (n && n->size > 1 ? 1 : 0);
}

}  // namespace

void Parser::assign(const Token& name, bool local, bool element, CellPtr cell) {
  const Mark here = mark();
  Value value = Broken{};
  try {
    if (name.holds<FunctionPtr>() && !element && (!local || scope_.is_local(name.index))) {
      throw Failure{name.where,
                    "Redeclaring functions is not allowed - #undef the function first!"};
    }
    push_back(next_held(true));
    if (pushed_.back().kind == Kind::stop) {
      pushed_.pop_back();
      fail("numeric expression", stop_);
    }
    value = rvalue(false);
  } catch (const Failure& failure) {
    report(failure);
    recover(here, Skip::directive);
  }
  if (!std::holds_alternative<Broken>(value)) semicolon(value);
  if (!element) cell = local ? scope_.declare_local(name.index) : scope_.declare(name.index);
  const Value& old = cell->value;
  const bool fresh = std::holds_alternative<Unset>(old) || std::holds_alternative<Broken>(old) ||
                     std::holds_alternative<Broken>(value);
  if (element && !fresh && family(old) != family(value)) {
    throw Failure{name.where, "Attempted to redefine " + kind_name(old) + " as " +
                                  kind_name(value) + "."};
  }
  cell->value = std::move(value);
}

// Floats, vectors and colours need one; elsewhere it is taken if it is there.
void Parser::semicolon(const Value& value) {
  if (std::holds_alternative<Numbers>(value)) {
    const Token& after = peek_operator();
    if (after.is(';')) {
      next();
    } else if (version_ >= 3.5) {
      report({after.where,
              "All #declares of float, vector, and color require semi-colon ';' at end if the "
              "language version is set to 3.5 or higher. Either add the semi-colon or set the "
              "language version to 3.1 or lower."});
      // What cannot begin anything is what was left out of the value.
      if (after.kind == Kind::mark || after.kind == Kind::number) recover(mark(), Skip::directive);
    }
    return;
  }
  if (!pushed_.empty()) {
    accept(';');
    return;
  }
  const Lexeme* after = peek_lexeme();
  if (after && after->kind == Kind::mark && after->index == ';') next();
}

void Parser::read_deprecation(const Token& name) {
  const auto found = deprecated_.find(name.index);
  if (found == deprecated_.end()) return;
  warn(name.where, found->second.message);
  if (found->second.once) deprecated_.erase(found);
}

void Parser::undef_directive() {
  Token name = next_name();
  if (name.kind != Kind::word || name.keyword_class() != KeywordClass::none) {
    fail("identifier", name);
  }
  const auto* array = name.holds<ArrayPtr>();
  if (array && peek().is('[')) {
    subscripted(name, *array)->value = Unset{};
  } else if (!scope_.undefine(name.index)) {
    warn(name.where, "Attempt to undef unknown identifier");
  }
  semicolon(Value{});
}

}  // namespace nicol::sdl
