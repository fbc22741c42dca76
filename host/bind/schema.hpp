// The words that a block may hold, as a table of rules, and the one reader that walks a block by
// such a table: it checks the kinds of arguments, names unknown words with the nearest known one,
// and tells what is accepted but not rendered.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "host/bind/context.hpp"

namespace nicol {

// What a rule's action is given: its arguments, already of the right kinds.
struct Args {
  Location where;                             // of the word, or of the block's name
  const sdl::Block* block = nullptr;          // kind "{}"
  std::vector<double> numbers;                // kinds n, b and N; 12 of a matrix
  std::vector<Vec3> vectors;                  // kinds v, V and d
  std::vector<std::array<double, 2>> points;  // kinds p and P
  std::vector<double> tuple;                  // kind t: components of a vector of any size
  std::string text;                           // kinds s and w
  std::array<double, 3> colour{};             // kind c
};

// Kinds of arguments, one letter each:
//   n number   b on/off, may be left out (on)   v 3-vector (a number is promoted)   m 12-vector
//   p 2-vector t vector of any size, or a number   c colour (or vector, or number)   s string   w
//   word     d direction: a 3-vector, or one of the words a, b, c for <1,0,0>, <0,1,0>, <0,0,1>
//   * whatever values follow, unread
//   N, V, P    as many numbers, vectors, points as follow (at least one)
//   {}         the rule is a block of this name;  [ ] nothing: a bare word
struct Rule {
  const char* name;  // "": what comes without a word
  const char* kinds;
  std::function<void(const Args&)> act;
  const char* help;  // for the tables of the documentation
};

struct Ignored {
  const char* reason;  // "%s" stands for the word; "": nothing to tell
  bool warns;          // else a note
  std::vector<const char*> words;
};

struct Schema {
  const char* block;
  std::vector<Rule> rules;
  std::vector<Ignored> ignored;
  bool inherits = true;  // a block of the same name inside stands for its contents
  std::function<bool(const sdl::Block&)> take_block = {};  // asked about each inner block first
  const char* lenient =
      nullptr;  // what a warning says of words not known here; else they are errors
  std::vector<std::string> known_blocks = {};  // what take_block takes, for messages

  const Rule* find(std::string_view name, bool as_block) const;
  const Ignored* find_ignored(std::string_view name) const;
};

void read_block(Context& context, const sdl::Block& block, const Schema& schema);

// "number 5", "'box' block": for "... found instead".
std::string describe(const sdl::Item& item);

// "'name'; did you mean 'x'?" or the list of what is known.
std::string unknown(const std::string& what, const std::string& name, const std::string& place,
                    const std::vector<std::string>& known);

}  // namespace nicol
