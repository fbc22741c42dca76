// The parameters that a plugin takes: numbers with units, and texts (names of files).
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace nicol::plugins {

struct Parameter {
  enum class Kind { number, text };
  Kind kind = Kind::number;
  std::string name, unit, meaning;         // unit "": dimensionless; "K", "nm", "deg", ...
  std::optional<double> number;            // what holds where a scene does not say; none: it must say
  std::optional<std::string> text;         // likewise of kind text
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

// Numbers in the order of the parameters of kind number, texts in the order of those of kind text.
struct Values {
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

}  // namespace nicol::plugins
