// The whole scene: settings first, then everything in its order, expectations last.
#include "host/bind/bind.hpp"

#include <algorithm>

#include "host/bind/parts.hpp"

namespace nicol {

namespace {

struct RawScene {
  const sdl::Block* camera = nullptr;
  std::vector<const sdl::Block*> expectations;
  bool has_surroundings = false;
};

void bind_settings(Context& context, const sdl::Document& document) {
  RawSettings raw;
  for (const sdl::Item& item : document.items) {
    const sdl::Block* block = item.block();
    if (block && block->name == "global_settings")
      read_block(context, *block, settings_schema(context, raw));
  }
  finish_settings(context, raw);
}

void make_vacuum(Scene& scene) {
  Medium vacuum;
  vacuum.name = "vacuum";
  vacuum.n.fill(Samples(scene.lambda_nm.size(), 1.0));
  vacuum.k.fill(Samples(scene.lambda_nm.size(), 0.0));
  vacuum.rotation_deg_per_mm = vacuum.k[0];
  vacuum.frame = {OpticFrame{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  scene.media.push_back(vacuum);
  scene.sky = vacuum.k[0];
}

Schema scene_schema(Context& context, RawScene& raw) {
  Context* c = &context;
  RawScene* r = &raw;
  Schema schema;
  schema.block = "scene";
  schema.take_block = [=](const sdl::Block& block) {
    if (is_object(block.name)) bind_object(*c, block);
    return is_object(block.name);
  };
  schema.known_blocks = object_names();
  const auto sky = [=](const Args& a) { bind_sky(*c, *a.block); };
  schema.rules = {
      {"global_settings", "{}", [](const Args&) {}, "scale, wavelengths, depth"},
      {"camera", "{}",
       [=](const Args& a) {
         if (r->camera)
           c->warning(a.where, "More than one camera in scene. Ignoring previous camera(s).");
         r->camera = a.block;
       },
       "the eye"},
      {"background", "{}", sky, "the uniform sky (black)"},
      {"sky_sphere", "{}", sky, "the same, as POV-Ray writes it"},
      {"surroundings", "{}", [=](const Args& a) { bind_surroundings(*c, *a.block); },
       "the medium around everything (vacuum)"},
      {"expect", "{}", [=](const Args& a) { r->expectations.push_back(a.block); },
       "a number that the scene must give"},
      {"#default", "{}", [](const Args&) {}, "textures are not rendered"},
      {"default", "{}", [](const Args&) {}, "the same"},
      {"luminous", "{}",
       [=](const Args& a) {
         c->error(a.where, "'luminous' belongs inside an object: a polygon, a disc, a box");
       },
       "inside an object"}};
  schema.ignored = {
      {"%s is not rendered: light comes from luminous surfaces and the background",
       true,
       {"light_source"}},
      {"%s is not rendered", true, {"fog", "rainbow", "media", "photons", "radiosity"}},
      {"%s stands outside any object and does nothing",
       true,
       {"texture", "pigment", "finish", "normal", "material", "interior", "transform", "spectrum",
        "polarizer", "index", "rotation", "absorption", "color_map", "density"}}};
  return schema;
}

void tell_what_is_missing(Context& context, const sdl::Document& document) {
  const Scene& scene = context.scene;
  const Location where = document.items.empty() ? Location{} : document.items.front().where;
  if (scene.objects.empty()) context.warning(where, "No objects in scene.");
  const auto lit = [](const Samples& s) {
    return std::any_of(s.begin(), s.end(), [](double radiance) { return radiance > 0; });
  };
  const bool shines =
      lit(scene.sky) || std::any_of(scene.emissions.begin(), scene.emissions.end(),
                                    [&](const Emission& e) { return lit(e.radiance); });
  if (!shines)
    context.warning(where,
                    "nothing shines: a 'background { }' or a 'luminous { }' surface gives light");
}

void bind_all(Context& context, const sdl::Document& document) {
  bind_settings(context, document);
  make_vacuum(context.scene);
  RawScene raw;
  sdl::Block root;
  root.name = "scene";
  root.items = document.items;
  if (!root.items.empty()) root.where = root.items.front().where;
  read_block(context, root, scene_schema(context, raw));
  if (raw.camera) bind_camera(context, *raw.camera);
  else default_camera(context);
  for (const sdl::Block* block : raw.expectations) bind_expectation(context, *block);
  if (context.all_well()) tell_what_is_missing(context, document);
}

}  // namespace

Scene bind(const sdl::Document& document, const BindOptions& options,
           sdl::Diagnostics& diagnostics) {
  Scene scene;
  scene.path = options.path;
  Context context(scene, options, diagnostics);
  try {
    bind_all(context, document);
  } catch (const GiveUp&) {
  }
  return scene;
}

}  // namespace nicol
