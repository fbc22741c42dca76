// A stack of bindings per name, so that finding one costs nothing however deep the calls are.
#include "scope.hpp"

namespace nicol::sdl {

std::vector<Scope::Binding>& Scope::at(Symbol name) {
  if (name >= names_.size()) names_.resize(name + 64);
  return names_[name];
}

CellPtr Scope::declare(Symbol name) {
  auto& bindings = at(name);
  if (bindings.empty()) bindings.push_back({0, std::make_shared<Cell>()});
  return bindings.back().cell;
}

bool Scope::is_local(Symbol name) const {
  return name < names_.size() && !names_[name].empty() &&
         names_[name].back().level == levels_.size() - 1;
}

CellPtr Scope::declare_local(Symbol name) {
  if (!is_local(name)) bind(name, std::make_shared<Cell>());
  return names_[name].back().cell;
}

void Scope::bind(Symbol name, CellPtr cell) {
  const std::size_t level = levels_.size() - 1;
  auto& bindings = at(name);
  if (!bindings.empty() && bindings.back().level == level) {
    bindings.back().cell = std::move(cell);
    return;
  }
  bindings.push_back({level, std::move(cell)});
  if (level > 0) levels_.back().push_back(name);
}

bool Scope::undefine(Symbol name) {
  auto& bindings = at(name);
  if (bindings.empty()) return false;
  bindings.pop_back();
  return true;
}

void Scope::close() {
  const std::size_t level = levels_.size() - 1;
  for (Symbol name : levels_.back()) {
    auto& bindings = names_[name];
    if (!bindings.empty() && bindings.back().level == level) bindings.pop_back();
  }
  levels_.pop_back();
}

}  // namespace nicol::sdl
