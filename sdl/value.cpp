// Promotion, copies and names of values.
#include "value.hpp"

#include "function.hpp"

namespace nicol::sdl {

Numbers promoted(const Numbers& n, int size) {
  Numbers out = n;
  if (n.size == 1) {
    for (int i = 1; i < size; ++i) out.v[static_cast<std::size_t>(i)] = n.v[0];
  }
  if (n.size < size) out.size = size;
  return out;
}

std::string kind_name(const Value& value) {
  if (std::holds_alternative<Unset>(value)) return "uninitialized identifier";
  if (const auto* n = std::get_if<Numbers>(&value)) {
    if (n->size == 1) return "float identifier";
    return n->colour ? "color identifier" : "vector identifier";
  }
  if (std::holds_alternative<TextPtr>(value)) return "string identifier";
  if (std::holds_alternative<ArrayPtr>(value)) return "array identifier";
  if (const auto* f = std::get_if<FunctionPtr>(&value)) {
    return (*f)->vector_valued() ? "vector function identifier" : "float function identifier";
  }
  if (std::holds_alternative<MacroPtr>(value)) return "macro identifier";
  if (const auto* block = std::get_if<BlockPtr>(&value)) return (*block)->name + " identifier";
  return "identifier";
}

Value copied(const Value& value, Budget& budget) {
  const auto* array = std::get_if<ArrayPtr>(&value);
  if (!array) return value;
  auto copy = std::make_shared<Array>(budget, (*array)->dimensions, (*array)->elements.size());
  for (std::size_t i = 0; i < copy->elements.size(); ++i) {
    copy->elements[i].value = copied((*array)->elements[i].value, budget);
  }
  return copy;
}

}  // namespace nicol::sdl
