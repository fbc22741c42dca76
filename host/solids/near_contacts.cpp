// Faces that almost touch: seldom meant, mostly numbers that were rounded differently.
#include <algorithm>
#include <cmath>
#include <map>

#include "contacts.hpp"
#include "sweep.hpp"

namespace nicol::solids {
namespace {

Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double area(const std::vector<Vec3>& p, const Vec3& normal) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    sum += dot(cross(p[i] - p[0], p[i + 1] - p[0]), normal) / 2;
  return std::abs(sum);
}

// The part of p over q, seen along the normal of q (Sutherland & Hodgman 1974).
std::vector<Vec3> over(std::vector<Vec3> p, const std::vector<Vec3>& q, const Vec3& normal) {
  for (std::size_t i = 0; i < q.size() && !p.empty(); ++i) {
    const Vec3 outward = cross(q[(i + 1) % q.size()] - q[i], normal);
    std::vector<Vec3> kept;
    for (std::size_t j = 0; j < p.size(); ++j) {
      const Vec3 &a = p[j], &b = p[(j + 1) % p.size()];
      const double out_a = dot(a - q[i], outward), out_b = dot(b - q[i], outward);
      if (out_a <= 0) kept.push_back(a);
      if (out_a * out_b < 0) {
        const double t = out_a / (out_a - out_b);
        kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
      }
    }
    p = std::move(kept);
  }
  return p;
}

// A face or a sheet; corners in world mm.
struct Flat {
  const ExactPlane* plane;
  Vec3 normal;
  const std::vector<Vec3>* corners;
  std::vector<ExactPoint> exact_corners;
};

// The largest distance of the corners of b from the plane of a, or 0 if they touch exactly, lie
// farther than `near_mm`, or face each other nowhere.
double gap_mm(const Flat& a, const Flat& b, double near_mm) {
  double largest = 0;
  for (const ExactPoint& corner : b.exact_corners) {
    if (side(*a.plane, corner) != 0)
      largest = std::max(largest, std::abs(distance(*a.plane, corner)));
    if (largest > near_mm) return 0;
  }
  if (largest == 0) return 0;
  const double shared = area(over(*b.corners, *a.corners, a.normal), a.normal);
  const double smaller = std::min(area(*a.corners, a.normal), area(*b.corners, b.normal));
  return shared > 1e-9 * smaller ? largest : 0;
}

class NearContacts {
 public:
  NearContacts(const Scene& scene, const Parts& parts, double near_mm, const Geometry& geometry)
      : scene_(scene), parts_(parts), near_mm_(near_mm), geometry_(geometry) {}

  void solids(int a, int b) {
    const Polyhedron &first = parts_.solids[a].body, &second = parts_.solids[b].body;
    for (int f = 0; f < size_of(first.faces); ++f) {
      for (int g = 0; g < size_of(second.faces); ++g) {
        const ExactPlane &p = first.faces[f].plane, &q = second.faces[g].plane;
        if (same(p, q) || opposite(p, q) || !maybe(face(a, f), face(b, g))) continue;
        compare(flat(a, f), flat(b, g), parts_.solids[a].object, parts_.solids[b].object);
      }
    }
  }

  void sheet_on_solid(int part, int sheet) {
    const Polyhedron& body = parts_.solids[part].body;
    const Sheet& out = geometry_.sheets[sheet];
    if (out.has_disc) return disc_on_solid(part, sheet);
    const Flat other{&parts_.sheets[sheet].polygon.plane, out.plane.normal, &out.corners,
                     parts_.sheets[sheet].polygon.corners};
    for (int f = 0; f < size_of(body.faces); ++f) {
      if (parallel(face(part, f).plane.normal, out.plane.normal)) {
        compare(flat(part, f), other, parts_.solids[part].object, out.object);
      }
    }
  }

  void tell(sdl::Diagnostics& diagnostics) const {
    for (const auto& [objects, gap] : gaps_) {
      const Object &first = scene_.objects[objects.first], &second = scene_.objects[objects.second];
      if (objects.first == objects.second) {
        diagnostics.warning(first.where, name_of(first) + " has faces within " + text_of(gap) +
                                             " mm of each other that do not coincide: where they "
                                             "should, write the same numbers and transforms");
        continue;
      }
      diagnostics.warning(second.where,
                          name_of(first) + " and " + name_of(second) + " come within " +
                              text_of(gap) +
                              " mm without touching: where they should touch, write the same "
                              "numbers and transforms in both");
    }
  }

 private:
  const Scene& scene_;
  const Parts& parts_;
  double near_mm_;
  const Geometry& geometry_;
  std::map<std::pair<int, int>, double> gaps_;

  const Face& face(int part, int f) const {
    return geometry_.faces[geometry_.cells[part + 1].first_face + f];
  }

  Flat flat(int part, int f) const {
    return {&parts_.solids[part].body.faces[f].plane, face(part, f).plane.normal,
            &face(part, f).corners, parts_.solids[part].body.polygon(f).corners};
  }

  static bool parallel(const Vec3& a, const Vec3& b) {
    const Vec3 c = cross(a, b);
    return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) < 1e-7;
  }

  // A cheap look in double before the exact one.
  bool maybe(const Face& a, const Face& b) const {
    if (!parallel(a.plane.normal, b.plane.normal)) return false;
    const Vec3 &p = a.corners[0], &q = b.corners[0];
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const Vec3 d = q - p;
    const double height = std::abs(dot(d, a.plane.normal));
    return height <= near_mm_ + 1e-14 * size + 1e-6 * std::sqrt(dot(d, d));
  }

  void compare(const Flat& a, const Flat& b, int object_a, int object_b) {
    double gap = gap_mm(a, b, near_mm_);
    if (gap == 0) gap = gap_mm(b, a, near_mm_);
    note(gap, object_a, object_b);
  }

  void note(double gap, int object_a, int object_b) {
    if (gap == 0) return;
    const auto [at, fresh] = gaps_.insert({std::minmax(object_a, object_b), gap});
    if (!fresh) at->second = std::min(at->second, gap);
  }

  // A disc counts as its square: near enough for a warning.
  void disc_on_solid(int part, int sheet) {
    const SheetPart& disc = parts_.sheets[sheet];
    const Vec3 normal = geometry_.sheets[sheet].plane.normal;
    for (int f = 0; f < size_of(parts_.solids[part].body.faces); ++f) {
      const Flat other = flat(part, f);
      if (!parallel(other.normal, normal) || side(*other.plane, disc.centre) == 0) continue;
      const double gap = std::abs(distance(*other.plane, disc.centre));
      const Vec3 c = rounded(disc.centre);
      const auto beyond = [&](const Vec3& p) {
        return std::sqrt(dot(p - c, p - c)) > disc.radius_mm;
      };
      if (gap > near_mm_) continue;
      const std::vector<Vec3> foot{c};
      const bool over_face = !over(foot, *other.corners, other.normal).empty();
      const bool all_beyond = std::all_of(other.corners->begin(), other.corners->end(), beyond);
      if (over_face || !all_beyond) note(gap, parts_.solids[part].object, disc.object);
    }
  }
};

}  // namespace

void warn_of_near_contacts(const Scene& scene, const Parts& parts, const Nesting& nesting,
                           double near_mm, const Geometry& geometry,
                           sdl::Diagnostics& diagnostics) {
  NearContacts near(scene, parts, near_mm, geometry);
  // Of one solid, only CSG brings faces together that were written apart.
  const auto from_csg = [&](int part) {
    return std::holds_alternative<CsgShape>(scene.objects[parts.solids[part].object].shape);
  };
  for (const auto& [a, b] : nesting.neighbours) {
    if (parts.solids[a].object != parts.solids[b].object || from_csg(a)) near.solids(a, b);
  }
  for (int a = 0; a < size_of(parts.solids); ++a) {
    if (from_csg(a)) near.solids(a, a);
  }
  const int solid_count = size_of(parts.solids);
  std::vector<Bounds> boxes;
  for (const SolidPart& part : parts.solids) boxes.push_back(part.bounds);
  for (const SheetPart& sheet : parts.sheets) boxes.push_back(sheet.bounds);
  if (!parts.sheets.empty()) {
    for (const auto& [a, b] : close_pairs(boxes, near_mm)) {
      if (a < solid_count && b >= solid_count) near.sheet_on_solid(a, b - solid_count);
    }
  }
  near.tell(diagnostics);
}

}  // namespace nicol::solids
