// See csg_shapes.hpp.
#include "csg_shapes.hpp"

#include <cmath>

namespace nicol::test {

using solids::ExactPoint;
using solids::Polyhedron;
using Operation = CsgShape::Operation;

CsgNode csg_leaf(decltype(CsgNode::leaf) shape, std::vector<Affine> moves) {
  CsgNode node;
  node.kind = std::holds_alternative<ConvexShape>(shape) ? "box" : "prism";
  node.leaf = std::move(shape);
  node.transforms = std::move(moves);
  return node;
}
CsgNode csg_box(const Vec3& low, const Vec3& high, std::vector<Affine> moves) {
  return csg_leaf(box(low, high), std::move(moves));
}
CsgNode octahedron(const Vec3& c, double radius) {
  ConvexShape shape;
  for (int i = 0; i < 8; ++i) {
    const Vec3 n{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    shape.faces.push_back({n, dot(n, c) + radius});
  }
  return csg_leaf(shape);
}
CsgNode half_space(const Vec3& normal, double offset) {
  CsgNode node = csg_leaf(ConvexShape{{{normal, offset}}});
  node.kind = "plane";
  return node;
}

namespace {
CsgNode combined(Operation operation, const char* kind, std::vector<CsgNode> operands) {
  CsgNode node;
  node.operation = operation;
  node.kind = kind;
  node.operands = std::move(operands);
  return node;
}
}  // namespace

CsgNode merged(std::vector<CsgNode> operands) {
  return combined(Operation::merge, "merge", std::move(operands));
}
CsgNode intersected(std::vector<CsgNode> operands) {
  return combined(Operation::intersection, "intersection", std::move(operands));
}
CsgNode differing(std::vector<CsgNode> operands) {
  return combined(Operation::difference, "difference", std::move(operands));
}
CsgNode inverse(CsgNode node) {
  node.inverse = !node.inverse;
  return node;
}

std::vector<Polyhedron> cells_of(const CsgNode& node, const std::vector<Affine>& moves) {
  return solids::make_csg({node}, moves).cells;
}

// The sum of the tetrahedra from the origin over the triangles of all faces.
mpq_class volume(const std::vector<Polyhedron>& cells) {
  mpq_class sum = 0;
  for (const Polyhedron& cell : cells) {
    for (const Polyhedron::Face& face : cell.faces) {
      const ExactPoint& a = cell.corners[face.corners[0]];
      for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
        const ExactPoint &b = cell.corners[face.corners[i]], &c = cell.corners[face.corners[i + 1]];
        const auto n = solids::cross({b.v[0], b.v[1], b.v[2]}, {c.v[0], c.v[1], c.v[2]});
        mpq_class part(solids::dot({a.v[0], a.v[1], a.v[2]}, n),
                       mpz_class(6 * a.v[3] * b.v[3] * c.v[3]));
        part.canonicalize();
        sum += part;
      }
    }
  }
  return sum;
}
mpq_class volume_of(const CsgNode& node, const std::vector<Affine>& moves) {
  return volume(cells_of(node, moves));
}

Object csg_object(const CsgNode& node, std::uint32_t line, const std::vector<Affine>& moves) {
  Object object = solid(CsgShape{node}, line);
  object.kind = node.kind;
  object.transforms = moves;
  return object;
}
Built built_csg(const CsgNode& node, const std::vector<Affine>& moves) {
  return build({csg_object(node, 1, moves)});
}

double total_volume(const Geometry& geometry, int object) {
  double sum = 0;
  for (const Cell& cell : geometry.cells) {
    if (cell.object == object) sum += volume(geometry, cell);
  }
  return sum;
}

double outer_area(const Geometry& geometry, int object) {
  double sum = 0;
  for (int c = 1; c < static_cast<int>(geometry.cells.size()); ++c) {
    const Cell& cell = geometry.cells[c];
    if (cell.object != object) continue;
    for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f)
      sum += area(geometry.faces[f].corners);
    for (const Patch* patch : patches_of(geometry, c)) {
      if (patch->behind == Patch::Behind::seam) sum -= patch_area(geometry, c, *patch);
    }
  }
  return sum;
}

Vec3 outer_area_vector(const Geometry& geometry, int object) {
  Vec3 sum;
  for (int c = 1; c < static_cast<int>(geometry.cells.size()); ++c) {
    const Cell& cell = geometry.cells[c];
    if (cell.object != object) continue;
    for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
      double bare = area(geometry.faces[f].corners);
      for (const Patch* patch : patches_of(geometry, c)) {
        if (patch->face == f && patch->behind == Patch::Behind::seam)
          bare -= patch_area(geometry, c, *patch);
      }
      sum = sum + bare * geometry.faces[f].plane.normal;
    }
  }
  return sum;
}

std::string fault_in_seams(const Geometry& geometry) {
  for (int c = 1; c < static_cast<int>(geometry.cells.size()); ++c) {
    for (const Patch* patch : patches_of(geometry, c)) {
      if (patch->behind != Patch::Behind::seam) continue;
      const Cell& other = geometry.cells[patch->other_cell];
      if (other.object != geometry.cells[c].object) return "a seam between two solids";
      const Plane &own_plane = geometry.faces[patch->face].plane,
                  &other_plane = geometry.faces[patch->other_face].plane;
      const Vec3 sum = own_plane.normal + other_plane.normal;
      if (sum.x != 0 || sum.y != 0 || sum.z != 0) return "normals of a seam that are not opposite";
      if (own_plane.offset_mm != -other_plane.offset_mm) return "planes of a seam that differ";
      int twins = 0;
      for (const Patch* twin : patches_of(geometry, patch->other_cell)) {
        if (twin->other_cell != c || twin->face != patch->other_face) continue;
        ++twins;
        const double own = patch_area(geometry, c, *patch),
                     there = patch_area(geometry, patch->other_cell, *twin);
        if (!(own > 0) || std::abs(own - there) > 1e-12 * own) return "a seam and its twin differ";
      }
      if (twins != 1) return "a seam with " + std::to_string(twins) + " twins";
    }
  }
  return "";
}

}  // namespace nicol::test
