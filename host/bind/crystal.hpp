// What `crystal { }` and `gem { }` say, and the shapes that follow.
#pragma once
#include "host/bind/context.hpp"
#include "host/bind/parts.hpp"
#include "host/crystallography/gem.hpp"
#include "host/crystallography/habit.hpp"

namespace nicol {

struct RawForm {
  crystallography::Miller face;
  double distance = 1;
  bool single = false;  // `face`: without its equivalents
  bool four_indices = false;
  Location where;
};

struct RawFace {  // `face`: of a lattice, or Cartesian without one
  std::vector<double> direction;
  double distance = 0;
  Location where;
};

struct RawTwin {
  std::string law;
  std::optional<crystallography::TwinLaw> element;  // `axis`, `normal` or `plane`
  std::optional<double> angle_deg;
  std::optional<crystallography::Miller> contact;
  bool penetration = false, four_indices = false;
  double offset = 0, thickness = 0;
  int individuals = 2;
  Location where;
};

struct RawCrystal {
  std::vector<double> cell, axial_ratio;
  std::string system, point_group, cdl;
  bool rhombohedral = false;
  bool left = false, enantiomorph = false;
  std::vector<RawForm> forms;
  std::vector<RawFace> faces;
  std::optional<RawTwin> twin;
  double size = 1;
  Location cell_where, system_where, point_group_where, cdl_where, hand_where, size_where;

  bool has_lattice() const;
};

struct RawGem {
  crystallography::GemCut cut;
  struct Tier {
    std::optional<double> angle_deg, distance;
    std::vector<double> teeth;
    std::optional<Vec3> meet;
    std::string name;
    Location where;
  };
  std::vector<Tier> tiers;
  std::string file;
  std::optional<double> size;
  Location file_where, size_where;
};

// ---- crystal_words.cpp ----
void add_crystal_rules(Context& context, RawObject& raw, Schema& schema);
Schema cell_schema(Context& context, const char* name, std::vector<double>& numbers);
Schema twin_schema(Context& context, RawTwin& raw);

// ---- crystal_lattice.cpp ----
// nullopt, and told, if what the words say does not exist or does not go together.
std::optional<crystallography::PointGroup> group_of(Context& context, const RawCrystal& raw,
                                                    Location where);
std::optional<crystallography::Lattice> lattice_of(Context& context, const RawCrystal& raw,
                                                   const crystallography::PointGroup& group,
                                                   Location where);

// ---- crystal.cpp ----
// Fills facets, axes, individuals and crystal_frame of a crystal that has a lattice.
void finish_crystal(Context& context, RawObject& raw);
// Whether the facets of a crystal or gem enclose a solid; tells in which direction they do not.
bool check_closed(Context& context, const RawObject& raw);
// What stands out of the individual that this one grew through.
CsgShape protruding(const RawIndividual& individual, Location where);

// ---- gem.cpp ----
void add_gem_rules(Context& context, RawObject& raw, Schema& schema);
Schema gem_facet_schema(Context& context, RawGem::Tier& raw);
void finish_gem(Context& context, RawObject& raw);

}  // namespace nicol
