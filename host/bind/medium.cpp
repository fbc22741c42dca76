// interior { }: index, rotation, absorption of a medium, sampled at the scene's wavelengths.
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

IndexFormula index_of(const RawMedium& raw) {
  if (raw.index) return *raw.index;
  IndexFormula formula;
  formula.kind = IndexFormula::Kind::povray;
  formula.coefficients = {*raw.ior, raw.dispersion};
  return formula;
}

Samples rotation_samples(Context& context, const RawMedium& raw) {
  const std::string wrong = check(raw.rotation);
  if (!wrong.empty()) context.error(raw.rotation_where, "'rotation': " + wrong);
  if (!wrong.empty() || raw.rotation.kind == RotationFormula::Kind::none)
    return Samples(context.scene.lambda_nm.size(), 0.0);
  return sample(context, raw.rotation_where, "'rotation'",
                [&](double lambda_nm) { return rotation_deg_per_mm(raw.rotation, lambda_nm); });
}

// Negative values would make light out of nothing.
Samples not_negative(Context& context, const AbsorptionFormula& formula, Location where,
                     const std::string& what) {
  const std::string wrong = check(formula);
  if (!wrong.empty()) context.error(where, what + ": " + wrong);
  if (!wrong.empty() || formula.kind == AbsorptionFormula::Kind::none)
    return Samples(context.scene.lambda_nm.size(), 0.0);
  Samples values = sample(context, where, what,
                          [&](double lambda_nm) { return absorb_per_mm(formula, lambda_nm); });
  for (double value : values) {
    if (value >= 0) continue;
    context.error(where, what + " must not be negative");
    break;
  }
  return values;
}

Samples extinction_samples(Context& context, const RawMedium& raw) {
  const Samples per_mm =
      not_negative(context, raw.absorption, raw.absorption_where, "'absorption'");
  Samples k = not_negative(context, raw.extinction, raw.extinction_where, "'extinction'");
  for (std::size_t i = 0; i < k.size(); ++i)
    k[i] += extinction(per_mm[i], context.scene.lambda_nm[i]);
  return k;
}

Medium make_medium(Context& context, const RawMedium& raw, Location where) {
  Medium m;
  m.name = raw.name;
  m.where = where;
  m.source = raw.source;
  m.n.fill(sample_index(context, index_of(raw), raw.index_where, raw.index ? "'index'" : "'ior'"));
  m.rotation_deg_per_mm = rotation_samples(context, raw);
  m.k.fill(extinction_samples(context, raw));
  m.frame = {OpticFrame{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  return m;
}

// Media of equal values are one, so that many objects share few.
int index_of_equal(Context& context, Medium medium) {
  std::vector<double> key = medium.n[0];
  key.insert(key.end(), medium.k[0].begin(), medium.k[0].end());
  key.insert(key.end(), medium.rotation_deg_per_mm.begin(), medium.rotation_deg_per_mm.end());
  std::vector<Medium>& media = context.scene.media;
  const auto [at, is_new] = context.medium_of_values.emplace(std::move(key), media.size());
  if (is_new) media.push_back(std::move(medium));
  return at->second;
}

// A table or constant under the words of AbsorptionFormula.
void bind_absorption(Context& context, const char* name, const Args& args,
                     AbsorptionFormula& formula, Location& where) {
  formula = {};
  where = args.where;
  const std::size_t errors_before = context.error_count();
  read_block(context, *args.block, absorption_schema(context, name, formula));
  if (formula.kind == AbsorptionFormula::Kind::none && context.error_count() == errors_before)
    context.error(args.where, std::string("Expected 'constant' or 'table' in '") + name + "'");
}

void bind_rotation(Context& context, const Args& args, RawMedium& raw) {
  raw.rotation = {};
  raw.rotation_where = args.where;
  const std::size_t errors_before = context.error_count();
  read_block(context, *args.block, rotation_schema(context, raw.rotation));
  if (raw.rotation.kind == RotationFormula::Kind::none && context.error_count() == errors_before)
    context.error(args.where, "Expected a formula or table in 'rotation'");
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

Schema absorption_schema(Context& context, const char* name, AbsorptionFormula& formula) {
  using Kind = AbsorptionFormula::Kind;
  Context* c = &context;
  AbsorptionFormula* f = &formula;
  const auto set_table = [=](const Args& a) {
    f->kind = Kind::table;
    f->points = table_points(*c, a);
  };
  return {name,
          {{"constant", "n",
            [=](const Args& a) {
              f->kind = Kind::constant;
              f->per_mm = a.numbers[0];
            },
            "the same at every wavelength"},
           {"table", "{}", set_table, "nm, value, ..."},
           {"table", "N", set_table, "the same without braces"}},
          {}};
}

Schema interior_schema(Context& context, RawMedium& raw) {
  Context* c = &context;
  RawMedium* r = &raw;
  return {
      "interior",
      {{"ior", "n",
        [=](const Args& a) {
          r->ior = a.numbers[0];
          r->index.reset();
          r->index_where = a.where;
        },
        "refractive index, as POV-Ray's"},
       {"dispersion", "n", [=](const Args& a) { r->dispersion = a.numbers[0]; },
        "POV-Ray's n(violet)/n(red), with `ior`"},
       {"index", "{}",
        [=](const Args& a) {
          r->index_where = a.where;
          bind_index(*c, "index", *a.block, r->index.emplace());
        },
        "refractive index by formula or table"},
       {"rotation", "{}", [=](const Args& a) { bind_rotation(*c, a, *r); },
        "of the plane of polarization"},
       {"absorption", "{}",
        [=](const Args& a) {
          bind_absorption(*c, "absorption", a, r->absorption, r->absorption_where);
        },
        "of intensity, per mm"},
       {"extinction", "{}",
        [=](const Args& a) {
          bind_absorption(*c, "extinction", a, r->extinction, r->extinction_where);
        },
        "the coefficient k, in place of absorption or added to it"},
       {"source", "s", [=](const Args& a) { r->source = a.text; }, "where the numbers are from"},
       {"name", "s", [=](const Args& a) { r->name = a.text; }, "for messages"}},
      {{"%s of an interior is not rendered; 'absorption { }' dims by the path",
        true,
        {"fade_distance", "fade_power", "fade_color", "fade_colour"}},
       {"%s of an interior is not rendered", true, {"caustics", "media"}},
       {"%s is accepted: the scene's 'wavelengths' say what is computed",
        false,
        {"dispersion_samples"}}}};
}

std::optional<int> bind_medium(Context& context, const sdl::Block& interior) {
  const auto known = context.medium_of_block.find(&interior);
  if (known != context.medium_of_block.end()) return known->second;
  const std::size_t errors_before = context.error_count();
  RawMedium raw;
  read_block(context, interior, interior_schema(context, raw));
  std::optional<int> medium;
  if (context.error_count() != errors_before) {
    // Told already; what is half read is not sampled.
  } else if (raw.index || raw.ior) {
    medium = index_of_equal(context, make_medium(context, raw, interior.where));
  } else {
    context.error(interior.where, "this interior has no index: 'ior' or 'index { }' gives it one");
  }
  return context.medium_of_block[&interior] = medium;
}

void bind_surroundings(Context& context, const sdl::Block& block) {
  const sdl::Block* interior = nullptr;
  read_block(context, block,
             {"surroundings",
              {{"interior", "{}", [&](const Args& a) { interior = a.block; }, "the medium around"}},
              {}});
  RawMedium raw;
  raw.ior = 1;
  raw.name = "surroundings";
  if (interior) read_block(context, *interior, interior_schema(context, raw));
  context.scene.media[0] = make_medium(context, raw, block.where);
}

}  // namespace nicol
