// See measures.hpp.
#include "measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace nicol::test {

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Object solid(Shape shape, std::uint32_t line) {
  Object object;
  object.kind = "box";
  object.where.line = line;
  object.shape = std::move(shape);
  object.medium = 1;
  return object;
}
Object light(Shape shape, std::uint32_t line) {
  Object object = solid(std::move(shape), line);
  object.kind = "polygon";
  object.medium.reset();
  object.emission = 0;
  return object;
}
Object polarizer(Shape shape, std::uint32_t line) {
  Object object = light(std::move(shape), line);
  object.emission.reset();
  object.polarizer = 0;
  return object;
}

ConvexShape box(const Vec3& low, const Vec3& high) {
  return {{{{-1, 0, 0}, -low.x},
           {{1, 0, 0}, high.x},
           {{0, -1, 0}, -low.y},
           {{0, 1, 0}, high.y},
           {{0, 0, -1}, -low.z},
           {{0, 0, 1}, high.z}}};
}
PolygonShape polygon(std::vector<Vec3> points) { return {{std::move(points)}}; }
PolygonShape floor_square(double low, double high, double y) {
  return polygon({{low, y, low}, {low, y, high}, {high, y, high}, {high, y, low}});
}

Affine translate(double x, double y, double z) {
  Affine a;
  a.m[3] = {x, y, z};
  return a;
}
Affine rotate_y(double angle_deg) {
  const double c = std::cos(angle_deg * pi / 180), s = std::sin(angle_deg * pi / 180);
  Affine a;
  a.m[0] = {c, 0, -s};
  a.m[2] = {s, 0, c};
  return a;
}
Affine rotate_x(double angle_deg) {
  const double c = std::cos(angle_deg * pi / 180), s = std::sin(angle_deg * pi / 180);
  Affine a;
  a.m[1] = {0, c, s};
  a.m[2] = {0, -s, c};
  return a;
}
Affine scale(double x, double y, double z) {
  Affine a;
  a.m[0][0] = x;
  a.m[1][1] = y;
  a.m[2][2] = z;
  return a;
}
Affine left_to_right() { return scale(10, 10, -10); }

bool Built::says(const std::string& words) const {
  return std::any_of(messages.begin(), messages.end(),
                     [&](const auto& m) { return m.message.find(words) != std::string::npos; });
}
std::string Built::first() const { return messages.empty() ? "" : messages[0].message; }

Scene scene_of(std::vector<Object> objects) {
  Scene scene;
  scene.media.resize(2);
  scene.emissions.resize(3);
  scene.polarizers.resize(1);
  scene.camera.location = {0.123, 0.456, -1e6};
  scene.objects = std::move(objects);
  return scene;
}

Built build(const Scene& scene) {
  sdl::Sources sources;
  sdl::Diagnostics diagnostics(sources);
  Built out;
  out.geometry = build_geometry(scene, diagnostics);
  out.messages = diagnostics.all();
  out.failed = diagnostics.failed();
  return out;
}
Built build(std::vector<Object> objects) { return build(scene_of(std::move(objects))); }

Vec3 area_vector(const std::vector<Vec3>& p) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    sum = sum + 0.5 * cross(p[i] - p[0], p[i + 1] - p[0]);
  return sum;
}
double area(const std::vector<Vec3>& p) {
  const Vec3 v = area_vector(p);
  return std::sqrt(dot(v, v));
}

double volume(const Geometry& geometry, const Cell& cell) {
  double sum = 0;
  for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
    const Face& face = geometry.faces[f];
    sum += face.plane.offset_mm * area(face.corners) / 3;
  }
  return sum;
}

std::vector<const Patch*> patches_of(const Geometry& geometry, int cell) {
  std::vector<const Patch*> out;
  const Cell& c = geometry.cells[cell];
  for (int p = c.first_patch; p < c.first_patch + c.patch_count; ++p)
    out.push_back(&geometry.patches[p]);
  return out;
}

double patch_area(const Geometry& geometry, int cell, const Patch& patch) {
  std::vector<Vec3> p = geometry.faces[patch.face].corners;
  const Vec3 centre = geometry.cells[cell].centre_mm;
  for (const Plane& edge : patch.edges) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
      const double out_a = dot(edge.normal, a - centre) - edge.offset_mm;
      const double out_b = dot(edge.normal, b - centre) - edge.offset_mm;
      if (out_a <= 0) kept.push_back(a);
      if (out_a * out_b < 0) kept.push_back(a + (out_a / (out_a - out_b)) * (b - a));
    }
    p = std::move(kept);
  }
  return area(p);
}

Counts counts(const Geometry& geometry, const Cell& cell) {
  std::map<std::array<double, 3>, int> index;
  std::set<std::pair<int, int>> edges;
  Counts out;
  out.closed = true;
  for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
    std::vector<int> loop;
    for (const Vec3& p : geometry.faces[f].corners) {
      loop.push_back(index.insert({{p.x, p.y, p.z}, static_cast<int>(index.size())}).first->second);
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      out.closed &= edges.insert({loop[i], loop[(i + 1) % loop.size()]}).second;
    }
  }
  for (const auto& [a, b] : edges) out.closed &= edges.count({b, a}) == 1;
  out.corners = static_cast<int>(index.size());
  out.edges = static_cast<int>(edges.size()) / 2;
  out.faces = cell.face_count;
  return out;
}

}  // namespace nicol::test
