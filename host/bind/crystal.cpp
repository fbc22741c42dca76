// `crystal { }` with a lattice: forms, CDL and twins to half-spaces.
#include "host/bind/crystal.hpp"

#include <algorithm>

#include "host/bind/units.hpp"
#include "host/crystallography/bounded.hpp"
#include "host/crystallography/cdl.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

using namespace crystallography;

void read_cdl(Context& context, RawCrystal& raw) {
  if (raw.cdl.empty()) return;
  const auto parsed = parse_cdl(raw.cdl);
  if (const CdlError* error = std::get_if<CdlError>(&parsed)) {
    context.error(raw.cdl_where, "CDL, character " + std::to_string(error->at + 1) + ": " +
                                     error->message + "\n  " + raw.cdl + "\n  " +
                                     std::string(error->at, ' ') + "^");
    return;
  }
  const Cdl& cdl = std::get<Cdl>(parsed);
  if (!raw.system.empty() || !raw.point_group.empty())
    context.error(raw.cdl_where, "'cdl' names system and point group itself");
  raw.system = name(cdl.system);
  raw.point_group = cdl.point_group;
  raw.system_where = raw.point_group_where = raw.cdl_where;
  for (const CdlForm& f : cdl.forms)
    raw.forms.push_back({f.face, f.distance, false, false, raw.cdl_where});
  if (cdl.twin) {
    if (raw.twin) context.error(raw.twin->where, "'cdl' names a twin already");
    raw.twin.emplace();
    raw.twin->where = raw.cdl_where;
    raw.twin->element = cdl.twin;
    raw.twin->contact = cdl.twin->contact;
    raw.twin->penetration = cdl.twin->penetration;
    raw.twin->angle_deg = cdl.twin->angle_deg;
  }
}

std::optional<Composition> composition_of(Context& context, const RawTwin& raw) {
  Composition twin;
  twin.offset = raw.offset;
  twin.individuals = raw.individuals;
  twin.thickness = raw.thickness;
  if (!raw.law.empty() == raw.element.has_value()) {
    context.error(raw.where, "a twin has a 'law', or an 'axis', 'normal' or 'plane': one of them");
    return std::nullopt;
  }
  if (raw.element) twin.law = *raw.element;
  if (!raw.law.empty()) {
    std::vector<std::string> known;
    const NamedTwinLaw* found = nullptr;
    for (const NamedTwinLaw& row : twin_laws()) {
      known.push_back(row.name);
      if (raw.law == row.name) found = &row;
    }
    if (!found) {
      context.error(raw.where, unknown("twin law", raw.law, "'twin'", known));
      return std::nullopt;
    }
    twin.law = found->law;
  }
  if (raw.angle_deg) twin.law.angle_deg = *raw.angle_deg;
  if (raw.contact) {
    twin.law.contact = raw.contact;
    twin.law.penetration = false;
  }
  if (raw.penetration) twin.law.penetration = true;
  if (twin.individuals > 2 && twin.thickness == 0) {
    context.error(raw.where, "more than two individuals need a 'thickness'");
    return std::nullopt;
  }
  return twin;
}

// Four indices (h k i l) are those of hexagonal axes.
bool has_hexagonal_axes(const RawCrystal& raw, const PointGroup& group) {
  return !raw.rhombohedral &&
         (group.system == System::trigonal || group.system == System::hexagonal);
}

void check_four_indices(Context& context, const RawCrystal& raw, const PointGroup& group) {
  if (has_hexagonal_axes(raw, group)) return;
  const auto refuse = [&](bool four, Location where) {
    if (four) context.error(where, "four indices (h k i l) belong to hexagonal axes");
  };
  for (const RawForm& f : raw.forms) refuse(f.four_indices, f.where);
  for (const RawFace& f : raw.faces) refuse(f.direction.size() == 4, f.where);
  if (raw.twin) refuse(raw.twin->four_indices, raw.twin->where);
}

void add_faces(Context& context, RawCrystal& raw, const PointGroup& group, Habit& habit) {
  for (const RawFace& f : raw.faces) {
    std::string why;
    const auto face = face_of_indices(f.direction, why);
    if (!face) context.error(f.where, why);
    else raw.forms.push_back({*face, f.distance, true, false, f.where});
  }
  const bool inverted = raw.left || raw.enantiomorph;
  if (inverted && !group.has_hands())
    context.warning(raw.hand_where, "point group " + group.symbol +
                                        " has mirror symmetry: its crystals are neither left nor "
                                        "right, and 'left' turns faces to their opposites");
  for (const RawForm& f : raw.forms) {
    const Miller face = inverted ? -f.face : f.face;
    if (f.single) habit.faces.push_back({face, f.distance});
    else
      for (const Miller m : form(group, face)) habit.faces.push_back({m, f.distance});
    context.step(f.where, habit.faces.size());
    if (habit.faces.size() <= most_faces) continue;
    context.error(f.where, "a crystal with more than " + std::to_string(most_faces) + " faces");
    throw GiveUp{};
  }
}

// "[0 0 1]" of a lattice if small whole numbers do, else "<0, 0, 1>".
std::string direction_text(Vec3 d, bool zone) {
  const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const auto list = [](Vec3 v, const char* between) {
    return to_text(v.x + 0.0) + between + to_text(v.y + 0.0) + between + to_text(v.z + 0.0);
  };
  for (int factor = 1; zone && factor <= 12; ++factor) {
    const Vec3 v = d * (factor / most);
    const Vec3 whole{std::round(v.x), std::round(v.y), std::round(v.z)};
    if (length(v - whole) < 1e-9) return "[" + list(whole, " ") + "]";
  }
  const auto short_of = [&](double x) { return std::round(x / most * 1e4) / 1e4; };
  return "<" + list({short_of(d.x), short_of(d.y), short_of(d.z)}, ", ") + ">";
}

// Without a lattice: `face` is `facet`.
void finish_cartesian(Context& context, RawObject& object) {
  const RawCrystal& raw = *object.crystal;
  if (raw.left || raw.enantiomorph)
    context.error(raw.hand_where, "'left' and 'enantiomorph' belong to a crystal of forms");
  if (raw.size_where.line)
    context.error(raw.size_where, "'size' belongs to a crystal of forms; 'scale' scales");
  for (const RawFace& f : raw.faces) {
    std::vector<double> d = f.direction;
    d.resize(3, d.size() == 1 ? d[0] : 0);
    if (const auto h = half_space(context, f.where, {d[0], d[1], d[2]}, f.distance))
      object.facets.push_back(*h);
  }
}

}  // namespace

void finish_crystal(Context& context, RawObject& object) {
  RawCrystal& raw = *object.crystal;
  const Location where = object.block->where;
  if (!raw.has_lattice()) return finish_cartesian(context, object);
  const std::size_t errors_before = context.error_count();
  read_cdl(context, raw);
  if (context.error_count() > errors_before) return;
  const auto group = group_of(context, raw, where);
  if (!group) return;
  const auto lattice = lattice_of(context, raw, *group, where);
  if (!lattice) return;
  Habit habit;
  habit.lattice = *lattice;
  habit.size = raw.size;
  habit.cuts = object.facets;
  check_four_indices(context, raw, *group);
  add_faces(context, raw, *group, habit);
  if (raw.twin && raw.twin->individuals * habit.faces.size() > most_faces)
    return context.error(raw.twin->where, "a twin with more than " + std::to_string(most_faces) +
                                              " faces in all its individuals");
  if (raw.twin && !(habit.twin = composition_of(context, *raw.twin))) return;
  object.axes = basis(*lattice);
  object.individuals.clear();
  for (Individual& one : individuals(habit)) {
    RawIndividual part;
    part.faces = std::move(one.faces);
    part.without = std::move(one.without);
    part.frame.extra = one.turn;
    part.frame.opposite_hand = one.opposite_hand != raw.enantiomorph;
    object.individuals.push_back(std::move(part));
  }
  object.facets = object.individuals[0].faces;
  object.crystal_frame = object.individuals[0].frame;
  if (object.individuals.size() == 1) object.individuals.clear();
}

bool check_closed(Context& context, const RawObject& raw) {
  constexpr std::size_t most_checked = 2000;  // beyond, only the builder of solids tells
  if ((!raw.crystal && !raw.gem) || raw.facets.empty() || raw.facets.size() > most_checked)
    return true;
  const auto open = open_direction(raw.facets);
  if (!open) return true;
  context.error(raw.block->where,
                "this " + raw.block->name + " is open towards " +
                    direction_text(*open, raw.axes.has_value()) +
                    (raw.axes     ? ": no form or face closes it there"
                     : raw.crystal ? " (X, Y, Z): no facet closes it there"
                                   : ": no facet closes it there"));
  return false;
}

CsgShape protruding(const RawIndividual& individual, Location where) {
  CsgShape shape;
  shape.root.operation = CsgShape::Operation::difference;
  for (const auto& faces : {individual.faces, individual.without}) {
    CsgShape::Node leaf;
    leaf.leaf = ConvexShape{faces};
    leaf.kind = "crystal";
    leaf.where = where;
    shape.root.operands.push_back(std::move(leaf));
  }
  shape.root.kind = "crystal";
  shape.root.where = where;
  return shape;
}

Affines shape_frame(const RawObject& raw) {
  Affines frame;
  if (raw.axes) frame.push_back(*raw.axes);
  if (raw.block->name == "crystal") frame.push_back(from_crystal());
  return frame;
}

}  // namespace nicol
