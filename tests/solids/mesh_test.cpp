// Closed meshes: convex ones are their half-spaces, others come apart exactly; what is not closed is told.
#include <doctest/doctest.h>

#include <algorithm>

#include "csg_shapes.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

// Faces -x +x -y +y -z +z, as a box has them.
MeshShape cube_mesh(const Vec3& a, const Vec3& b) {
  MeshShape mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  mesh.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return mesh;
}

// An outline (x, z), counter-clockwise with z up, swept along y; sides after foot and top, as a prism has them.
MeshShape swept(const std::vector<std::array<double, 2>>& outline, double y_min, double y_max) {
  MeshShape mesh;
  const int n = static_cast<int>(outline.size());
  for (double y : {y_min, y_max})
    for (const auto& p : outline) mesh.points.push_back({p[0], y, p[1]});
  std::vector<int> foot, top;
  for (int i = 0; i < n; ++i) foot.push_back(i), top.push_back(2 * n - 1 - i);
  mesh.faces = {foot, top};
  for (int i = 0; i < n; ++i) mesh.faces.push_back({(i + 1) % n, i, n + i, n + (i + 1) % n});
  return mesh;
}

const std::vector<std::array<double, 2>> l_outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};

// Corners cut off by fans: the same solid as triangles.
MeshShape in_triangles(const MeshShape& mesh) {
  MeshShape out;
  out.points = mesh.points;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i) out.faces.push_back({face[0], face[i], face[i + 1]});
  return out;
}

Built built_mesh(const MeshShape& mesh, std::vector<Affine> moves = {}) {
  Object object = solid(mesh, 7);
  object.kind = "solid";
  object.transforms = std::move(moves);
  return build({object});
}

void same_to_the_bit(const Geometry& a, const Geometry& b) {
  REQUIRE(a.cells.size() == b.cells.size());
  REQUIRE(a.faces.size() == b.faces.size());
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    REQUIRE(a.faces[f].corners.size() == b.faces[f].corners.size());
    for (std::size_t i = 0; i < a.faces[f].corners.size(); ++i) {
      const Vec3 p = a.faces[f].corners[i], q = b.faces[f].corners[i];
      CHECK((p.x == q.x && p.y == q.y && p.z == q.z));
    }
    CHECK(a.faces[f].plane.normal.x == b.faces[f].plane.normal.x);
    CHECK(a.faces[f].plane.offset_mm == b.faces[f].plane.offset_mm);
  }
}

}  // namespace

TEST_CASE("a cube of points and faces is the box, to the bit") {
  Affine turn;
  turn.m = {{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}, {0.1, 0.2, 0.3}}};
  Object object = solid(box({-1, 0, 0.1}, {2, 3, 0.7}), 7);
  object.transforms = {turn};
  same_to_the_bit(built_mesh(cube_mesh({-1, 0, 0.1}, {2, 3, 0.7}), {turn}).geometry, build({object}).geometry);
}

TEST_CASE("an L of points and faces encloses what the prism encloses") {
  const PrismShape prism{{l_outline}, -1, 1.5};
  const Built expected = build({solid(prism, 7)});
  for (const MeshShape& mesh : {swept(l_outline, -1, 1.5), in_triangles(swept(l_outline, -1, 1.5))}) {
    const Built found = built_mesh(mesh);
    REQUIRE_MESSAGE(found.geometry.cells.size() > 1, found.first());
    CHECK(found.geometry.cells.size() == expected.geometry.cells.size());
    CHECK(total_volume(found.geometry) == doctest::Approx(10).epsilon(1e-14));
    CHECK(outer_area(found.geometry) == doctest::Approx(outer_area(expected.geometry)).epsilon(1e-14));
    CHECK(fault_in_seams(found.geometry) == "");
  }
}

TEST_CASE("a frame, a hollow cube and two cubes in one mesh") {
  MeshShape hollow = cube_mesh({0, 0, 0}, {4, 4, 4});
  MeshShape inner = cube_mesh({1, 1, 1}, {2, 2, 2});
  MeshShape apart = cube_mesh({6, 1, 1}, {7, 2, 2});
  MeshShape two = hollow;
  for (auto& face : inner.faces) {
    std::reverse(face.begin(), face.end());
    for (int& corner : face) corner += 8;
  }
  for (auto& face : apart.faces)
    for (int& corner : face) corner += 8;
  hollow.points.insert(hollow.points.end(), inner.points.begin(), inner.points.end());
  hollow.faces.insert(hollow.faces.end(), inner.faces.begin(), inner.faces.end());
  two.points.insert(two.points.end(), apart.points.begin(), apart.points.end());
  two.faces.insert(two.faces.end(), apart.faces.begin(), apart.faces.end());
  const Built cavity = built_mesh(hollow), pair = built_mesh(two);
  CHECK(total_volume(cavity.geometry) == doctest::Approx(63).epsilon(1e-14));
  CHECK(outer_area(cavity.geometry) == doctest::Approx(102).epsilon(1e-14));
  CHECK(fault_in_seams(cavity.geometry) == "");
  CHECK(total_volume(pair.geometry) == doctest::Approx(65).epsilon(1e-14));
  CHECK(outer_area(pair.geometry) == doctest::Approx(102).epsilon(1e-14));
}

TEST_CASE("a mesh cuts and is cut") {
  const CsgNode l = csg_leaf(swept(l_outline, 0, 2)), prism = csg_leaf(PrismShape{{l_outline}, 0, 2});
  const CsgNode hole = csg_box({0.5, 0.5, 0.25}, {2.5, 1.5, 0.75});
  CHECK(volume_of(differing({l, hole})) == volume_of(differing({prism, hole})));
  CHECK(volume_of(merged({l, hole})) == volume_of(merged({prism, hole})));
  CHECK(volume_of(intersected({hole, l})) == volume_of(intersected({hole, prism})));
  CHECK(volume_of(differing({hole, l})) == volume_of(differing({hole, prism})));
}

TEST_CASE("what is wrong with a mesh names its face or edge") {
  const MeshShape good = cube_mesh({0, 0, 0}, {1, 1, 1});
  const auto told = [](const MeshShape& mesh) { return built_mesh(mesh).first(); };
  const auto says = [](const std::string& text, const std::string& part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, text);
  };
  MeshShape open = good;
  open.faces.pop_back();
  says(told(open), "is open: the edge from <0, 0, 1> to <0, 1, 1> of face 0 has no other face");
  MeshShape turned = good;
  std::reverse(turned.faces[3].begin(), turned.faces[3].end());
  says(told(turned), "face turned inside out");
  says(told(turned), "face 3");
  MeshShape all_turned = good;
  for (auto& face : all_turned.faces) std::reverse(face.begin(), face.end());
  says(told(all_turned), "is turned inside out: the points of its faces run clockwise");
  MeshShape bent = good;
  bent.points[7].x += 0.01;
  says(told(bent), "that is not flat");
  MeshShape fin = good;
  fin.points.push_back({0.5, 0.5, 5});
  fin.faces.push_back({4, 5, 8});
  says(told(fin), "is not a surface: 3 faces share the edge");
  MeshShape missing = good;
  missing.faces[0][1] = 12;
  says(told(missing), "face 0 with a point 12 that is not there");
  MeshShape crossed = cube_mesh({0, 0, 0}, {2, 2, 2});
  MeshShape through = cube_mesh({1, 1, 1}, {3, 3, 3});
  for (auto& face : through.faces)
    for (int& corner : face) corner += 8;
  crossed.points.insert(crossed.points.end(), through.points.begin(), through.points.end());
  crossed.faces.insert(crossed.faces.end(), through.faces.begin(), through.faces.end());
  says(told(crossed), "intersects itself");
}
