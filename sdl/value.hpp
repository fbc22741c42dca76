// What a name can stand for.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "budget.hpp"
#include "lexer.hpp"
#include "tree.hpp"

namespace nicol::sdl {

// 1 to 5 numbers: a float has size 1; a colour has size 5 and its flag.
struct Numbers {
  std::array<double, 5> v{};
  int size = 1;
  bool colour = false;
  Numbers() = default;
  Numbers(double f) : v{f, 0, 0, 0, 0} {}
};

// The same with `size` components: a float fills them all, a shorter vector is padded with 0.
Numbers promoted(const Numbers& n, int size);

struct Text {
  Text(Budget& budget, std::string t) : charge(budget, t.size() + 32), text(std::move(t)) {}
  Charge charge;
  std::string text;
};
using TextPtr = std::shared_ptr<const Text>;

struct Unset {};   // an array element not yet given
struct Broken {};  // its declaration failed and was reported
struct Array;
struct Function;
struct Macro;
using ArrayPtr = std::shared_ptr<Array>;
using FunctionPtr = std::shared_ptr<const Function>;
using MacroPtr = std::shared_ptr<const Macro>;

using Value = std::variant<Unset, Broken, Numbers, TextPtr, ArrayPtr, FunctionPtr, BlockPtr, MacroPtr>;

// A name's or an array element's place; macro parameters by reference share it.
struct Cell {
  Value value;
};
using CellPtr = std::shared_ptr<Cell>;

struct Array {
  Array(Budget& budget, std::vector<std::size_t> dims, std::size_t count)
      : charge(budget, count), dimensions(std::move(dims)), elements(count) {}
  Charge charge;
  std::vector<std::size_t> dimensions;
  std::vector<Cell> elements;  // the last dimension runs fastest
};

struct Macro {
  std::string name;
  std::vector<Symbol> parameters;
  TokenFilePtr tokens;
  std::uint32_t begin = 0, end = 0;  // lexemes of the body
};

// "float identifier", "string identifier"... as POV-Ray's messages name them.
std::string kind_name(const Value& value);

Value copied(const Value& value, Budget& budget);  // arrays are copied, the rest is shared

}  // namespace nicol::sdl
