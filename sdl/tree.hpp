// The tree that the language yields: blocks, words and values with the place each came from.
// No optics here: `sphere { ... }` and `interior { ... }` are blocks alike; host/bind gives words meaning.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace nicol::sdl {

// A place in the source. `file` indexes Sources; line and column count from 1; `call` indexes the
// chain of macro calls that led here (0: none).
struct Location {
  std::uint32_t file = 0, line = 0, column = 0, call = 0;
};

// 1 to 12 numbers: POV-Ray's 2- to 5-vectors, and 12 for `matrix`. A colour is r, g, b, filter, transmit.
struct Vector {
  std::array<double, 12> v{};
  int size = 3;
  bool colour = false;
};

struct Block;
using BlockPtr = std::shared_ptr<const Block>;  // shared: an identifier used twice is one block

// A word with no meaning to the parser, as `ior` or `orthographic`.
struct Word {
  std::string text;
};

// One thing inside a block, in written order. Commas only separate; they leave no trace.
struct Item {
  std::variant<Word, double, Vector, std::string, BlockPtr> value;
  Location where;
  const std::string* word() const;   // null unless it is a word
  const double* number() const;      // likewise
  const Vector* vector() const;
  const std::string* string() const;
  const Block* block() const;
};

// `name { items }`. A `[ ... ]` list is a block named "[". `#default { ... }` is a block named "#default".
// A `< ... >` list of more than 5 numbers is a block named "<", unless it is the 12 of `matrix`.
// Declared `texture { } texture { }` is one block named "textures". `function { ... }` among items is
// a block named "function" that holds its text as one string.
// A declared identifier that holds a block stands as that block: `object { Thing rotate x }` is
// Block("object", {Block("box", ...), Word rotate, Vector x}).
struct Block {
  std::string name;
  std::vector<Item> items;
  Location where;      // its name
  Location end_where;  // its closing brace
  bool damaged = false;  // an error inside was reported: do not complain of what is missing
  int depth = 1;         // of blocks within blocks
  std::size_t weight = 1;      // things within, those of shared blocks counted at each use
  std::uint32_t defaults = 0;  // how many #default blocks stood before it
};

// The whole scene: the top-level blocks in order.
struct Document {
  std::vector<Item> items;
};

// Writes a tree as scene text that parses to the same tree (the shortest digits that read back exactly).
std::string print(const Document& document);

// Equal names, values and order; locations do not count.
bool equal(const Document& a, const Document& b);

}  // namespace nicol::sdl
