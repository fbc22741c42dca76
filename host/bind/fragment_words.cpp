// plugin { } where a polarizer or a surface may stand, and surface { } of a solid.
#include "host/bind/parts.hpp"
#include "host/bind/plugin_words.hpp"
#include "host/fragments/manifest.hpp"

namespace nicol {

namespace {

const char* name_of(Fragment::Kind kind) {
  return kind == Fragment::Kind::element ? "element" : "surface";
}

// NAME.json, there or in a folder of that name, as include files are found.
std::shared_ptr<const Manifest> find_manifest(Context& context, const std::string& name,
                                              Location where) {
  std::string file = find_file(context, name + ".json");
  if (file.empty()) {
    const std::size_t slash = name.find_last_of('/');
    file = find_file(context, name + "/" + name.substr(slash == std::string::npos ? 0 : slash + 1) +
                                  ".json");
  }
  if (file.empty()) {
    context.error(where, "Cannot find plugin '" + name + "': neither '" + name + ".json' nor '" +
                             name + "/" + name + ".json' lies in the library folders.");
    return nullptr;
  }
  auto& known = context.manifests[file];
  if (known) return known;
  try {
    known = std::make_shared<Manifest>(read_manifest(file));
  } catch (const ManifestError& error) {
    context.error(where, "plugin '" + name + "': " + error.what());
    return nullptr;
  }
  if (context.options.files_read) context.options.files_read->push_back(known->fragment->file);
  return known;
}

// One name is one function in the kernels.
bool is_only_one(Context& context, const Fragment& fragment, Location where) {
  for (const FragmentUse& use : context.scene.fragments) {
    if (use.fragment->name != fragment.name || use.fragment->file == fragment.file) continue;
    context.error(where, "two plugins are called '" + fragment.name + "': '" + use.fragment->file +
                             "' and '" + fragment.file + "'");
    return false;
  }
  return true;
}

}  // namespace

std::optional<int> bind_fragment(Context& context, const sdl::Block& block, Fragment::Kind kind) {
  const auto name = plugin_name(context, block);
  if (!name) return std::nullopt;
  const auto manifest = find_manifest(context, *name, block.where);
  if (!manifest) return std::nullopt;
  if (manifest->fragment->kind != kind) {
    context.error(block.where, "plugin '" + *name + "' is a fragment of kind \"" +
                                   name_of(manifest->fragment->kind) + "\"; a \"" + name_of(kind) +
                                   "\" is expected here");
    return std::nullopt;
  }
  const auto values = read_parameters(context, block, *name, manifest->parameters);
  if (!values || !is_only_one(context, *manifest->fragment, block.where)) return std::nullopt;
  auto& uses = context.scene.fragments;
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i].fragment == manifest->fragment && uses[i].values == values->numbers)
      return static_cast<int>(i);
  FragmentUse use;
  use.fragment = manifest->fragment;
  use.values = values->numbers;
  use.where = block.where;
  uses.push_back(std::move(use));
  return static_cast<int>(uses.size()) - 1;
}

Schema surface_schema(Context&, RawSurface& raw) {
  RawSurface* r = &raw;
  return {"surface",
          {{"plugin", "{}", [=](const Args& a) { r->plugin = a.block; },
            "\"NAME\" parameter value ...: amplitudes of reflection and transmission in place of "
            "Fresnel's"},
           {"face", "v", [=](const Args& a) { r->face = a.vectors[0]; },
            "outward normal of the face that wears it; all faces without"}},
          {}};
}

std::optional<int> bind_surface(Context& context, const sdl::Block& block, RawSurface& raw) {
  read_block(context, block, surface_schema(context, raw));
  if (raw.plugin) return bind_fragment(context, *raw.plugin, Fragment::Kind::surface);
  context.error(block.end_where, "Expected 'plugin' in 'surface', } found instead");
  return std::nullopt;
}

}  // namespace nicol
