// Cell, system and point group of `crystal { }`.
#include <algorithm>
#include <cmath>

#include "host/bind/crystal.hpp"

namespace nicol {

using namespace crystallography;

namespace {

// c/a of systems with one free ratio where the scene names none.
constexpr double default_ratio = 1.1;

std::optional<System> system_of(Context& context, const RawCrystal& raw) {
  if (raw.system.empty()) return std::nullopt;
  const auto system = find_system(raw.system);
  if (!system)
    context.error(raw.system_where,
                  unknown("crystal system", raw.system, "'crystal'", system_names()));
  return system;
}

double standard_gamma(System system) {
  return system == System::trigonal || system == System::hexagonal ? 120 : 90;
}

std::optional<Cell> cell_of_lengths(const RawCrystal& raw, System system) {
  const auto& n = raw.cell;
  Cell cell;
  cell.gamma_deg = standard_gamma(system);
  switch (n.size()) {
    case 1:
      return system == System::cubic ? std::optional<Cell>(cell) : std::nullopt;
    case 2:
      if (!raw.rhombohedral) return std::nullopt;
      return Cell{1, 1, 1, n[1], n[1], n[1]};
    case 4:
      if (system != System::monoclinic) return std::nullopt;
      return Cell{n[0], n[1], n[2], 90, n[3], 90};
    case 3:
      return Cell{n[0], n[1], n[2], 90, 90, cell.gamma_deg};
    case 6:
      return Cell{n[0], n[1], n[2], n[3], n[4], n[5]};
    default:
      return std::nullopt;
  }
}

// Rhombohedral angle of a hexagonal c/a: sin(alpha / 2) = 3 / (2 sqrt(3 + (c/a)^2)).
double rhombohedral_angle_deg(double ratio) {
  constexpr double degrees = 180 / 3.14159265358979323846;
  return 2 * std::asin(1.5 / std::sqrt(3 + ratio * ratio)) * degrees;
}

std::optional<Cell> cell_of_ratios(const RawCrystal& raw, System system) {
  const auto& n = raw.axial_ratio;
  const bool one_ratio = system == System::tetragonal || system == System::trigonal ||
                         system == System::hexagonal;
  if (n.size() == 1 && raw.rhombohedral) {
    const double alpha_deg = rhombohedral_angle_deg(n[0]);
    return Cell{1, 1, 1, alpha_deg, alpha_deg, alpha_deg};
  }
  if (n.size() == 1 && one_ratio) return Cell{1, 1, n[0], 90, 90, standard_gamma(system)};
  if (one_ratio || system == System::cubic) return std::nullopt;
  if (n.size() == 2) return Cell{n[0], 1, n[1], 90, 90, 90};
  if (n.size() == 3) return Cell{n[0], 1, n[1], 90, n[2], 90};
  if (n.size() == 5) return Cell{n[0], 1, n[1], n[2], n[3], n[4]};
  return std::nullopt;
}

std::optional<Cell> cell_of(Context& context, const RawCrystal& raw, System system,
                            Location where) {
  if (!raw.cell.empty() && !raw.axial_ratio.empty()) {
    context.error(raw.cell_where, "'cell' and 'axial_ratio' both give the lattice");
    return std::nullopt;
  }
  if (!raw.cell.empty() || !raw.axial_ratio.empty()) {
    const auto cell =
        raw.cell.empty() ? cell_of_ratios(raw, system) : cell_of_lengths(raw, system);
    if (!cell)
      context.error(raw.cell_where,
                    std::string(raw.cell.empty()
                                    ? "'axial_ratio' is c/a (tetragonal, trigonal, hexagonal) or "
                                      "a/b, c/b[, beta or alpha, beta, gamma]"
                                    : "'cell' is a, b, c[, alpha, beta, gamma], or a, b, c, beta "
                                      "(monoclinic), or a, alpha (rhombohedral)") +
                        "; the system is " + name(system));
    return cell;
  }
  if (system == System::cubic) return Cell{};
  if (system == System::tetragonal || system == System::trigonal || system == System::hexagonal) {
    context.warning(where, "no 'axial_ratio' or 'cell': c/a = " + to_text(default_ratio) +
                               " is taken; angles between faces depend on it");
    if (!raw.rhombohedral)
      return Cell{1, 1, default_ratio, 90, 90, standard_gamma(system)};
    const double alpha_deg = rhombohedral_angle_deg(default_ratio);
    return Cell{1, 1, 1, alpha_deg, alpha_deg, alpha_deg};
  }
  context.error(where,
                std::string("the ") + name(system) + " system needs 'axial_ratio' or 'cell'");
  return std::nullopt;
}

}  // namespace

std::optional<PointGroup> group_of(Context& context, const RawCrystal& raw, Location where) {
  const auto system = system_of(context, raw);
  if (!raw.system.empty() && !system) return std::nullopt;
  std::string symbol = raw.point_group;
  if (symbol.empty() && system) symbol = holohedry(*system);
  if (symbol.empty() && raw.rhombohedral) symbol = holohedry(System::trigonal);
  if (symbol.empty()) {
    if (!raw.forms.empty() && std::any_of(raw.forms.begin(), raw.forms.end(),
                                          [](const RawForm& f) { return !f.single; })) {
      context.error(where, "forms need a 'point_group' (or 'system') to find their faces");
      return std::nullopt;
    }
    symbol = "1";
  }
  const auto group = find_point_group(symbol, raw.rhombohedral);
  if (!group) {
    const bool on_other_axes = find_point_group(symbol).has_value();
    context.error(raw.point_group_where.line ? raw.point_group_where : where,
                  on_other_axes ? "point group '" + symbol + "' has no rhombohedral axes"
                                : unknown("point group", symbol, "'crystal'",
                                          point_group_symbols()));
    return std::nullopt;
  }
  if (system && group->system != *system) {
    context.error(raw.point_group_where, "point group '" + group->symbol + "' is " +
                                             name(group->system) + ", not " + name(*system));
    return std::nullopt;
  }
  return group;
}

std::optional<Lattice> lattice_of(Context& context, const RawCrystal& raw,
                                  const PointGroup& group, Location where) {
  const auto cell = cell_of(context, raw, group.system, where);
  if (!cell) return std::nullopt;
  std::string why;
  const auto lattice = make_lattice(*cell, raw.rhombohedral, why);
  const Location place = raw.cell_where.line ? raw.cell_where : where;
  if (!lattice) {
    context.error(place, why);
  } else if (!fits(*lattice, group)) {
    context.error(place, "this cell has not the symmetry of point group " + group.symbol + ": " +
                             name(group.system) + " means " +
                             cell_rule(group.system, raw.rhombohedral));
    return std::nullopt;
  }
  return lattice;
}

}  // namespace nicol
