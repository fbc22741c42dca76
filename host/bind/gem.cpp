// `gem { }`: a cut by index gear, angles and distances, in the scene or in a file of GemCad's.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/bind/crystal.hpp"
#include "host/bind/plugin_words.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

using namespace crystallography;

constexpr std::uintmax_t most_bytes = 4u << 20;
constexpr std::size_t most_facets = 10'000;

void read_file(Context& context, RawGem& raw) {
  std::error_code ignored;
  const std::string path = find_file(context, raw.file);
  if (path.empty()) return context.error(raw.file_where, "Cannot find file '" + raw.file + "'.");
  if (std::filesystem::path(path).extension() == ".gem")
    return context.error(raw.file_where,
                         "'.gem' is GemCad's binary format, which is not published; save the cut "
                         "as text ('.asc')");
  if (std::filesystem::file_size(path, ignored) > most_bytes)
    return context.error(raw.file_where, "'" + raw.file + "' is too large for a gem cut");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) return context.error(raw.file_where, "'" + raw.file + "' cannot be read");
  auto cut = read_gemcad(text.str());
  if (const GemCadError* error = std::get_if<GemCadError>(&cut))
    return context.error(raw.file_where, "'" + raw.file + "' line " + std::to_string(error->line) +
                                             ": " + error->message);
  raw.cut = std::move(std::get<GemCut>(cut));
}

void add_tier(Context& context, RawGem& raw, const RawGem::Tier& tier) {
  const bool flat = tier.angle_deg && *tier.angle_deg == 0;
  const bool placed_once = tier.distance.has_value() != tier.meet.has_value();
  const char* missing = !tier.angle_deg               ? "'angle'"
                        : tier.teeth.empty() && !flat ? "'index'"
                        : !placed_once                ? "'distance' or 'meet'"
                                                      : nullptr;
  if (missing) {
    context.error(tier.where, std::string("a facet has ") + missing +
                                  (tier.distance && tier.meet ? ", not both" : ""));
    return;
  }
  GemTier made{*tier.angle_deg, 0, tier.teeth, tier.name};
  if (made.teeth.empty()) made.teeth = {0};
  made.distance = tier.distance ? *tier.distance
                                : dot(facet_normal(made.angle_deg, made.teeth[0], raw.cut.gear),
                                      *tier.meet);
  raw.cut.tiers.push_back(std::move(made));
}

}  // namespace

Schema gem_facet_schema(Context& context, RawGem::Tier& raw) {
  Context* c = &context;
  RawGem::Tier* r = &raw;
  Schema schema;
  schema.block = "facet";
  schema.rules = {
      {"angle", "n",
       [=](const Args& a) {
         if (std::abs(a.numbers[0]) > 90)
           c->error(a.where,
                    "a facet's angle lies between -90 and 90 degrees from the girdle plane");
         r->angle_deg = a.numbers[0];
       },
       "from the girdle plane: crown > 0, pavilion < 0, girdle 90, table 0"},
      {"index", "N", [=](const Args& a) { r->teeth = a.numbers; }, "teeth of the gear"},
      {"distance", "n", [=](const Args& a) { r->distance = a.numbers[0]; }, "from the centre"},
      {"meet", "v", [=](const Args& a) { r->meet = a.vectors[0]; },
       "a point on the first facet, in place of the distance"},
      {"name", "s", [=](const Args& a) { r->name = a.text; }, "of the tier"}};
  return schema;
}

void add_gem_rules(Context& context, RawObject& raw, Schema& schema) {
  Context* c = &context;
  raw.gem = std::make_shared<RawGem>();
  RawGem* r = raw.gem.get();
  const auto flat = [=](double angle_deg) {
    return [=](const Args& a) {
      RawGem::Tier tier;
      tier.angle_deg = angle_deg;
      tier.distance = a.numbers[0];
      tier.where = a.where;
      r->tiers.push_back(tier);
    };
  };
  auto& rules = schema.rules;
  rules.push_back({"index_gear", "n",
                   [=](const Args& a) {
                     if (!(a.numbers[0] >= 1)) c->error(a.where, "a gear has at least one tooth");
                     else r->cut.gear = a.numbers[0];
                   },
                   "teeth of the gear (96)"});
  rules.push_back({"facet", "{}",
                   [=](const Args& a) {
                     RawGem::Tier tier;
                     tier.where = a.where;
                     read_block(*c, *a.block, gem_facet_schema(*c, tier));
                     r->tiers.push_back(std::move(tier));
                   },
                   "facets of one angle and distance; y is up"});
  rules.push_back({"table", "n", flat(0.0), "the table: its height above the centre"});
  rules.push_back({"culet", "n", flat(-0.0), "the culet: its depth below the centre"});
  rules.push_back({"gemcad", "s",
                   [=](const Args& a) {
                     r->file = a.text;
                     r->file_where = a.where;
                   },
                   "a cut from GemCad's text format (.asc)"});
  rules.push_back({"size", "n",
                   [=](const Args& a) {
                     if (!(a.numbers[0] > 0)) c->error(a.where, "the size is positive");
                     r->size = a.numbers[0];
                     r->size_where = a.where;
                   },
                   "width across the girdle's facets (as written)"});
}

void finish_gem(Context& context, RawObject& object) {
  RawGem& raw = *object.gem;
  const std::size_t errors_before = context.error_count();
  if (!raw.file.empty()) read_file(context, raw);
  for (const RawGem::Tier& tier : raw.tiers) add_tier(context, raw, tier);
  if (context.error_count() > errors_before) return;
  if (raw.cut.tiers.empty())
    return context.error(object.block->end_where, "Expected 'facet', } of 'gem' found instead");
  std::size_t count = 0;
  for (const GemTier& tier : raw.cut.tiers) count += tier.teeth.size();
  if (count > most_facets)
    return context.error(object.block->where,
                         "a gem with more than " + std::to_string(most_facets) + " facets");
  double scale = 1;
  if (raw.size) {
    const double width = girdle_width(raw.cut);
    if (!(width > 0))
      return context.error(raw.size_where, "'size' needs a girdle: facets of angle 90");
    scale = *raw.size / width;
  }
  object.facets = half_spaces(raw.cut);
  for (HalfSpace& face : object.facets) face.offset *= scale;
}

}  // namespace nicol
