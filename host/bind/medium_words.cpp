// The words of interior { } and of the blocks in it.
#include "host/bind/parts.hpp"
#include "host/bind/plugin_values.hpp"

namespace nicol {

const std::array<const char*, principal::count> principal::names = {
    "ordinary", "extraordinary", "alpha", "beta", "gamma"};

namespace {

// coefficient: of the values k, which plugins give, too.
Schema one_absorption_schema(Context& context, const char* name, AbsorptionFormula& formula, bool coefficient) {
  using Kind = AbsorptionFormula::Kind;
  Context* c = &context;
  AbsorptionFormula* f = &formula;
  const auto set_table = [=](const Args& a) {
    f->kind = Kind::table;
    f->points = table_points(*c, a);
  };
  Schema schema{name,
          {{"constant", "n",
            [=](const Args& a) {
              f->kind = Kind::constant;
              f->per_mm = a.numbers[0];
            },
            "the same at every wavelength"},
           {"table", "{}", set_table, "nm, value, ..."},
           {"table", "N", set_table, "the same without braces"}},
          {}};
  if (coefficient)
    schema.rules.push_back({"plugin", "{}",
                            [=](const Args& a) {
                              const auto index = plugin_index(*c, *a.block);
                              if (!index || index->k.empty()) return;
                              f->kind = index->k.size() < 2 ? Kind::constant : Kind::table;
                              f->per_mm = index->k[0].second;
                              f->points = index->k;
                            },
                            "`\"NAME\" parameter value ...`: the k of a formula that a plugin brings"});
  return schema;
}

// Reads a block, and tells if nothing in it was a formula.
template <class Said>
void read_formula(Context& context, const Args& args, const Schema& schema, const char* expected,
                  const Said& said) {
  const std::size_t errors_before = context.error_count();
  read_block(context, *args.block, schema);
  if (!said() && context.error_count() == errors_before)
    context.error(args.where, std::string("Expected ") + expected + " in '" + schema.block + "'");
}

void bind_one_absorption(Context& context, const Args& args, const char* name,
                         AbsorptionFormula& formula, bool coefficient) {
  formula = {};
  read_formula(context, args, one_absorption_schema(context, name, formula, coefficient),
               "'constant' or 'table'",
               [&] { return formula.kind != AbsorptionFormula::Kind::none; });
}

void bind_absorption(Context& context, const Args& args, const char* name, RawAbsorption& raw) {
  raw = {};
  raw.where = args.where;
  read_formula(context, args, absorption_schema(context, name, raw),
               "'constant', 'table' or principal axes", [&] {
                 bool said = raw.every.kind != AbsorptionFormula::Kind::none;
                 for (const auto& formula : raw.along)
                   said = said || formula.kind != AbsorptionFormula::Kind::none;
                 return said;
               });
}

void bind_rotation(Context& context, const Args& args, RawMedium& raw) {
  raw.rotation = {};
  raw.rotation_where = args.where;
  read_formula(context, args, rotation_schema(context, raw.rotation), "a formula or table",
               [&] { return raw.rotation.kind != RotationFormula::Kind::none; });
}

void bind_gyration(Context& context, const Args& args, RawMedium& raw) {
  RawGyration& gyration = raw.gyration.emplace();
  gyration.where = args.where;
  read_formula(context, args, gyration_schema(context, gyration), "'tensor', 'table' or 'ratio'", [&] {
    return gyration.ratio || gyration.formula.kind != GyrationFormula::Kind::none;
  });
  if (gyration.ratio && gyration.formula.kind != GyrationFormula::Kind::none)
    context.error(args.where, "a gyration is a 'ratio' to the 'rotation' or a tensor, not both");
}

void set_tensor(Context& context, const Args& args, GyrationFormula& formula) {
  if (args.numbers.size() != formula.tensor.size()) {
    context.error(args.where, "'tensor' takes g11, g22, g33, g23, g13, g12: 6 numbers, " +
                                  std::to_string(args.numbers.size()) + " found instead");
    return;
  }
  std::copy(args.numbers.begin(), args.numbers.end(), formula.tensor.begin());
  formula.kind = formula.at_nm > 0 ? GyrationFormula::Kind::scaled : GyrationFormula::Kind::constant;
}

void set_tensor_table(Context& context, const Args& args, GyrationFormula& formula) {
  std::vector<double> numbers;
  read_block(context, *args.block,
             {"table", {{"", "N", [&](const Args& a) { numbers = a.numbers; }, "rows"}}, {}});
  constexpr std::size_t row = 7;
  if (numbers.empty() || numbers.size() % row) {
    context.error(args.where,
                  "a table of gyration is rows of 7 numbers (nm, g11, g22, g33, g23, g13, g12), " +
                      std::to_string(numbers.size()) + " numbers found instead");
    return;
  }
  formula.kind = GyrationFormula::Kind::table;
  for (auto& points : formula.points) points.clear();
  for (std::size_t i = 0; i < numbers.size(); i += row)
    for (std::size_t j = 0; j + 1 < row; ++j)
      formula.points[j].emplace_back(numbers[i], numbers[i + 1 + j]);
}

void set_range(Context& context, const Args& args, RawMedium& raw) {
  raw.range_nm = {args.numbers[0], args.numbers[1]};
  raw.range_where = args.where;
  if (!(raw.range_nm[0] > 0 && raw.range_nm[1] > raw.range_nm[0]))
    context.error(args.where, "'range' takes the shortest and the longest wavelength in nm");
}

void add_index_rules(Context* c, RawMedium* r, std::vector<Rule>& rules) {
  rules.push_back({"ior", "n",
                   [=](const Args& a) {
                     r->ior = a.numbers[0];
                     r->index.reset();
                     r->index_where = a.where;
                   },
                   "refractive index, as POV-Ray's"});
  rules.push_back({"dispersion", "n", [=](const Args& a) { r->dispersion = a.numbers[0]; },
                   "POV-Ray's n(violet)/n(red), with `ior`"});
  rules.push_back({"index", "{}",
                   [=](const Args& a) {
                     r->index_where = a.where;
                     bind_index(*c, "index", *a.block, r->index.emplace());
                   },
                   "refractive index by formula or table"});
  static const char* const helps[] = {
      "index across the optic axis of a uniaxial crystal, by the words of `index`",
      "index along its optic axis", "principal indices of a biaxial crystal, along the axes of `optic_frame`",
      "the second", "the third"};
  for (int axis = 0; axis < principal::count; ++axis)
    rules.push_back({principal::names[axis], "{}",
                     [=](const Args& a) {
                       r->index_along_where[axis] = a.where;
                       bind_index(*c, principal::names[axis], *a.block,
                                  r->index_along[axis].emplace());
                     },
                     helps[axis]});
}

void add_crystal_rules(Context* c, RawMedium* r, std::vector<Rule>& rules) {
  rules.push_back({"rotation", "{}", [=](const Args& a) { bind_rotation(*c, a, *r); },
                   "of the plane of polarization; in a uniaxial crystal along its optic axis"});
  rules.push_back({"gyration", "{}", [=](const Args& a) { bind_gyration(*c, a, *r); },
                   "optical activity in other directions"});
  rules.push_back({"left", "b", [=](const Args& a) { r->left = r->left != (a.numbers[0] != 0); },
                   "the mirror image of what is said: every activity changes its sign"});
  rules.push_back({"circular_waves", "b",
                   [=](const Args& a) {
                     r->circular_waves = a.numbers[0] != 0;
                     r->circular_where = a.where;
                   },
                   "an active isotropic medium's two circular waves, each with its own ray (off: one of the mean index)"});
  rules.push_back({"optic_frame", "{}",
                   [=](const Args& a) {
                     RawOpticFrame& frame = r->optic_frame.emplace();
                     frame.where = a.where;
                     read_block(*c, *a.block, optic_frame_schema(*c, frame));
                   },
                   "where alpha, beta, gamma lie (along the crystal's X, Y, Z)"});
  rules.push_back({"optic_axis", "v",
                   [=](const Args& a) {
                     r->optic_axis = a.vectors[0];
                     r->optic_axis_where = a.where;
                   },
                   "of a uniaxial crystal, in the object's axes (else the crystal's Z)"});
}

}  // namespace

Schema rotation_schema(Context& context, RotationFormula& formula) {
  using Kind = RotationFormula::Kind;
  Context* c = &context;
  RotationFormula* f = &formula;
  const auto set = [f](Kind kind) {
    return [f, kind](const Args& a) {
      f->kind = kind;
      f->coefficients = a.numbers;
    };
  };
  const auto set_table = [=](const Args& a) {
    f->kind = Kind::table;
    f->points = table_points(*c, a);
  };
  return {
      "rotation",
      {{"constant", "n", set(Kind::constant), "deg/mm, > 0 dextro: clockwise facing the source"},
       {"biot", "N", set(Kind::biot), "A[, B]: A/l^2 + B/l^4 (deg/mm, l in um)"},
       {"drude", "N", set(Kind::drude),
        "A1, L1, A2, L2, ...[, C]: C + sum A/(l^2 - L), L = lambda_i^2 in um^2"},
       {"chandrasekhar", "N", set(Kind::chandrasekhar),
        "k, lambda0: k l^2/(l^2 - lambda0^2)^2, lambda0 in um"},
       {"table", "{}", set_table, "nm, deg/mm, ..."},
       {"table", "N", set_table, "the same without braces"},
       {"scale", "n", [=](const Args& a) { f->scale *= a.numbers[0]; }, "factor"},
       {"left", "b", [=](const Args& a) { f->scale *= a.numbers[0] != 0 ? -1 : 1; },
        "the left-handed crystal: changes the sign"}},
      {}};
}

Schema absorption_schema(Context& context, const char* name, RawAbsorption& raw) {
  Context* c = &context;
  RawAbsorption* r = &raw;
  const bool coefficient = std::string_view(name) == "extinction";
  Schema schema = one_absorption_schema(context, name, raw.every, coefficient);
  for (int axis = 0; axis < principal::count; ++axis)
    schema.rules.push_back(
        {principal::names[axis], "{}",
         [=](const Args& a) { bind_one_absorption(*c, a, principal::names[axis], r->along[axis], coefficient); },
         "for light that vibrates along this axis"});
  return schema;
}

Schema gyration_schema(Context& context, RawGyration& raw) {
  Context* c = &context;
  RawGyration* r = &raw;
  GyrationFormula* f = &raw.formula;
  return {"gyration",
          {{"ratio", "n", [=](const Args& a) { r->ratio = a.numbers[0]; },
            "g11/g33 of a uniaxial crystal with a `rotation` (1)"},
           {"tensor", "N", [=](const Args& a) { set_tensor(*c, a, *f); },
            "g11, g22, g33, g23, g13, g12 on the principal axes: D = eps E + i g(s) s x E"},
           {"at", "n",
            [=](const Args& a) {
              f->at_nm = a.numbers[0];
              if (!(f->at_nm > 0)) c->error(a.where, "a wavelength in nm must be greater than 0");
              if (f->kind == GyrationFormula::Kind::constant) f->kind = GyrationFormula::Kind::scaled;
            },
            "nm where the tensor holds; elsewhere it goes like 1/wavelength"},
           {"table", "{}", [=](const Args& a) { set_tensor_table(*c, a, *f); },
            "nm, g11, g22, g33, g23, g13, g12, nm, ..."},
           {"scale", "n", [=](const Args& a) { f->scale *= a.numbers[0]; }, "factor"}},
          {}};
}

Schema interior_schema(Context& context, RawMedium& raw) {
  Context* c = &context;
  RawMedium* r = &raw;
  Schema schema;
  schema.block = "interior";
  add_index_rules(c, r, schema.rules);
  add_crystal_rules(c, r, schema.rules);
  const std::vector<Rule> rest = {
      {"absorption", "{}", [=](const Args& a) { bind_absorption(*c, a, "absorption", r->absorption); },
       "of intensity, per mm"},
      {"extinction", "{}", [=](const Args& a) { bind_absorption(*c, a, "extinction", r->extinction); },
       "the coefficient k, in place of absorption or added to it"},
      {"range", "nn", [=](const Args& a) { set_range(*c, a, *r); },
       "nm, nm: wavelengths that the numbers hold for"},
      {"source", "s", [=](const Args& a) { r->source = a.text; }, "where the numbers are from"},
      {"name", "s", [=](const Args& a) { r->name = a.text; }, "for messages"}};
  schema.rules.insert(schema.rules.end(), rest.begin(), rest.end());
  schema.ignored = {{"%s of an interior is not rendered; 'absorption { }' dims by the path",
                     true,
                     {"fade_distance", "fade_power", "fade_color", "fade_colour"}},
                    {"%s of an interior is not rendered", true, {"caustics", "media"}},
                    {"%s is accepted: the scene's 'wavelengths' say what is computed",
                     false,
                     {"dispersion_samples"}}};
  return schema;
}

}  // namespace nicol
