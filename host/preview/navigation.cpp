// Camera and polarizers turned by hand: see navigation.hpp. Test: tests/preview/navigation_test.cpp.
// Turns follow Rodrigues' formula, right-handed about the unit vector k: v' = v cos t + (k x v) sin t + k (k.v) (1 - cos t).
#include "host/preview/navigation.hpp"

#include <algorithm>
#include <cmath>

#include "host/vec.hpp"

namespace nicol::preview {
namespace {

Vec3 turned_about(Vec3 v, Vec3 axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

// +1 where right x up points to the eye, -1 for a mirrored camera.
double handedness(const Camera& camera) {
  return dot(cross(camera.right, camera.up), camera.direction) <= 0 ? 1 : -1;
}

// The turn of the camera: pitch about its right first, then yaw about the up that it had.
struct Turn {
  Vec3 up, right;
  double yaw_rad, pitch_rad;

  Turn(const Camera& base, const Navigation& navigation)
      : up(normalize(base.up)), right(normalize(base.right)), yaw_rad(-handedness(base) * navigation.yaw_rad),
        pitch_rad(handedness(base) * navigation.pitch_rad) {}

  Vec3 operator()(Vec3 v) const { return turned_about(turned_about(v, right, pitch_rad), up, yaw_rad); }
};

struct Box {
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};

  void include(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool empty() const { return !(low.x <= high.x); }
  Vec3 middle() const { return (low + high) * 0.5; }
};

Box box_of(const Geometry& geometry) {
  Box box;
  for (const Face& face : geometry.faces)
    for (const Vec3& corner : face.corners) box.include(corner);
  if (!box.empty()) return box;
  for (const Sheet& sheet : geometry.sheets) {
    for (const Vec3& corner : sheet.corners) box.include(corner);
    if (sheet.has_disc) box.include(sheet.centre_mm + sheet.disc.centre_mm);
  }
  return box;
}

// A seam has no outside: the point on it is inside of the part that it bounds.
bool is_inside(const Geometry& geometry, const Cell& cell, Vec3 point_mm) {
  const Vec3 p = point_mm - cell.centre_mm;
  for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
    const Face& face = geometry.faces[static_cast<std::size_t>(f)];
    const double depth_mm = face.plane.offset_mm - dot(face.plane.normal, p);
    if (face.shape_face < 0 ? depth_mm < 0 : !(depth_mm > 0)) return false;
  }
  return true;
}

void turn_axis(Polarizer& polarizer, double angle_rad) {
  polarizer.transmission_axis = turned_about(polarizer.transmission_axis, polarizer.normal, angle_rad);
}

bool belongs_to_light_or_sheet(const Scene& scene, int polarizer) {
  return std::any_of(scene.emissions.begin(), scene.emissions.end(),
                     [=](const Emission& e) { return e.polarizer == polarizer; }) ||
         std::any_of(scene.objects.begin(), scene.objects.end(),
                     [=](const Object& o) { return o.polarizer == polarizer; });
}

// Ideal, passes what is horizontal in the picture; its plane is that of every camera's polarizer (host/bind/camera.cpp).
Polarizer horizontal_analyzer(const Camera& camera) {
  const Vec3 y = normalize(camera.up), x = normalize(project(camera.right, y));
  Polarizer polarizer;
  polarizer.transmission_axis = x;
  polarizer.normal = normalize(cross(x, y));
  polarizer.where = camera.where;
  return polarizer;
}

// Turns with the camera, then in its plane. If a light has it too, the camera gets one of its own.
void turn_analyzer(Scene& scene, const Turn& turn, double analyzer_rad) {
  int index = *scene.camera.polarizer;
  if (belongs_to_light_or_sheet(scene, index)) {
    scene.polarizers.push_back(scene.polarizers[static_cast<std::size_t>(index)]);
    scene.camera.polarizer = index = static_cast<int>(scene.polarizers.size()) - 1;
  }
  Polarizer& analyzer = scene.polarizers[static_cast<std::size_t>(index)];
  analyzer.transmission_axis = turn(analyzer.transmission_axis);
  analyzer.normal = turn(analyzer.normal);
  const bool towards_up = dot(cross(scene.camera.right, scene.camera.up), analyzer.normal) >= 0;
  turn_axis(analyzer, towards_up ? analyzer_rad : -analyzer_rad);
}

}  // namespace

bool Navigation::operator==(const Navigation& o) const {
  return yaw_rad == o.yaw_rad && pitch_rad == o.pitch_rad && pan_right == o.pan_right && pan_up == o.pan_up &&
         zoom == o.zoom;
}

Vec3 pivot_of(const Scene& scene, const Geometry& geometry) {
  const Camera& camera = scene.camera;
  const Vec3 ahead = normalize(camera.direction);
  const Box box = box_of(geometry);
  if (box.empty()) return camera.location + camera.direction;
  const double depth_mm = dot(box.middle() - camera.location, ahead);
  // Beside or behind the camera, which may stand in the middle itself.
  const double size_mm = length(box.high - box.low);
  if (depth_mm > 1e-9 * size_mm) return camera.location + ahead * depth_mm;
  const double distance_mm = length(box.middle() - camera.location);
  const double ahead_mm = distance_mm > 1e-9 * size_mm ? distance_mm : size_mm / 2;
  return camera.location + (ahead_mm > 0 ? ahead * ahead_mm : camera.direction);
}

Camera moved(const Camera& base, const Navigation& navigation, const Vec3& pivot_mm) {
  if (navigation == Navigation{}) return base;
  const Turn turn(base, navigation);
  const double shrink = std::exp2(-navigation.zoom);
  Camera camera = base;
  camera.direction = turn(base.direction);
  camera.right = turn(base.right);
  camera.up = turn(base.up);
  Vec3 from_pivot = turn(base.location - pivot_mm);
  double at_pivot = 1;  // size of the picture there, in sizes of right and up
  if (base.orthographic) {
    camera.right = camera.right * shrink;
    camera.up = camera.up * shrink;
  } else {
    from_pivot = from_pivot * shrink;
    at_pivot = -dot(from_pivot, camera.direction) / dot(camera.direction, camera.direction);
  }
  const Vec3 pan = camera.right * navigation.pan_right + camera.up * navigation.pan_up;
  camera.location = pivot_mm + from_pivot - pan * at_pivot;
  return camera;
}

Scene navigate(const Scene& scene, Geometry& geometry, const Navigation& navigation, Analyzer analyzer,
               double analyzer_rad, double polarizer_rad) {
  Scene seen = scene;
  const Turn turn(scene.camera, navigation);
  seen.camera = moved(scene.camera, navigation, pivot_of(scene, geometry));

  // The analyzer.
  const int count = static_cast<int>(scene.polarizers.size());
  if (analyzer == Analyzer::none) seen.camera.polarizer.reset();
  if (analyzer == Analyzer::added && !scene.camera.polarizer) {
    seen.polarizers.push_back(horizontal_analyzer(scene.camera));
    seen.camera.polarizer = count;
  }
  if (seen.camera.polarizer) turn_analyzer(seen, turn, analyzer_rad);
  // Those of lights and sheets.
  for (int i = 0; i < count; ++i)
    if (i != seen.camera.polarizer && polarizer_rad != 0)
      turn_axis(seen.polarizers[static_cast<std::size_t>(i)], polarizer_rad);

  geometry.camera_cell = seen.camera.orthographic ? 0 : cell_around(geometry, seen.camera.location);
  return seen;
}

int cell_around(const Geometry& geometry, const Vec3& point_mm) {
  if (geometry.cells.empty()) return 0;
  int cell = 0;
  while (true) {
    const auto& children = geometry.cells[static_cast<std::size_t>(cell)].children;
    const auto inner = std::find_if(children.begin(), children.end(), [&](int child) {
      return is_inside(geometry, geometry.cells[static_cast<std::size_t>(child)], point_mm);
    });
    if (inner == children.end()) return cell;
    cell = *inner;
  }
}

}  // namespace nicol::preview
