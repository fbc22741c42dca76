// The 32 crystallographic point groups as integer matrices on the axes of the crystal, and the forms
// (all faces that symmetry makes of one) that follow.
//
// Settings as in the International Tables for Crystallography A (2016): monoclinic unique axis b,
// trigonal and hexagonal on hexagonal axes (or, trigonal, on rhombohedral ones, obverse); 32, 3m, -3m
// without a third symbol are 321, 3m1, -3m1. Test: orders and multiplicities of all 32,
// tests/crystallography/point_group_test.cpp.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/crystallography/miller.hpp"

namespace nicol::crystallography {

enum class System {
  triclinic,
  monoclinic,
  orthorhombic,
  tetragonal,
  trigonal,
  hexagonal,
  cubic
};

// Rows; acts on columns of coordinates along a, b, c: u' = R u.
using Operation = std::array<std::array<int, 3>, 3>;

struct PointGroup {
  std::string symbol;  // short Hermann-Mauguin symbol, or the one of the setting
  System system{};
  std::vector<Operation> operations;  // the identity first
  bool has_hands() const;             // no operation mirrors: left and right crystals differ
};

// Short, full or old (m3m) symbols and settings (312, 31m, -4m2, -62m, 2mm, 112...). `rhombohedral`:
// trigonal groups on rhombohedral axes. Nothing if there is no such group (on such axes).
std::optional<PointGroup> find_point_group(std::string_view symbol, bool rhombohedral = false);

// Every symbol that find_point_group knows, the 32 short ones first.
std::vector<std::string> point_group_symbols();

// The group of highest symmetry of a system.
const char* holohedry(System system);

const char* name(System system);
std::optional<System> find_system(std::string_view name);
std::vector<std::string> system_names();

// All faces that the group makes of one, each once: (h k l) R for every R.
std::vector<Miller> form(const PointGroup& group, Miller face);

}  // namespace nicol::crystallography
