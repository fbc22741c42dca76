// See plugin_values.hpp.
#include "host/bind/plugin_values.hpp"

#include "host/bind/plugin_words.hpp"

namespace nicol {

namespace {

// Finds the entry by its name and reads its parameters; calls use(entry, values). False, and told, after an error.
template <class Find, class Use>
bool with_plugin(Context& context, const sdl::Block& block, const Find& find, const Use& use) {
  const auto name = plugin_name(context, block);
  if (!name) return false;
  if (!context.options.plugins) {
    context.error(block.where, "plugin '" + *name + "': no plugins can be loaded here");
    return false;
  }
  try {
    const auto& entry = find(*context.options.plugins, *name);
    const auto values = read_parameters(context, block, *name, entry.parameters);
    if (values) use(entry, *values);
    return values.has_value();
  } catch (const plugins::PluginError& error) {
    context.error(block.where, error.what());
    return false;
  }
}

}  // namespace

std::optional<PluginIndex> plugin_index(Context& context, const sdl::Block& block) {
  PluginIndex index;
  const bool found = with_plugin(
      context, block, [](auto& source, const std::string& name) -> auto& { return source.dispersion(name); },
      [&](const plugins::Dispersion& formula, const plugins::Values& values) {
        for (double lambda_nm : context.scene.lambda_nm) {
          const auto at = formula.at(values, lambda_nm);
          index.n.emplace_back(lambda_nm, at.n);
          index.k.emplace_back(lambda_nm, at.k);
        }
      });
  if (!found) return std::nullopt;
  return index;
}

std::optional<std::vector<std::pair<double, double>>> plugin_radiance(Context& context, const sdl::Block& block) {
  std::vector<std::pair<double, double>> points;
  const bool found = with_plugin(
      context, block, [](auto& source, const std::string& name) -> auto& { return source.spectrum(name); },
      [&](const plugins::Spectrum& spectrum, const plugins::Values& values) {
        for (double lambda_nm : context.scene.lambda_nm) points.emplace_back(lambda_nm, spectrum.radiance(values, lambda_nm));
        if (points.size() == 1) points.emplace_back(points[0].first + 1, points[0].second);
      });
  if (!found) return std::nullopt;
  return points;
}

std::optional<PluginSolid> plugin_solid(Context& context, const sdl::Block& block) {
  std::optional<PluginSolid> made;
  with_plugin(
      context, block, [](auto& source, const std::string& name) -> auto& { return source.solid(name); },
      [&](const plugins::Solid& solid, const plugins::Values& values) {
        auto shape = solid.make(values, [&](const std::string& file) { return find_file(context, file); });
        made = PluginSolid{std::move(shape), "solid \"" + solid.name + "\" of plugin " + solid.file};
      });
  return made;
}

}  // namespace nicol
