// Convex polyhedra by clipping with exact planes. Corners where many planes meet come out once,
// because every comparison is exact; each corner is computed from three planes, so numbers do not
// grow.
#pragma once
#include <string>
#include <vector>

#include "exact.hpp"

namespace nicol::solids {

// A flat convex region: corners counter-clockwise seen from outside its plane; edges[i] is some
// plane through corners i and i + 1, across `plane`, with the region inside.
struct Polygon {
  ExactPlane plane;
  std::vector<ExactPoint> corners;
  std::vector<ExactPlane> edges;
};

// Whether two polygons of one plane share an area.
bool share_area(const Polygon& a, const Polygon& b);

enum class Cut { misses, cuts, empties };

// Face tags below 0: where parts of one solid meet, and where it is open.
constexpr int seam_tag = -1, far_tag = -2;

class Polyhedron {
 public:
  struct Face {
    ExactPlane plane;
    int tag = 0;
    std::vector<int> corners;     // counter-clockwise from outside
    std::vector<int> neighbours;  // face across the edge from corner i to corner i + 1
  };
  std::vector<ExactPoint> corners;
  std::vector<Face> faces;

  // Keeps what is inside the plane; the new face carries `tag`. Neighbours are stale until link().
  Cut cut(const ExactPlane& plane, int tag);
  void link();
  void transform(const ExactAffine& affine);
  Polygon polygon(int face) const;
};

// What a list of closed half-spaces encloses. Face tags are indices into the list; planes that
// bound nothing leave no face.
struct Enclosure {
  enum class State { solid, empty, unbounded };
  State state = State::solid;
  Polyhedron body;
  int emptied_by = -1;  // empty: the plane that left no volume
  Vec3 open_towards;    // unbounded: a direction without end
};
Enclosure enclose(const std::vector<ExactPlane>& planes);

// A cube around every point where three of the planes can meet; its faces carry far_tag.
Polyhedron far_cube(const std::vector<ExactPlane>& planes);
bool is_open(const Polyhedron& body);  // reaches the far cube
Vec3 open_towards(const Polyhedron& body);

// How the closed bodies lie to each other.
enum class Relation { apart, a_holds_b, b_holds_a, equal, overlap };
Relation relate(const Polyhedron& a, const Polyhedron& b);
bool holds(const Polyhedron& body, const std::vector<ExactPoint>& points);
// Some face of `body` has all the points on its outer side.
bool separates(const Polyhedron& body, const std::vector<ExactPoint>& points);

// The part of a polygon inside or outside a plane; false if nothing with an area is left.
bool clip(Polygon& polygon, const ExactPlane& plane);

}  // namespace nicol::solids
