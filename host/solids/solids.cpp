// From the scene to the geometry: parts, nesting, sheets, rounding, contacts, in this order.
#include "solids.hpp"

#include <algorithm>
#include <cmath>

#include "contacts.hpp"

namespace nicol {
namespace {

using namespace solids;

constexpr double near_fraction =
    1e-9;  // of the scene's size: closer faces are probably meant to touch

Bounds joined(const Bounds& a, const Bounds& b) {
  Bounds out = a;
  for (int k = 0; k < 3; ++k) {
    out.low[k] = std::min(a.low[k], b.low[k]);
    out.high[k] = std::max(a.high[k], b.high[k]);
  }
  return out;
}

// Each object's box, and the box of all.
struct Extents {
  std::vector<Bounds> objects;
  double size_mm = 0;
};

Extents extents_of(const Parts& parts, std::size_t object_count) {
  Extents out;
  std::vector<bool> seen(object_count, false);
  out.objects.resize(object_count);
  Bounds all;
  bool any = false;
  const auto include = [&](int object, const Bounds& bounds) {
    out.objects[object] = seen[object] ? joined(out.objects[object], bounds) : bounds;
    seen[object] = true;
    all = any ? joined(all, bounds) : bounds;
    any = true;
  };
  for (const SolidPart& part : parts.solids) include(part.object, part.bounds);
  for (const SheetPart& sheet : parts.sheets) include(sheet.object, sheet.bounds);
  out.size_mm =
      std::hypot(all.high[0] - all.low[0], all.high[1] - all.low[1], all.high[2] - all.low[2]);
  return out;
}

Vec3 middle(const Bounds& b) {
  const auto mean = [&](int k) { return b.low[k] / 2 + b.high[k] / 2; };
  return {mean(0), mean(1), mean(2)};
}

class Writer {
 public:
  Writer(const Scene& scene, const Parts& parts, const Nesting& nesting, const Extents& extents,
         sdl::Diagnostics& diagnostics)
      : scene_(scene), parts_(parts), nesting_(nesting), diagnostics_(diagnostics) {
    for (const Bounds& bounds : extents.objects) {
      middles_.push_back(middle(bounds));
      centres_.emplace_back(middles_.back());
    }
  }

  const std::vector<ExactPoint>& centres() const { return centres_; }

  Geometry write() {
    geometry_.cells.emplace_back();
    for (int i = 0; i < size_of(parts_.solids); ++i) write_cell(i);
    for (const SheetPart& sheet : parts_.sheets) write_sheet(sheet);
    for (int i = 0; i < size_of(scene_.objects); ++i) write_face_emissions(i);
    return std::move(geometry_);
  }

 private:
  const Scene& scene_;
  const Parts& parts_;
  const Nesting& nesting_;
  sdl::Diagnostics& diagnostics_;
  std::vector<Vec3> middles_;
  std::vector<ExactPoint> centres_;
  Geometry geometry_;

  void write_cell(int index) {
    const SolidPart& part = parts_.solids[index];
    Cell cell;
    cell.object = part.object;
    cell.medium = scene_.objects[part.object].medium.value_or(0);
    cell.parent = nesting_.parent[index] + 1;
    cell.centre_mm = middles_[part.object];
    cell.first_face = size_of(geometry_.faces);
    cell.face_count = size_of(part.body.faces);
    std::vector<Vec3> corners;
    for (const ExactPoint& corner : part.body.corners) corners.push_back(rounded(corner));
    for (const Polyhedron::Face& face : part.body.faces) {
      Face out;
      out.plane = local_plane(face.plane, centres_[part.object]);
      out.shape_face = face.tag;
      for (int corner : face.corners) out.corners.push_back(corners[corner]);
      geometry_.faces.push_back(std::move(out));
    }
    geometry_.cells.push_back(std::move(cell));
  }

  void write_sheet(const SheetPart& part) {
    const Object& object = scene_.objects[part.object];
    const ExactPoint& centre = centres_[part.object];
    Sheet sheet;
    sheet.object = part.object;
    sheet.cell = part.around + 1;
    sheet.emission = object.emission.value_or(-1);
    sheet.polarizer = object.polarizer.value_or(-1);
    sheet.centre_mm = middles_[part.object];
    sheet.plane = local_plane(part.polygon.plane, centre);
    for (int i = 0; i < size_of(part.polygon.edges); ++i) {
      sheet.edges.push_back(local_plane(
          upright(part.polygon.plane, part.polygon.edges[i], part.polygon.corners[i]), centre));
      sheet.corners.push_back(rounded(part.polygon.corners[i]));
    }
    sheet.has_disc = part.is_disc;
    if (part.is_disc) {
      sheet.disc = {rounded_difference(part.centre, centre), part.radius_mm, part.hole_radius_mm};
    }
    geometry_.sheets.push_back(std::move(sheet));
  }

  void write_face_emissions(int index) {
    const Object& object = scene_.objects[index];
    if (object.face_emissions.empty()) return;
    // Cells lie in the order of their objects, after the surroundings.
    const auto earlier = [](const Cell& cell, int object_index) {
      return cell.object < object_index;
    };
    const auto first =
        std::lower_bound(geometry_.cells.begin(), geometry_.cells.end(), index, earlier);
    const auto last = std::lower_bound(first, geometry_.cells.end(), index + 1, earlier);
    for (const FaceEmission& shining : object.face_emissions) {
      bool found = false;
      for (auto cell = first; cell != last; ++cell) {
        for (int f = cell->first_face; f < cell->first_face + cell->face_count; ++f) {
          if (geometry_.faces[f].shape_face != shining.face || shining.face < 0) continue;
          geometry_.faces[f].emission = shining.emission;
          found = true;
        }
      }
      if (found || first == last) continue;
      diagnostics_.warning(object.where,
                           "face " + std::to_string(shining.face) + " of " + name_of(object) +
                               " should shine, but the other faces leave nothing of it");
    }
  }
};

void link_children(Geometry& geometry) {
  for (int i = 1; i < size_of(geometry.cells); ++i) {
    geometry.cells[geometry.cells[i].parent].children.push_back(i);
  }
  for (int i = 0; i < size_of(geometry.sheets); ++i) {
    geometry.cells[geometry.sheets[i].cell].sheets.push_back(i);
  }
}

int camera_cell(const Scene& scene, const Parts& parts, const Nesting& nesting,
                sdl::Diagnostics& diagnostics) {
  const Vec3& p = scene.camera.location;
  if (scene.camera.orthographic) return 0;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    diagnostics.error(scene.camera.where, "the camera's location is not finite");
    return 0;
  }
  bool on_surface = false;
  const int around = part_around(ExactPoint(p), parts, nesting, on_surface);
  if (on_surface) {
    diagnostics.warning(
        scene.camera.where,
        "the camera stands exactly on a surface; it is taken to stand outside of it");
  }
  return around + 1;
}

}  // namespace

Geometry build_geometry(const Scene& scene, sdl::Diagnostics& diagnostics) {
  Parts parts = make_parts(scene, diagnostics);
  split_nested(parts.solids);
  const Extents extents = extents_of(parts, scene.objects.size());
  const double near_mm = near_fraction * extents.size_mm;
  const Nesting nesting = nest(scene, parts.solids, near_mm, diagnostics);
  place_sheets(scene, parts, nesting, diagnostics);
  Writer writer(scene, parts, nesting, extents, diagnostics);
  Geometry geometry = writer.write();
  link_children(geometry);
  find_contacts(scene, parts, nesting, writer.centres(), geometry, diagnostics);
  warn_of_near_contacts(scene, parts, nesting, near_mm, geometry, diagnostics);
  geometry.camera_cell = camera_cell(scene, parts, nesting, diagnostics);
  return geometry;
}

}  // namespace nicol
