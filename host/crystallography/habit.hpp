// The habit: which faces at which distances from the centre bound the crystal, and how twinned
// individuals share it. Half-spaces are in lattice coordinates (u, v, w along a, b, c), where normals
// are whole numbers h, k, l: what meets by symmetry then meets exactly. The affine map basis()
// takes them to Cartesian axes.
//   h u + k v + l w <= size * distance * |h a* + k b* + l c*|
// Test: tests/crystallography/habit_test.cpp.
#pragma once
#include <vector>

#include "host/crystallography/twin.hpp"

namespace nicol::crystallography {

struct HabitFace {
  Miller face;
  double distance = 1;  // from the centre, in units of Habit::size
};

struct Composition {
  TwinLaw law;
  double offset = 0;     // of the contact plane from the centre, in units of size
  int individuals = 2;   // slabs between parallel contact planes
  double thickness = 0;  // of the inner slabs, in units of size
};

struct Habit {
  Lattice lattice;
  std::vector<HabitFace> faces;
  double size = 1;
  std::vector<HalfSpace> cuts;  // polished: Cartesian, through all individuals alike
  std::optional<Composition> twin;
};

// One individual: its half-spaces in the lattice coordinates of the first, the proper rotation of its
// Cartesian crystal axes (row vectors), and whether it is of the opposite hand. Individuals
// that touch share their contact plane to the last bit. In a penetration twin the second is what
// stands out of the first: its faces without the inside of `without`.
struct Individual {
  std::vector<HalfSpace> faces, without;
  Affine turn;
  bool opposite_hand = false;
};

Affine basis(const Lattice& lattice);

// Without the part of an individual that its contact planes cut away there may be nothing left; that
// is for the builder of solids to find.
std::vector<Individual> individuals(const Habit& habit);

}  // namespace nicol::crystallography
