// The lattice: cell edges and angles to Cartesian axes.
//
// One setting for all systems: Z along c, Y along b* (the normal of (010)), X = Y x Z, right-handed. So
// a lies in the plane XZ, towards +X, and
//   a = a (sin beta, 0, cos beta)
//   b = b ((cos gamma - cos alpha cos beta) / sin beta, v / sin beta, cos alpha)
//   c = c (0, 0, 1)
//   v^2 = 1 - cos^2 alpha - cos^2 beta - cos^2 gamma + 2 cos alpha cos beta cos gamma
// That is X along a in the cubic, tetragonal, orthorhombic, trigonal and hexagonal systems, Y along b in
// the monoclinic one: the setting of IEEE Std 176-1987, 3.2 (which takes X for the binary axis of 32
// as well). Only ratios of the edges matter. On rhombohedral axes (a = b = c, alpha = beta = gamma)
// Z is the threefold axis a + b + c, X runs along a - b (obverse setting).
// Test: published interfacial angles, tests/crystallography/lattice_test.cpp.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "host/crystallography/point_group.hpp"
#include "host/scene.hpp"

namespace nicol::crystallography {

struct Cell {
  double a = 1, b = 1, c = 1;
  double alpha_deg = 90, beta_deg = 90, gamma_deg = 90;
};

struct Lattice {
  std::array<Vec3, 3> axes;        // a, b, c, Cartesian
  std::array<Vec3, 3> reciprocal;  // a*, b*, c*: axes[i] . reciprocal[j] = (i == j)

  // Outward along the normal of (hkl); its length is 1 / spacing.
  Vec3 normal(Miller face) const;
  Vec3 direction(Vec3 uvw) const;  // u a + v b + w c
};

// Nothing if no such cell exists; `why` says so.
std::optional<Lattice> make_lattice(const Cell& cell, bool rhombohedral, std::string& why);

// Whether the group leaves the lattice as it is (to 1e-6 of its lengths).
bool fits(const Lattice& lattice, const PointGroup& group);

// What the cells of a system have in common, as "a = b, gamma = 120".
const char* cell_rule(System system, bool rhombohedral);

}  // namespace nicol::crystallography
