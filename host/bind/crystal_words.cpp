// The words of `crystal { }`: lattice, symmetry, forms, twins.
#include <cmath>

#include "host/bind/crystal.hpp"

namespace nicol {

namespace {

using crystallography::Miller;
using crystallography::TwinLaw;

// Indices as a vector, or a complaint.
std::optional<Miller> face_of(Context& context, Location where, const std::vector<double>& list) {
  std::string why;
  const auto face = crystallography::face_of_indices(list, why);
  if (!face) context.error(where, why);
  return face;
}

bool is_positive(Context& context, Location where, const char* what, double number) {
  if (number > 0) return true;
  context.error(where, std::string(what) + " is positive, " + to_text(number) + " found instead");
  return false;
}

void read_form(Context& context, const sdl::Block& block, RawForm& raw) {
  std::vector<double> numbers;
  bool has_face = false;
  for (const sdl::Item& item : block.items) {
    const sdl::Vector* vector = item.vector();
    if (item.number()) {
      numbers.push_back(*item.number());
    } else if (vector && !has_face && numbers.empty()) {
      if (const auto face = face_of(context, item.where, {vector->v.begin(),
                                                          vector->v.begin() + vector->size}))
        raw.face = *face;
      raw.four_indices = vector->size == 4;
      has_face = true;
    } else if (item.string() && !has_face && numbers.empty()) {
      if (const auto list = crystallography::parse_indices(*item.string())) {
        if (const auto face = face_of(context, item.where, *list)) raw.face = *face;
        raw.four_indices = list->size() == 4;
      } else {
        context.error(item.where, "expected indices, as \"10-11\" or \"1 0 -1 1\"");
      }
      has_face = true;
    } else {
      context.error(item.where, "Expected 'numeric expression', " + describe(item) +
                                    " found instead; a form is <h, k, l>, distance");
      return;
    }
  }
  if (!has_face) {
    const std::size_t indices = numbers.size() == 5 ? 4 : 3;
    if (numbers.size() != 3 && numbers.size() != 5) {
      context.error(block.where, numbers.size() == 4
                                     ? "four numbers may be h, k, l, distance or h, k, i, l: write "
                                       "<h, k, l>, distance or <h, k, i, l>, distance"
                                     : "a form is <h, k, l>, distance or h, k, i, l, distance");
      return;
    }
    const std::vector<double> list(numbers.begin(), numbers.begin() + indices);
    if (const auto face = face_of(context, block.where, list)) raw.face = *face;
    raw.four_indices = indices == 4;
    numbers.erase(numbers.begin(), numbers.begin() + indices);
  }
  if (numbers.size() > 1)
    context.error(block.where, "a form has one distance, " + std::to_string(numbers.size()) +
                                   " found instead");
  if (!numbers.empty() && is_positive(context, block.where, "the distance of a form", numbers[0]))
    raw.distance = numbers[0];
}

void add_lattice_rules(Context* c, RawCrystal* r, Schema& schema) {
  const auto numbers_of = [c](std::vector<double>* to, Location* where) {
    return [=](const Args& a) {
      *where = a.where;
      to->clear();
      read_block(*c, *a.block, cell_schema(*c, a.block->name.c_str(), *to));
    };
  };
  auto& rules = schema.rules;
  rules.push_back({"cell", "{}", numbers_of(&r->cell, &r->cell_where),
                   "the lattice: a, b, c[, alpha, beta, gamma]; a, b, c, beta; a, alpha"});
  rules.push_back({"axial_ratio", "{}", numbers_of(&r->axial_ratio, &r->cell_where),
                   "the lattice: c/a, or a/b, c/b[, beta or alpha, beta, gamma]"});
  rules.push_back({"system", "s",
                   [=](const Args& a) {
                     r->system = a.text;
                     r->system_where = a.where;
                   },
                   "crystal system"});
  rules.push_back({"point_group", "s",
                   [=](const Args& a) {
                     r->point_group = a.text;
                     r->point_group_where = a.where;
                   },
                   "Hermann-Mauguin symbol, as \"32\", \"2/m\", \"31m\" (the system's highest)"});
  rules.push_back({"rhombohedral", "", [=](const Args&) { r->rhombohedral = true; },
                   "cell and indices are on rhombohedral axes"});
  rules.push_back({"cdl", "s",
                   [=](const Args& a) {
                     r->cdl = a.text;
                     r->cdl_where = a.where;
                   },
                   "Crystal Description Language: system[point group]:{form}@distance + ..."});
}

void add_habit_rules(Context* c, RawCrystal* r, Schema& schema) {
  auto& rules = schema.rules;
  rules.push_back({"form", "{}",
                   [=](const Args& a) {
                     RawForm form;
                     form.where = a.where;
                     const std::size_t errors_before = c->error_count();
                     read_form(*c, *a.block, form);
                     if (c->error_count() == errors_before) r->forms.push_back(form);
                   },
                   "a face and all its equivalents: <h,k,l>[, distance], h,k,i,l, distance"});
  rules.push_back({"face", "tn",
                   [=](const Args& a) { r->faces.push_back({a.tuple, a.numbers[0], a.where}); },
                   "one face of the lattice: <h,k,l>, distance; without a lattice as `facet`"});
  rules.push_back({"size", "n",
                   [=](const Args& a) {
                     if (is_positive(*c, a.where, "the size", a.numbers[0])) r->size = a.numbers[0];
                     r->size_where = a.where;
                   },
                   "distance from the centre of a face with distance 1 (1)"});
  const auto hand = [=](bool* which) {
    return [=](const Args& a) {
      *which = true;
      r->hand_where = a.where;
    };
  };
  rules.push_back({"left", "", hand(&r->left), "forms of the mirror image: (hkl) is (-h -k -l)"});
  rules.push_back({"enantiomorph", "", hand(&r->enantiomorph),
                   "the same, and the medium of the other hand"});
  rules.push_back({"twin", "{}",
                   [=](const Args& a) {
                     r->twin.emplace();
                     r->twin->where = a.where;
                     read_block(*c, *a.block, twin_schema(*c, *r->twin));
                   },
                   "two individuals in contact"});
}

}  // namespace

bool RawCrystal::has_lattice() const {
  return !cell.empty() || !axial_ratio.empty() || !system.empty() || !point_group.empty() ||
         !cdl.empty() || !forms.empty() || twin || rhombohedral;
}

Schema cell_schema(Context&, const char* name, std::vector<double>& numbers) {
  std::vector<double>* to = &numbers;
  return {name, {{"", "N", [=](const Args& a) { *to = a.numbers; }, "lengths, then degrees"}}, {}};
}

Schema twin_schema(Context& context, RawTwin& raw) {
  Context* c = &context;
  RawTwin* r = &raw;
  const auto element = [=](TwinLaw::Operation operation) {
    return [=](const Args& a) {
      std::vector<double> list = a.tuple;
      if (operation == TwinLaw::Operation::rotation_about_edge && list.size() != 3)
        return c->error(a.where, "an axis is <u, v, w> along the edges of the cell");
      r->four_indices |= list.size() == 4;
      if (const auto face = face_of(*c, a.where, list))
        r->element = TwinLaw{operation, *face, 180, std::nullopt, false};
    };
  };
  Schema schema;
  schema.block = "twin";
  schema.rules = {
      {"law", "s", [=](const Args& a) { r->law = a.text; }, "a law by its name"},
      {"axis", "t", element(TwinLaw::Operation::rotation_about_edge),
       "the second individual is turned about <u,v,w>"},
      {"normal", "t", element(TwinLaw::Operation::rotation_about_normal),
       "the same about the normal of <h,k,l>"},
      {"plane", "t", element(TwinLaw::Operation::reflection),
       "the second individual is mirrored in <h,k,l>"},
      {"angle", "n", [=](const Args& a) { r->angle_deg = a.numbers[0]; }, "of the turn (180)"},
      {"contact", "t",
       [=](const Args& a) {
         r->four_indices |= a.tuple.size() == 4;
         if (const auto face = face_of(*c, a.where, a.tuple)) r->contact = *face;
       },
       "the plane in common: <h,k,l>"},
      {"offset", "n", [=](const Args& a) { r->offset = a.numbers[0]; },
       "of that plane from the centre, as distances of faces (0)"},
      {"individuals", "n",
       [=](const Args& a) {
         const double count = a.numbers[0];
         if (count != std::floor(count) || count < 2 || count > 1000)
           c->error(a.where, "a twin has 2 to 1000 individuals");
         else
           r->individuals = static_cast<int>(count);
       },
       "in turn, between parallel planes (2)"},
      {"thickness", "n",
       [=](const Args& a) {
         if (is_positive(*c, a.where, "the thickness", a.numbers[0])) r->thickness = a.numbers[0];
       },
       "of the inner ones, as distances of faces"},
      {"penetration", "", [=](const Args&) { r->penetration = true; },
       "individuals grow through each other"}};
  return schema;
}

void add_crystal_rules(Context& context, RawObject& raw, Schema& schema) {
  Context* c = &context;
  RawObject* object = &raw;
  raw.crystal = std::make_shared<RawCrystal>();
  schema.rules.push_back({"facet", "vn",
                          [=](const Args& a) {
                            if (const auto h = half_space(*c, a.where, a.vectors[0], a.numbers[0]))
                              object->facets.push_back(*h);
                          },
                          "outward normal (right-handed Cartesian axes), distance along it"});
  add_lattice_rules(c, raw.crystal.get(), schema);
  add_habit_rules(c, raw.crystal.get(), schema);
}

}  // namespace nicol
