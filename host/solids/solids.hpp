// Exact solids and contacts: what the tracer gets of every shape, in double. Everything before is
// exact (exact.hpp); numbers are rounded once, here. Normals and offsets of opposite planes are
// exactly opposite.
#pragma once
#include <vector>

#include "host/scene.hpp"
#include "sdl/diagnostics.hpp"

namespace nicol {

// normal . p <= offset_mm, p relative to the centre of the part; unit normal.
struct Plane {
  Vec3 normal;
  double offset_mm = 0;
};

// Where a face of a cell, or part of it, touches something else. The part is convex: the face
// inside all `edges` (planes across it; none: the whole face) and, with has_disc, inside that ring.
// Edges and ring are relative to the cell's centre. Patches of a cell come in the order of its
// faces; where two patches of one face cover the same place (a sheet between two solids) the first
// counts. A face that shines has none.
struct Ring {
  Vec3 centre_mm;
  double radius_mm = 0, hole_radius_mm = 0;
};
struct Patch {
  enum class Behind {
    seam,          // another part of the same solid: no interface at all
    cell_gap,      // another solid, across a vanishing gap of the medium around
    cell_contact,  // another solid in optical contact: one interface
    light,         // an emission shines (or absorbs) here, behind a vanishing gap
    polarizer      // a polarizing sheet lies here, and ambient behind it
  };
  Behind behind = Behind::light;
  int face = 0;         // index into Geometry::faces of the face it lies on
  int other_face = -1;  // seam, cell_*: the face of the other cell
  int other_cell = -1;
  int sheet = -1;       // polarizer, or light of a sheet: index into Geometry::sheets
  int emission = -1;    // light: index into Scene::emissions (one-sided: the sheet's normal tells)
  std::vector<Plane> edges;
  bool has_disc = false;
  Ring disc;
};

// A convex region of one medium. Cell 0 is the surroundings: no faces, everything outermost is its
// child.
struct Cell {
  int object = -1;  // index into Scene::objects
  int medium = 0;
  int parent = 0;  // the cell around it
  Vec3 centre_mm;  // local origin, world mm; parts of one solid share it
  int first_face = 0, face_count = 0;
  int first_patch = 0, patch_count = 0;
  std::vector<int> children;  // cells directly inside
  std::vector<int> sheets;    // sheets directly inside
};

struct Face {
  Plane plane;  // outward
  // Index of the half-space of the shape, -1 for a seam. Prisms: 0 at y_min, 1 at y_max, 2 + k on
  // edge k of the contours, counted through all of them (edge k runs from point k to the next).
  int shape_face = -1;
  int emission = -1;  // the whole face shines inwards and outwards as an opaque light, or -1
  std::vector<Vec3> corners;  // world mm, counter-clockwise seen from outside
};

// A flat surface in a cell that shines or polarizes: one convex piece of a polygon, or a disc. The
// normal of a polygon points to where its first contour is seen to run counter-clockwise. A sheet
// that lies on a solid stays here, in the cell around that solid: its other side and what overhangs
// are still seen from there.
struct Sheet {
  int object = -1;
  int cell = 0;  // the cell it lies in
  int emission = -1, polarizer = -1;
  Vec3 centre_mm;  // local origin, world mm; pieces of one polygon share it
  Plane plane;     // relative to centre_mm, as are edges and disc
  std::vector<Plane> edges;
  bool has_disc = false;
  Ring disc;
  std::vector<Vec3> corners;  // world mm (for a disc: none)
};

struct Geometry {
  std::vector<Cell> cells;
  std::vector<Face> faces;
  std::vector<Patch> patches;
  std::vector<Sheet> sheets;
  int camera_cell = 0;  // the cell that the camera stands in
};

// Builds every solid exactly, finds contacts and nesting. Overlapping, empty, unbounded or
// degenerate solids, and faces that nearly coincide without touching, are told in `diagnostics`
// with their places.
Geometry build_geometry(const Scene& scene, sdl::Diagnostics& diagnostics);

}  // namespace nicol
