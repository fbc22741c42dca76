// Light: spectrum { }, the sky (background { } and sky_sphere { }), luminous { }.
#include "host/bind/parts.hpp"
#include "host/bind/plugin_values.hpp"

namespace nicol {

namespace {

void set_named(SpectrumFormula& f, SpectrumFormula::Kind kind, std::vector<double> numbers = {}) {
  f.kind = kind;
  f.numbers = std::move(numbers);
}

Schema pigment_schema(std::optional<SpectrumFormula>& colour, const char* name) {
  auto* out = &colour;
  return {name,
          {{"", "c",
            [=](const Args& a) {
              SpectrumFormula f;
              set_named(f, SpectrumFormula::Kind::rgb, {a.colour[0], a.colour[1], a.colour[2]});
              *out = f;
            },
            "a uniform colour"}},
          {}};
}

Samples sampled(Context& context, const SpectrumFormula& formula, Location where) {
  using Kind = SpectrumFormula::Kind;
  const bool black = formula.scale == 0 ||
                     (formula.kind == Kind::rgb && formula.numbers == std::vector<double>{0, 0, 0});
  if (black) return Samples(context.scene.lambda_nm.size(), 0.0);
  std::string reason;
  Samples radiance =
      sample_spectrum(formula, context.scene.lambda_nm, context.scene.weight_nm, reason);
  if (!reason.empty()) context.error(where, reason);
  radiance.resize(context.scene.lambda_nm.size());
  return radiance;
}

}  // namespace

Schema spectrum_schema(Context& context, SpectrumFormula& formula) {
  using Kind = SpectrumFormula::Kind;
  Context* c = &context;
  SpectrumFormula* f = &formula;
  const auto take_table = [=](const Args& a) {
    f->points = table_points(*c, a);
    f->kind = Kind::table;
  };
  Schema schema{
      "spectrum",
      {{"blackbody", "n", [=](const Args& a) { set_named(*f, Kind::blackbody, {a.numbers[0]}); },
        "K (Planck)"},
       {"line", "n", [=](const Args& a) { set_named(*f, Kind::line, {a.numbers[0]}); },
        "nm: all the power in the scene's nearest wavelength"},
       {"table", "{}", take_table, "nm, relative radiance, nm, ..."},
       {"table", "N", take_table, "the same without braces"},
       {"plugin", "{}",
        [=](const Args& a) {
          auto points = plugin_radiance(*c, *a.block);
          if (!points) return set_named(*f, Kind::e);
          f->kind = Kind::table;
          f->points = std::move(*points);
        },
        "`\"NAME\" parameter value ...`: a spectrum that a plugin brings"},
       {"", "c",
        [=](const Args& a) {
          set_named(*f, Kind::rgb, {a.colour[0], a.colour[1], a.colour[2]});
        },
        "`rgb <...>`: a smooth spectrum of that colour"},
       {"scale", "n",
        [=](const Args& a) {
          if (a.numbers[0] < 0) c->error(a.where, "the 'scale' of a spectrum must not be negative");
          else f->scale *= a.numbers[0];
        },
        "factor; a spectrum of scale 1 has Y = 1"}},
      {}};
  const std::vector<std::pair<const char*, Kind>> named = {
      {"d65", Kind::d65}, {"D65", Kind::d65}, {"a", Kind::a},           {"A", Kind::a},
      {"e", Kind::e},     {"E", Kind::e},     {"equal_energy", Kind::e}};
  for (const auto& [word, kind] : named)
    schema.rules.push_back({word, "", [f, k = kind](const Args&) { set_named(*f, k); },
                            kind == Kind::e ? "equal energy" : "CIE standard illuminant"});
  return schema;
}

Samples bind_spectrum(Context& context, const sdl::Block* block, Location where) {
  SpectrumFormula formula;
  if (block) read_block(context, *block, spectrum_schema(context, formula));
  return sampled(context, formula, block ? block->where : where);
}

Schema sky_schema(Context& context, const char* name, const sdl::Block*& spectrum,
                  std::optional<SpectrumFormula>& colour) {
  Context* c = &context;
  const sdl::Block** block = &spectrum;
  auto* out = &colour;
  Schema schema = pigment_schema(colour, name);
  schema.rules.push_back(
      {"spectrum", "{}", [=](const Args& a) { *block = a.block; }, "its spectrum"});
  schema.rules.push_back({"pigment", "{}",
                          [=](const Args& a) {
                            Schema pigment = pigment_schema(*out, "pigment");
                            pigment.lenient = "nicol's sky is uniform: %s is not rendered";
                            read_block(*c, *a.block, pigment);
                          },
                          "a pigment of one colour"});
  if (std::string(name) == "sky_sphere")
    schema.ignored = {
        {"a uniform sky needs no %s", false, {"rotate", "scale", "translate", "emission"}}};
  return schema;
}

void bind_sky(Context& context, const sdl::Block& block) {
  const sdl::Block* spectrum = nullptr;
  std::optional<SpectrumFormula> colour;
  const std::size_t errors_before = context.error_count();
  read_block(context, block, sky_schema(context, block.name.c_str(), spectrum, colour));
  if (context.scene.sky_where.line)
    context.warning(block.where, "More than one sky in scene. Ignoring the previous one.");
  if (!spectrum && !colour) {
    if (block.name == "sky_sphere")
      context.warning(block.where,
                      "a 'sky_sphere' of more than one color is not rendered: the sky stays black");
    else if (context.error_count() == errors_before)
      context.error(block.where, "Expected a color or 'spectrum' in '" + block.name + "'");
    return;
  }
  context.scene.sky = spectrum ? bind_spectrum(context, spectrum, block.where)
                               : sampled(context, *colour, block.where);
  context.scene.sky_where = block.where;
}

Schema luminous_schema(Context&, RawLuminous& raw) {
  RawLuminous* r = &raw;
  return {"luminous",
          {{"spectrum", "{}", [=](const Args& a) { r->spectrum = a.block; }, "its spectrum (d65)"},
           {"polarizer", "{}", [=](const Args& a) { r->polarizer = a.block; },
            "lies on the light without a gap"},
           {"one_sided", "b", [=](const Args& a) { r->one_sided = a.numbers[0] != 0; },
            "shines only to the outer side (polygon: where its corners run counter-clockwise)"},
           {"face", "v", [=](const Args& a) { r->face = a.vectors[0]; },
            "of a solid: the face whose outward normal is nearest; else all faces"}},
          {}};
}

}  // namespace nicol
