// Twin laws: see twin.hpp. Indices are those of the axial ratios in Dana's System: calcite
// c/a = 0.854, others as listed.
#include "host/crystallography/twin.hpp"

#include "host/crystallography/degrees.hpp"
#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

using Op = TwinLaw::Operation;

TwinLaw edge(Miller uvw, Miller contact, double angle_deg = 180) {
  return {Op::rotation_about_edge, uvw, angle_deg, contact, false};
}
TwinLaw plane(Miller hkl) { return {Op::reflection, hkl, 180, hkl, false}; }
TwinLaw through(Op op, Miller element, double angle_deg = 180) {
  return {op, element, angle_deg, std::nullopt, true};
}

}  // namespace

const std::vector<NamedTwinLaw>& twin_laws() {
  static const std::vector<NamedTwinLaw> laws = {
      {"dauphine", System::trigonal, edge({0, 0, 1}, {1, 0, 0}),
       "quartz: 180 degrees about c, same hand"},
      {"brazil", System::trigonal, plane({1, 1, 0}),
       "quartz: mirrored in (11-20), a right and a left individual"},
      {"japan", System::trigonal,
       {Op::rotation_about_normal, {1, 1, 2}, 180, Miller{1, 1, 2}, false},
       "quartz: 180 degrees about the normal of (11-22), axes at 84.55 degrees, same hand"},
      {"calcite_c", System::trigonal, plane({0, 0, 1}), "calcite: mirrored in (0001)"},
      {"calcite_e", System::trigonal, plane({0, 1, 2}), "calcite: mirrored in (01-12), c/a 0.854"},
      {"spinel", System::cubic, plane({1, 1, 1}), "spinel, diamond: mirrored in (111)"},
      {"fluorite", System::cubic, through(Op::rotation_about_edge, {1, 1, 1}),
       "fluorite: 180 degrees about [111], through each other"},
      {"iron_cross", System::cubic, through(Op::rotation_about_edge, {0, 0, 1}, 90),
       "pyrite: 90 degrees about [001], through each other"},
      {"rutile", System::tetragonal, plane({1, 0, 1}), "rutile, cassiterite: mirrored in (101)"},
      {"aragonite", System::orthorhombic, plane({1, 1, 0}), "aragonite: mirrored in (110)"},
      {"chrysoberyl", System::orthorhombic, plane({0, 3, 1}), "chrysoberyl: mirrored in (031)"},
      {"staurolite_90", System::monoclinic, through(Op::reflection, {0, 3, 1}),
       "staurolite: mirrored in (031), through each other"},
      {"staurolite_60", System::monoclinic, through(Op::reflection, {2, 3, 1}),
       "staurolite: mirrored in (231), through each other"},
      {"gypsum_swallow", System::monoclinic, plane({1, 0, 0}), "gypsum: mirrored in (100)"},
      {"carlsbad", System::monoclinic, edge({0, 0, 1}, {0, 1, 0}),
       "feldspar: 180 degrees about c, in contact on (010)"},
      {"manebach", System::monoclinic, plane({0, 0, 1}), "feldspar: mirrored in (001)"},
      {"baveno", System::monoclinic, plane({0, 2, 1}), "feldspar: mirrored in (021)"},
      {"albite", System::triclinic, plane({0, 1, 0}), "plagioclase: mirrored in (010)"},
      {"pericline", System::triclinic, edge({0, 1, 0}, {0, 0, 1}),
       "plagioclase: 180 degrees about b; contact drawn on (001) for the rhombic section"}};
  return laws;
}

TwinOperation twin_operation(const Lattice& lattice, const TwinLaw& law) {
  const Miller e = law.element;
  const bool edge_law = law.operation == Op::rotation_about_edge;
  const Vec3 axis = normalize(edge_law ? lattice.direction({1.0 * e.h, 1.0 * e.k, 1.0 * e.l})
                                       : lattice.normal(e));
  const bool mirrors = law.operation == Op::reflection;
  const double angle_deg = mirrors ? 180 : law.angle_deg;
  // Rodrigues: v cos + (axis x v) sin + axis (axis . v) (1 - cos).
  const double c = cos_deg(angle_deg), s = sin_deg(angle_deg);
  TwinOperation operation;
  operation.mirrors = mirrors;
  const Vec3 units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i)
    operation.rotation[i] =
        units[i] * c + cross(axis, units[i]) * s + axis * (dot(axis, units[i]) * (1 - c));
  return operation;
}

}  // namespace nicol::crystallography
