// What plugins of shared objects give to a scene: numbers at its wavelengths, and solids.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/bind/context.hpp"
#include "host/plugins/source.hpp"

namespace nicol {

// All of these read a `plugin { "NAME" ... }` block; nullopt, and told with its place, after an error.
struct PluginIndex {
  std::vector<std::pair<double, double>> n, k;  // at the scene's wavelengths, nm
};
std::optional<PluginIndex> plugin_index(Context& context, const sdl::Block& block);
// Relative radiance likewise; at least two points.
std::optional<std::vector<std::pair<double, double>>> plugin_radiance(Context& context, const sdl::Block& block);
struct PluginSolid {
  plugins::SolidShape shape;
  std::string told;  // `solid "cube" of plugin /.../lab.so`
};
std::optional<PluginSolid> plugin_solid(Context& context, const sdl::Block& block);

}  // namespace nicol
