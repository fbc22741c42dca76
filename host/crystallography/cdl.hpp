// The Crystal Description Language of gemmology, version 1 (CDL specification of the Gemmology Project,
// 2026): system[point group]:{form}@distance + {form}@distance | twin(law). Distances are those
// of the faces from the centre, relative to each other. What changes the angles between faces
// (elongate, taper) and version 2's aggregates and features are no crystal shapes and are refused.
// Test: tests/crystallography/cdl_test.cpp.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/crystallography/twin.hpp"

namespace nicol::crystallography {

struct CdlForm {
  Miller face;
  double distance = 1;
};

struct Cdl {
  System system{};
  std::string point_group;
  std::vector<CdlForm> forms;
  std::optional<TwinLaw> twin;
};

struct CdlError {
  std::size_t at = 0;  // characters before the fault
  std::string message;
};

std::variant<Cdl, CdlError> parse_cdl(std::string_view text);

}  // namespace nicol::crystallography
