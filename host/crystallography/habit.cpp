// From faces to half-spaces: see habit.hpp.
#include "host/crystallography/habit.hpp"

#include "host/vec.hpp"

namespace nicol::crystallography {

namespace {

Vec3 as_vector(Miller m) { return {1.0 * m.h, 1.0 * m.k, 1.0 * m.l}; }

Vec3 cartesian(const Lattice& lattice, Vec3 hkl) {
  const auto& r = lattice.reciprocal;
  return r[0] * hkl.x + r[1] * hkl.y + r[2] * hkl.z;
}

Vec3 indices(const Lattice& lattice, Vec3 normal) {
  const auto& a = lattice.axes;
  return {dot(normal, a[0]), dot(normal, a[1]), dot(normal, a[2])};
}

// A normal that a small factor makes whole (twins of cubic lattices) becomes exactly that.
HalfSpace whole_if_near(HalfSpace face) {
  constexpr int largest_factor = 24;
  constexpr double tolerance = 1e-10;
  const double scale = length(face.normal);
  for (int factor = 1; factor <= largest_factor; ++factor) {
    const Vec3 n = face.normal * factor;
    const Vec3 whole{std::round(n.x), std::round(n.y), std::round(n.z)};
    if (length(n - whole) < tolerance * scale * factor) return {whole, face.offset * factor};
  }
  return face;
}

// One half-space per face; of parallel ones the nearest.
std::vector<HalfSpace> grown(const Habit& habit) {
  std::vector<HalfSpace> faces;
  std::vector<Miller> known;
  for (const HabitFace& f : habit.faces) {
    const double offset = habit.size * f.distance * length(habit.lattice.normal(f.face));
    std::size_t i = 0;
    while (i < known.size() && !(known[i] == f.face)) ++i;
    if (i == known.size()) {
      known.push_back(f.face);
      faces.push_back({as_vector(f.face), offset});
    } else if (offset < faces[i].offset) {
      faces[i].offset = offset;
    }
  }
  return faces;
}

struct Contact {
  Vec3 normal;      // in lattice coordinates
  double unit = 0;  // its Cartesian length: offset of a plane at distance 1
};

Contact contact_plane(const Habit& habit, const TwinLaw& law) {
  const Lattice& lattice = habit.lattice;
  if (law.contact) return {as_vector(*law.contact), length(lattice.normal(*law.contact))};
  if (law.operation != TwinLaw::Operation::rotation_about_edge)
    return {as_vector(law.element), length(lattice.normal(law.element))};
  const Vec3 axis = normalize(lattice.direction(as_vector(law.element)));  // across the axis
  const HalfSpace whole = whole_if_near({indices(lattice, axis * length(lattice.axes[0])), 0});
  return {whole.normal, length(cartesian(lattice, whole.normal))};
}

Vec3 turned(const TwinOperation& op, Vec3 v) {
  const Vec3 image = op.rotation[0] * v.x + op.rotation[1] * v.y + op.rotation[2] * v.z;
  return op.mirrors ? -image : image;
}

// The first individual's faces after the twin operation about a point of the contact plane.
std::vector<HalfSpace> twinned(const Habit& habit, const std::vector<HalfSpace>& first,
                               const Contact& contact) {
  const TwinOperation op = twin_operation(habit.lattice, habit.twin->law);
  const Vec3 centre = normalize(cartesian(habit.lattice, contact.normal)) *
                      (habit.twin->offset * habit.size);
  const Vec3 shift = centre - turned(op, centre);
  std::vector<HalfSpace> faces;
  for (const HalfSpace& face : first) {
    const Vec3 normal = turned(op, cartesian(habit.lattice, face.normal));
    faces.push_back(
        whole_if_near({indices(habit.lattice, normal), face.offset + dot(normal, shift)}));
  }
  return faces;
}

// What is true of every other individual.
void turn(const TwinOperation& op, Individual& one) {
  for (int row = 0; row < 3; ++row)
    one.turn.m[row] = {op.rotation[row].x, op.rotation[row].y, op.rotation[row].z};
  one.opposite_hand = op.mirrors;
}

// Slab i between its contact planes, of which the first has no lower and the last no upper one.
void bound_slab(const Composition& twin, const Contact& contact, double size, int i,
                Individual& one) {
  const auto offset = [&](int plane) {
    return (twin.offset + (plane - twin.individuals / 2.0) * twin.thickness) * size * contact.unit;
  };
  if (i + 1 < twin.individuals) one.faces.push_back({contact.normal, offset(i + 1)});
  if (i > 0) one.faces.push_back({-contact.normal, -offset(i)});
}

}  // namespace

Affine basis(const Lattice& lattice) {
  Affine map;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = lattice.axes[i];
    map.m[i] = {axis.x, axis.y, axis.z};
  }
  return map;
}

std::vector<Individual> individuals(const Habit& habit) {
  const std::vector<HalfSpace> first = grown(habit);
  std::vector<HalfSpace> cuts;
  for (const HalfSpace& cut : habit.cuts)
    cuts.push_back({indices(habit.lattice, cut.normal), cut.offset});
  const auto cut = [&cuts](Individual& one) {
    one.faces.insert(one.faces.end(), cuts.begin(), cuts.end());
  };
  if (!habit.twin) {
    Individual single;
    single.faces = first;
    cut(single);
    return {single};
  }
  const Composition& twin = *habit.twin;
  const Contact contact = contact_plane(habit, twin.law);
  const TwinOperation op = twin_operation(habit.lattice, twin.law);
  const std::vector<HalfSpace> second = twinned(habit, first, contact);
  std::vector<Individual> all(twin.law.penetration ? 2 : static_cast<std::size_t>(twin.individuals));
  for (std::size_t i = 0; i < all.size(); ++i) {
    Individual& one = all[i];
    one.faces = i % 2 ? second : first;
    if (i % 2) turn(op, one);
    if (!twin.law.penetration) bound_slab(twin, contact, habit.size, static_cast<int>(i), one);
    else if (i == 1) one.without = first;
    cut(one);
  }
  return all;
}

}  // namespace nicol::crystallography
