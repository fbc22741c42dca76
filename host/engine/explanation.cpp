#include "host/engine/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace nicol::engine {
namespace {

std::string features_text(const Features& features, bool on) {
  std::size_t name_width = 0;
  for (const FeatureReason& row : features.rows) name_width = std::max(name_width, row.name.size());
  std::string text;
  for (const FeatureReason& row : features.rows)
    if (row.on == on)
      fmt::format_to(std::back_inserter(text), "  {:<{}}  {}\n  {:<{}}    {}\n", row.name, name_width, row.meaning, "", name_width,
                     row.reason);
  return text;
}

}  // namespace

std::string explanation(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  const Geometry& geometry = loaded.geometry;
  std::string text = fmt::format("{}: {} objects, {} cells, {} faces, {} contacts, {} sheets\n", scene.path, scene.objects.size(),
                                 geometry.cells.size(), geometry.faces.size(), geometry.patches.size(), geometry.sheets.size());
  text += fmt::format("{} wavelengths, {:g} to {:g} nm\n", scene.lambda_nm.size(), scene.lambda_nm.front(), scene.lambda_nm.back());
  text += fmt::format("called for (mask {:#07x}):\n", loaded.features.mask) + features_text(loaded.features, true);
  return text + "left out:\n" + features_text(loaded.features, false);
}

}  // namespace nicol::engine
