// A fragment's OpenCL C as far as it must be understood before a compiler gets it: what it defines, and which function calls which.
// Comments and texts in quotes do not count; macros are not expanded, and both sides of #if are read.
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

struct SourceToken {
  std::string_view text;   // a name or a mark
  int line = 0;
};

struct SourceFunction {
  int line = 0;                       // where it is defined
  std::set<std::string_view> calls;   // every name before parentheses
};

// Views into `text`, which must last.
struct SourceText {
  std::vector<SourceToken> tokens;       // those of preprocessor lines are left out
  std::vector<SourceToken> macros;       // defined and not undefined again
  std::vector<SourceToken> declared;     // types, constants and functions with bodies, outside of all functions
  std::map<std::string_view, SourceFunction> functions;   // with bodies
  std::set<std::string_view> words;      // every name that stands anywhere
  bool balanced = true;                  // braces close what they open; else `declared` and `functions` are guesses
};
SourceText scan_source(std::string_view text);

struct NamedLine {
  std::string name;
  int line = 0;
};

// The first function that calls itself, by itself or through others. OpenCL C has no recursion (6.9 i of its specification, version 1.2),
// but compilers that inline every function do not end over it instead of saying so.
std::optional<NamedLine> find_recursion(const SourceText& source);

// The first macro, type, constant or function that does not begin with `prefix`, in whatever case: in the kernel of a scene with two fragments
// it could meet the other's. Nothing where braces are not balanced: the compiler tells that.
std::optional<NamedLine> find_foreign_name(const SourceText& source, const std::string& prefix);

}  // namespace nicol
