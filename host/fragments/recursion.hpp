// Functions of a fragment that call themselves. OpenCL C has no recursion (6.9 i of its specification, version 1.2), but compilers
// that inline every function do not end over it instead of saying so.
#pragma once
#include <optional>
#include <string>

namespace nicol {

struct Recursion {
  std::string function;
  int line = 0;   // where it is defined
};

// The first function that calls itself, by itself or through others. Comments and texts in quotes do not count; macros are not expanded.
std::optional<Recursion> find_recursion(const std::string& text);

}  // namespace nicol
