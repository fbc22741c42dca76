// Our clipping against CGAL's half-space intersection (the variant with constructions): the same
// number of faces and the same volume. CGAL's result has corners more than once where many planes
// meet, so those are not compared.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <CGAL/Convex_hull_3/dual/halfspace_intersection_with_constructions_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "../measures.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh by_cgal(const ConvexShape& shape) {
  std::vector<Kernel::Plane_3> planes;
  for (const HalfSpace& h : shape.faces)
    planes.emplace_back(h.normal.x, h.normal.y, h.normal.z, -h.offset);
  Mesh mesh;
  CGAL::halfspace_intersection_with_constructions_3(planes.begin(), planes.end(), mesh,
                                                    Kernel::Point_3(0, 0, 0));
  return mesh;
}

double mesh_volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto face : mesh.faces()) {
    std::vector<Vec3> loop;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
      const auto& p = mesh.point(v);
      loop.push_back({p.x(), p.y(), p.z()});
    }
    sum += dot(loop[0], area_vector(loop)) / 3;
  }
  return std::abs(sum);
}

void compare(const ConvexShape& shape) {
  const Built built = build({solid(shape, 1)});
  REQUIRE_MESSAGE(built.messages.empty(), built.first());
  const Mesh mesh = by_cgal(shape);
  CHECK(static_cast<int>(mesh.number_of_faces()) == built.geometry.cells[1].face_count);
  CHECK(mesh_volume(mesh) ==
        doctest::Approx(volume(built.geometry, built.geometry.cells[1])).epsilon(1e-12));
}

}  // namespace

TEST_CASE("octahedron and quartz-like crystal") {
  ConvexShape octahedron, quartz;
  for (int i = 0; i < 8; ++i) {
    octahedron.faces.push_back({{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}, 1});
  }
  compare(octahedron);
  for (int i = 0; i < 6; ++i) {
    const double x = std::cos(pi * i / 3), z = std::sin(pi * i / 3);
    quartz.faces.push_back({{x, 0, z}, 1});
    for (double up : {1.27, -1.27}) quartz.faces.push_back({{x, up, z}, 2.5 + 0.1 * (i % 2)});
  }
  compare(quartz);
}

TEST_CASE("random half-spaces, 10 to 256") {
  std::mt19937 random(1815);
  std::normal_distribution<double> normal;
  for (int count : {10, 30, 89, 256}) {
    ConvexShape shape = box({-3, -3, -3}, {3, 3, 3});
    for (int i = 0; i < count; ++i) {
      const Vec3 n{normal(random), normal(random), normal(random)};
      shape.faces.push_back({n, std::sqrt(dot(n, n)) * (1 + 0.1 * std::abs(normal(random)))});
    }
    compare(shape);
  }
}
