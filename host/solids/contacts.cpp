// Contacts: coplanar faces whose polygons overlap. The part in contact is the face inside those
// edges of the other polygon that cut it, so nothing is constructed and a face wholly covered has
// no edges.
#include "contacts.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "disc.hpp"
#include "sweep.hpp"

namespace nicol::solids {
namespace {

bool cuts(const ExactPlane& edge, const Polygon& polygon) {
  return std::any_of(polygon.corners.begin(), polygon.corners.end(),
                     [&](const ExactPoint& corner) { return side(edge, corner) > 0; });
}

bool coplanar(const ExactPlane& a, const ExactPlane& b) { return same(a, b) || opposite(a, b); }

class ContactFinder {
 public:
  ContactFinder(const Scene& scene, const Parts& parts, const Nesting& nesting,
                const std::vector<ExactPoint>& centres, Geometry& geometry,
                sdl::Diagnostics& diagnostics)
      : scene_(scene),
        parts_(parts),
        nesting_(nesting),
        centres_(centres),
        geometry_(geometry),
        diagnostics_(diagnostics) {}

  void run() {
    for (const auto& [a, b] : nesting_.neighbours) {
      if (siblings(a, b)) touch_cells(a, b);
    }
    touch_sheets();
    store();
  }

 private:
  struct Found {
    int cell;
    Patch patch;
  };
  const Scene& scene_;
  const Parts& parts_;
  const Nesting& nesting_;
  const std::vector<ExactPoint>& centres_;
  Geometry& geometry_;
  sdl::Diagnostics& diagnostics_;
  std::vector<Found> found_;

  int object_around(int part) const { return part < 0 ? -1 : parts_.solids[part].object; }

  bool siblings(int a, int b) const {
    return parts_.solids[a].object == parts_.solids[b].object ||
           object_around(nesting_.parent[a]) == object_around(nesting_.parent[b]);
  }

  const ExactPoint& centre(int part) const { return centres_[parts_.solids[part].object]; }

  int face_index(int part, int face) const { return geometry_.cells[part + 1].first_face + face; }

  // What shines by itself hides what is behind it.
  bool shines(const Patch& patch) const { return geometry_.faces[patch.face].emission >= 0; }

  void add_patch(int part, const Polygon& face, const Polygon& other, Patch patch) {
    if (shines(patch)) return;
    for (int i = 0; i < size_of(other.edges); ++i) {
      if (!cuts(other.edges[i], face)) continue;
      patch.edges.push_back(
          local_plane(upright(face.plane, other.edges[i], other.corners[i]), centre(part)));
    }
    found_.push_back({part + 1, std::move(patch)});
  }

  // ---- cell on cell ----
  void touch_cells(int a, int b) {
    const Polyhedron &first = parts_.solids[a].body, &second = parts_.solids[b].body;
    for (int f = 0; f < size_of(first.faces); ++f) {
      for (int g = 0; g < size_of(second.faces); ++g) {
        if (!opposite(first.faces[f].plane, second.faces[g].plane)) continue;
        const Polygon p = first.polygon(f), q = second.polygon(g);
        if (!share_area(p, q)) continue;
        add_patch(a, p, q, patch_between(a, f, b, g));
        add_patch(b, q, p, patch_between(b, g, a, f));
      }
    }
  }

  Patch patch_between(int a, int f, int b, int g) const {
    const Object &own = scene_.objects[parts_.solids[a].object],
                 &other = scene_.objects[parts_.solids[b].object];
    Patch patch;
    patch.face = face_index(a, f);
    patch.other_face = face_index(b, g);
    patch.other_cell = b + 1;
    patch.emission = geometry_.faces[patch.other_face].emission;
    if (&own == &other) {
      patch.behind = Patch::Behind::seam;
    } else if (patch.emission >= 0) {
      patch.behind = Patch::Behind::light;
    } else {
      patch.behind = own.optical_contact || other.optical_contact ? Patch::Behind::cell_contact
                                                                  : Patch::Behind::cell_gap;
    }
    return patch;
  }

  // ---- sheets ----
  void touch_sheets() {
    if (parts_.sheets.empty()) return;
    const int solid_count = size_of(parts_.solids);
    std::vector<Bounds> boxes;
    for (const SolidPart& part : parts_.solids) boxes.push_back(part.bounds);
    for (const SheetPart& sheet : parts_.sheets) boxes.push_back(sheet.bounds);
    for (const auto& [a, b] : close_pairs(boxes, 0)) {
      if (b < solid_count) continue;
      if (a < solid_count) {
        touch_sheet(a, b - solid_count);
      } else {
        refuse_stacked(a - solid_count, b - solid_count);
      }
    }
  }

  void touch_sheet(int part, int index) {
    const SheetPart& sheet = parts_.sheets[index];
    if (object_around(sheet.around) != object_around(nesting_.parent[part])) return;
    const Polyhedron& body = parts_.solids[part].body;
    for (int f = 0; f < size_of(body.faces); ++f) {
      if (!coplanar(body.faces[f].plane, sheet.polygon.plane)) continue;
      const Polygon face = body.polygon(f);
      Patch patch;
      patch.face = face_index(part, f);
      patch.sheet = index;
      patch.emission = geometry_.sheets[index].emission;
      patch.behind = patch.emission >= 0 ? Patch::Behind::light : Patch::Behind::polarizer;
      if (!sheet.is_disc) {
        if (share_area(face, sheet.polygon)) add_patch(part, face, sheet.polygon, std::move(patch));
      } else if (!shines(patch) && disc_covers_some(sheet, face.plane, face.corners)) {
        patch.has_disc = true;
        patch.disc = {rounded_difference(sheet.centre, centre(part)), sheet.radius_mm,
                      sheet.hole_radius_mm};
        found_.push_back({part + 1, std::move(patch)});
      }
    }
  }

  // Of two sheets in one place none is in front.
  void refuse_stacked(int a, int b) {
    const SheetPart &first = parts_.sheets[a], &second = parts_.sheets[b];
    if (first.object == second.object || !coplanar(first.polygon.plane, second.polygon.plane))
      return;
    bool overlap = false;
    if (first.is_disc && second.is_disc) {
      overlap = discs_overlap(first, second);
    } else if (first.is_disc || second.is_disc) {
      const SheetPart &disc = first.is_disc ? first : second,
                      &other = first.is_disc ? second : first;
      overlap = disc_covers_some(disc, other.polygon.plane, other.polygon.corners);
    } else {
      overlap = share_area(first.polygon, second.polygon);
    }
    if (!overlap) return;
    diagnostics_.error(
        scene_.objects[second.object].where,
        name_of(scene_.objects[first.object]) + " and " + name_of(scene_.objects[second.object]) +
            " lie in the same place; set them apart, or give the light the polarizer");
  }

  // Patches by cell and face; where several cover the same place, the first counts.
  void store() {
    const auto rank = [](const Found& f) {
      const bool sheet = f.patch.sheet >= 0;
      return std::make_tuple(f.cell, f.patch.face, sheet ? 0 : 1);
    };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const Found& a, const Found& b) { return rank(a) < rank(b); });
    for (Cell& cell : geometry_.cells) cell.first_patch = cell.patch_count = 0;
    for (Found& f : found_) {
      Cell& cell = geometry_.cells[f.cell];
      if (cell.patch_count++ == 0) cell.first_patch = size_of(geometry_.patches);
      geometry_.patches.push_back(std::move(f.patch));
    }
  }
};

}  // namespace

Plane local_plane(const ExactPlane& plane, const ExactPoint& centre) {
  return {unit_normal(plane), 0.0 - distance(plane, centre)};
}

void find_contacts(const Scene& scene, const Parts& parts, const Nesting& nesting,
                   const std::vector<ExactPoint>& centres, Geometry& geometry,
                   sdl::Diagnostics& diagnostics) {
  ContactFinder(scene, parts, nesting, centres, geometry, diagnostics).run();
}

}  // namespace nicol::solids
