// See chord.hpp.
#include "host/app/chord.hpp"

#include <cmath>
#include <limits>

namespace nicol::app {
namespace {

Vec3 plus(const Vec3& a, double s, const Vec3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 unit(const Vec3& a) {
  const double s = 1 / std::sqrt(dot(a, a));
  return {s * a.x, s * a.y, s * a.z};
}

struct Ray {
  Vec3 from_mm, direction;
};

struct Span {
  double enter_mm = -std::numeric_limits<double>::infinity();
  double leave_mm = std::numeric_limits<double>::infinity();
  int enter_face = -1;
};

Ray camera_ray(const Camera& camera, const std::array<double, 2>& place) {
  const double across = place[0] - 0.5, upward = 0.5 - place[1];
  if (camera.orthographic)
    return {plus(plus(camera.location, across, camera.right), upward, camera.up),
            unit(camera.direction)};
  return {camera.location,
          unit(plus(plus(camera.direction, across, camera.right), upward, camera.up))};
}

// Clips the ray to the planes of a convex cell (Kay & Kajiya 1986, section 2.1); it misses the cell
// where enter_mm >= leave_mm.
Span clip(const Geometry& geometry, const Cell& cell, const Ray& ray) {
  Span span;
  const Vec3 from_mm = plus(ray.from_mm, -1, cell.centre_mm);
  for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
    const Plane& plane = geometry.faces[f].plane;
    const double along = dot(plane.normal, ray.direction);
    const double distance_mm = plane.offset_mm - dot(plane.normal, from_mm);
    if (along == 0) {
      if (distance_mm < 0) return {1, 0, -1};
      continue;
    }
    const double t_mm = distance_mm / along;
    if (along < 0 && t_mm > span.enter_mm) {
      span.enter_mm = t_mm;
      span.enter_face = f;
    }
    if (along > 0 && t_mm < span.leave_mm) span.leave_mm = t_mm;
  }
  return span;
}

// Snell's law as vectors (Born & Wolf 1999, section 1.5.1); nothing where it reflects totally.
std::optional<Vec3> refract(const Vec3& direction, const Vec3& outward, double n1_over_n2) {
  const double cos_i = -dot(direction, outward);
  const double cos2_t = 1 - n1_over_n2 * n1_over_n2 * (1 - cos_i * cos_i);
  if (cos2_t < 0) return std::nullopt;
  const Vec3 scaled{n1_over_n2 * direction.x, n1_over_n2 * direction.y, n1_over_n2 * direction.z};
  return plus(scaled, n1_over_n2 * cos_i - std::sqrt(cos2_t), outward);
}

}  // namespace

std::optional<Chord> first_chord(const Scene& scene, const Geometry& geometry,
                                 const std::array<double, 2>& place, std::size_t lambda) {
  const Ray ray = camera_ray(scene.camera, place);
  int first = -1;
  Span nearest;
  nearest.enter_mm = std::numeric_limits<double>::infinity();
  const Cell& around = geometry.cells[geometry.camera_cell];
  for (const int child : around.children) {
    const Span span = clip(geometry, geometry.cells[child], ray);
    if (span.enter_face < 0 || span.enter_mm >= span.leave_mm || span.enter_mm < 0) continue;
    if (span.enter_mm < nearest.enter_mm) {
      nearest = span;
      first = child;
    }
  }
  if (first < 0) return std::nullopt;
  const Cell& cell = geometry.cells[first];
  const double n1_over_n2 =
      scene.media[around.medium].n[0][lambda] / scene.media[cell.medium].n[0][lambda];
  const auto inside =
      refract(ray.direction, geometry.faces[nearest.enter_face].plane.normal, n1_over_n2);
  if (!inside) return std::nullopt;
  const Ray refracted{plus(ray.from_mm, nearest.enter_mm, ray.direction), *inside};
  return Chord{first, clip(geometry, cell, refracted).leave_mm};
}

}  // namespace nicol::app
