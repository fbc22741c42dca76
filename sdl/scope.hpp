// Dynamic scope: a name means its newest living declaration; macro calls and include files open a level.
#pragma once
#include <unordered_map>

#include "value.hpp"

namespace nicol::sdl {

class Scope {
 public:
  CellPtr find(Symbol name) const {
    return name < names_.size() && !names_[name].empty() ? names_[name].back().cell : nullptr;
  }
  // The visible one, or a new global one.
  CellPtr declare(Symbol name);
  // The one of this level, or a new one at this level.
  CellPtr declare_local(Symbol name);
  bool is_local(Symbol name) const;
  // Binds the name at this level to a cell that exists (a parameter by reference).
  void bind(Symbol name, CellPtr cell);
  bool undefine(Symbol name);  // the newest one; false if there is none

  void open() { levels_.emplace_back(); }
  void close();
  std::size_t depth() const { return levels_.size(); }

  template <typename Visit>
  void each_name(Visit visit) const {
    for (Symbol s = 0; s < names_.size(); ++s) {
      if (!names_[s].empty()) visit(s);
    }
  }

 private:
  struct Binding {
    std::size_t level;
    CellPtr cell;
  };
  std::vector<Binding>& at(Symbol name);
  std::vector<std::vector<Binding>> names_;
  std::vector<std::vector<Symbol>> levels_{1};  // what each level bound; level 0 is global
};

}  // namespace nicol::sdl
