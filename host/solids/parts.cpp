// Shapes to exact parts: see parts.hpp.
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <limits>
#include <optional>

#include "csg.hpp"
#include "flat.hpp"
#include "leaves.hpp"
#include "planar.hpp"

namespace nicol::solids {
namespace {

bool finite(double v) { return std::isfinite(v); }
bool finite(const Vec3& p) { return finite(p.x) && finite(p.y) && finite(p.z); }

std::string text_of(const Vec3& v) {
  return "<" + solids::text_of(v.x) + ", " + solids::text_of(v.y) + ", " + solids::text_of(v.z) +
         ">";
}

// Builds the parts of one object; every method tells what is wrong at the object's place.
class Maker {
 public:
  Maker(const Object& object, int index, Parts& parts, sdl::Diagnostics& diagnostics)
      : object_(object), index_(index), parts_(parts), diagnostics_(diagnostics) {}

  void run() {
    const std::string wrong = wrong_with(object_.transforms);
    if (!wrong.empty()) return error(wrong);
    affine_.emplace(object_.transforms);
    std::visit([this](const auto& shape) { make(shape); }, object_.shape);
  }

 private:
  const Object& object_;
  int index_;
  Parts& parts_;
  sdl::Diagnostics& diagnostics_;
  std::optional<ExactAffine> affine_;

  void error(const std::string& what) {
    diagnostics_.error(object_.where, object_.kind + " " + what);
  }

  // ---- solids ----
  void add_solid(Polyhedron body) {
    Bounds bounds = bounds_of(body.corners);
    parts_.solids.push_back({index_, std::move(body), bounds});
  }

  std::optional<Polyhedron> enclosed(const std::vector<ExactPlane>& planes) {
    Enclosure found = enclose(planes);
    if (found.state == Enclosure::State::empty) {
      error("encloses nothing: face " + std::to_string(found.emptied_by) +
            " leaves no volume of what the faces before it enclose");
      return std::nullopt;
    }
    if (found.state == Enclosure::State::unbounded) {
      error("is not closed: its faces leave it open towards " + text_of(found.open_towards));
      return std::nullopt;
    }
    return std::move(found.body);
  }

  void make_leaf(const Leaf& leaf) {
    if (!leaf.wrong.empty()) return error(leaf.wrong);
    for (const Leaf::Piece& piece : leaf.pieces) {
      std::optional<Polyhedron> body = enclosed(piece.planes);
      if (!body) return;
      for (Polyhedron::Face& face : body->faces) face.tag = piece.tags[face.tag];
      std::stable_sort(body->faces.begin(), body->faces.end(), [](const auto& a, const auto& b) {
        return std::make_pair(a.tag < 0, a.tag) < std::make_pair(b.tag < 0, b.tag);
      });
      body->transform(*affine_);
      add_solid(std::move(*body));
    }
  }

  void make(const ConvexShape& shape) { make_leaf(leaf_of(shape)); }
  void make(const PrismShape& shape) { make_leaf(leaf_of(shape)); }

  // Pieces that may meet in parts of faces are one leaf of CSG, which finds the seams.
  void make(const MeshShape& shape) {
    const Leaf leaf = leaf_of(shape);
    if (leaf.pieces.size() < 2) return make_leaf(leaf);
    CsgShape alone;
    alone.root.leaf = shape;
    alone.root.kind = object_.kind;
    alone.root.where = object_.where;
    make(alone);
  }

  void make(const CsgShape& shape) {
    CsgResult result = make_csg(shape, object_.transforms);
    if (!result.wrong.empty()) return diagnostics_.error(result.where, result.wrong);
    for (Polyhedron& cell : result.cells) add_solid(std::move(cell));
  }

  // ---- sheets ----
  void warn_if_not_flat(const PolygonShape& shape, const ExactPlane& plane) {
    double size = 0, off = 0;
    for (const auto& contour : shape.contours) {
      for (const Vec3& p : contour) {
        const Vec3 d = rounded_difference(ExactPoint(p), ExactPoint(shape.contours[0][0]));
        size = std::max(size, std::hypot(d.x, d.y, d.z));
        if (side(plane, ExactPoint(p)) != 0)
          off = std::max(off, std::abs(distance(plane, ExactPoint(p))));
      }
    }
    if (off <= 1e-9 * size) return;
    diagnostics_.warning(object_.where, object_.kind + " is not flat: a point lies " +
                                            solids::text_of(off) +
                                            " off its plane; it is moved there");
  }

  void make(const PolygonShape& shape) {
    for (const auto& contour : shape.contours) {
      if (!std::all_of(contour.begin(), contour.end(), [](const Vec3& p) { return finite(p); })) {
        return error("has a point that is not finite");
      }
    }
    std::optional<ExactPlane> plane =
        shape.contours.empty() ? std::nullopt : plane_of(shape.contours[0]);
    if (!plane) return error("has no area: its points lie on one line");
    // Contours are laid out in the two axes that the normal leans away from, then lifted back onto
    // the plane.
    int up = 0;
    for (int k = 1; k < 3; ++k) {
      if (abs(plane->v[k]) > abs(plane->v[up])) up = k;
    }
    if (plane->v[up] < 0) plane = plane->opposite();
    warn_if_not_flat(shape, *plane);
    Contours flat;
    for (const auto& contour : shape.contours) {
      flat.emplace_back();
      for (const Vec3& p : contour) {
        const std::array<double, 3> c{p.x, p.y, p.z};
        flat.back().push_back({c[(up + 1) % 3], c[(up + 2) % 3]});
      }
    }
    const std::vector<PlanarPiece> pieces = convex_pieces(flat);
    if (pieces.empty()) return error("encloses no area");
    const bool clockwise = signed_area(flat[0]) < 0;
    for (const PlanarPiece& piece : pieces) add_sheet(lifted(piece, *plane, up), clockwise);
  }

  // The normal points to where the first contour is seen to run counter-clockwise, in the world.
  void add_sheet(Polygon polygon, bool clockwise) {
    polygon.plane = (*affine_)(polygon.plane);
    for (ExactPoint& corner : polygon.corners) corner = (*affine_)(corner);
    if (clockwise != affine_->mirrors()) polygon.plane = polygon.plane.opposite();
    if (clockwise) std::reverse(polygon.corners.begin(), polygon.corners.end());
    const int n = size_of(polygon.corners);
    for (int i = 0; i < n; ++i) {
      polygon.edges.push_back(
          edge_plane(polygon.plane, polygon.corners[i], polygon.corners[(i + 1) % n]));
    }
    SheetPart sheet;
    sheet.object = index_;
    sheet.bounds = bounds_of(polygon.corners);
    sheet.polygon = std::move(polygon);
    parts_.sheets.push_back(std::move(sheet));
  }

  void make(const DiscShape& shape) {
    const bool no_direction = shape.normal.x == 0 && shape.normal.y == 0 && shape.normal.z == 0;
    if (!finite(shape.centre) || !finite(shape.normal) || no_direction) {
      return error("has no direction or place");
    }
    if (!(shape.radius > shape.hole_radius && shape.hole_radius >= 0) || !finite(shape.radius)) {
      return error("needs a radius above that of its hole, and neither below 0");
    }
    const ExactPoint centre(shape.centre);
    const ExactPlane upright(HalfSpace{shape.normal, 0});
    Integer4 plane{upright.v[0] * centre.v[3], upright.v[1] * centre.v[3],
                   upright.v[2] * centre.v[3], 0};
    for (int i = 0; i < 3; ++i) plane[3] -= upright.v[i] * centre.v[i];
    const std::optional<double> scale = scale_in(ExactPlane(plane), *affine_);
    if (!scale)
      return error("becomes an ellipse by its transforms; nicol renders round discs only");
    SheetPart sheet;
    sheet.object = index_;
    sheet.is_disc = true;
    sheet.polygon.plane = (*affine_)(ExactPlane(plane));
    sheet.centre = (*affine_)(centre);
    sheet.radius_mm = shape.radius * *scale;
    sheet.hole_radius_mm = shape.hole_radius * *scale;
    sheet.bounds = bounds_of({sheet.centre});
    for (int k = 0; k < 3; ++k) {
      sheet.bounds.low[k] -= sheet.radius_mm * (1 + 1e-15);
      sheet.bounds.high[k] += sheet.radius_mm * (1 + 1e-15);
    }
    parts_.sheets.push_back(std::move(sheet));
  }
};

}  // namespace

Bounds bounds_of(const std::vector<ExactPoint>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds out;
  out.low.fill(infinity);
  out.high.fill(-infinity);
  for (const ExactPoint& point : points) {
    const Vec3 p = rounded(point);
    const std::array<double, 3> c{p.x, p.y, p.z};
    for (int k = 0; k < 3; ++k) {
      out.low[k] = std::min(out.low[k], std::nextafter(c[k], -infinity));
      out.high[k] = std::max(out.high[k], std::nextafter(c[k], infinity));
    }
  }
  return out;
}

Parts make_parts(const Scene& scene, sdl::Diagnostics& diagnostics) {
  Parts parts;
  for (int i = 0; i < size_of(scene.objects); ++i) {
    Maker(scene.objects[i], i, parts, diagnostics).run();
  }
  return parts;
}

std::string name_of(const Object& object) {
  return object.kind + " at line " + std::to_string(object.where.line);
}

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace nicol::solids
