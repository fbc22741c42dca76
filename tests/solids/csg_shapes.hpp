// Trees of solids for the tests of CSG, and exact measures of what they give.
#pragma once
#include <gmpxx.h>

#include <vector>

#include "host/solids/csg.hpp"
#include "measures.hpp"

namespace nicol::test {

using CsgNode = CsgShape::Node;

CsgNode csg_leaf(decltype(CsgNode::leaf) shape, std::vector<Affine> moves = {});
CsgNode csg_box(const Vec3& low, const Vec3& high, std::vector<Affine> moves = {});
CsgNode octahedron(const Vec3& centre, double radius);
CsgNode half_space(const Vec3& normal, double offset);
CsgNode merged(std::vector<CsgNode> operands);
CsgNode intersected(std::vector<CsgNode> operands);
CsgNode differing(std::vector<CsgNode> operands);  // the first without the others
CsgNode inverse(CsgNode node);

std::vector<solids::Polyhedron> cells_of(const CsgNode& node, const std::vector<Affine>& moves = {});
mpq_class volume(const std::vector<solids::Polyhedron>& cells);
mpq_class volume_of(const CsgNode& node, const std::vector<Affine>& moves = {});  // 0: empty

// Builds the tree as the only solid of a scene.
Object csg_object(const CsgNode& node, std::uint32_t line, const std::vector<Affine>& moves = {});
Built built_csg(const CsgNode& node, const std::vector<Affine>& moves = {});
double total_volume(const Geometry& geometry, int object = 0);
// Faces without what seams cover of them.
double outer_area(const Geometry& geometry, int object = 0);
// The sum of outward area vectors of the surface; 0 for a closed one.
Vec3 outer_area_vector(const Geometry& geometry, int object = 0);
// What is wrong with the seams, or "": each must have one twin of the same area in the same place.
std::string fault_in_seams(const Geometry& geometry);

}  // namespace nicol::test
