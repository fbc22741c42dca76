// Twins: two individuals of one crystal, the second turned about a twin axis or mirrored in a twin
// plane, on a common composition (contact) plane. The laws and their planes: C. Palache, H. Berman,
// C. Frondel, Dana's System of Mineralogy, 7th ed. (1944-1962); W. A. Deer, R. A. Howie, J. Zussman,
// Rock-Forming Minerals (feldspars). Tests: tests/crystallography/twin_test.cpp (angles between the
// individuals), tests/bind/crystal_test.cpp (common planes).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/crystallography/lattice.hpp"

namespace nicol::crystallography {

struct TwinLaw {
  enum class Operation {
    rotation_about_edge,    // about [uvw]
    rotation_about_normal,  // about the normal of (hkl)
    reflection              // in (hkl): a mirrored crystal, of the other hand if it has one
  };
  Operation operation = Operation::reflection;
  Miller element;  // uvw or hkl
  double angle_deg = 180;
  std::optional<Miller> contact;
  bool penetration = false;  // individuals grow through each other
};

struct NamedTwinLaw {
  const char* name;
  System system;  // the lowest that it belongs to
  TwinLaw law;
  const char* help;
};

const std::vector<NamedTwinLaw>& twin_laws();

// The operation in Cartesian axes: its proper part, and whether a reflection (an inversion times that
// rotation) belongs to it.
struct TwinOperation {
  std::array<Vec3, 3> rotation;  // columns: images of X, Y, Z
  bool mirrors = false;
};
TwinOperation twin_operation(const Lattice& lattice, const TwinLaw& law);

}  // namespace nicol::crystallography
