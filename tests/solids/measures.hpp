// What the tests build and measure: scenes of a few objects, volumes, areas, messages.
#pragma once
#include <string>
#include <vector>

#include "host/solids/solids.hpp"

namespace nicol::test {

constexpr double pi = 3.14159265358979323846;

Vec3 operator+(const Vec3& a, const Vec3& b);
Vec3 operator-(const Vec3& a, const Vec3& b);
Vec3 operator*(double s, const Vec3& a);
double dot(const Vec3& a, const Vec3& b);
Vec3 cross(const Vec3& a, const Vec3& b);

// ---- objects; `line` is where they stand in the text ----
Object solid(Shape shape, std::uint32_t line);
Object light(Shape shape, std::uint32_t line);       // shines with emission 0
Object polarizer(Shape shape, std::uint32_t line);   // polarizer 0
ConvexShape box(const Vec3& low, const Vec3& high);  // faces -x +x -y +y -z +z
PolygonShape polygon(std::vector<Vec3> points);
PolygonShape floor_square(double low, double high, double y);  // seen counter-clockwise from +y

Affine translate(double x, double y, double z);
Affine rotate_y(double angle_deg);
Affine rotate_x(double angle_deg);
Affine scale(double x, double y, double z);
Affine left_to_right();  // z negated, 10 mm to the unit

// ---- building ----
struct Built {
  Geometry geometry;
  std::vector<sdl::Diagnostic> messages;
  bool failed = false;
  bool says(const std::string& words) const;  // in one message
  std::string first() const;                  // the first message, or ""
};
Scene scene_of(std::vector<Object> objects);
Built build(const Scene& scene);
Built build(std::vector<Object> objects);

// ---- measures ----
Vec3 area_vector(const std::vector<Vec3>& corners);
double area(const std::vector<Vec3>& corners);
double volume(const Geometry& geometry, const Cell& cell);
std::vector<const Patch*> patches_of(const Geometry& geometry, int cell);
// The area of a patch: its face cut by its edges (discs do not count).
double patch_area(const Geometry& geometry, int cell, const Patch& patch);

// Corners, edges and faces, corners told apart by their coordinates.
struct Counts {
  int corners = 0, edges = 0, faces = 0;
  bool closed = false;  // every edge runs once each way
};
Counts counts(const Geometry& geometry, const Cell& cell);

}  // namespace nicol::test
