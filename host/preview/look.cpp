#include "host/preview/look.hpp"

#include <algorithm>
#include <tuple>

#include "host/effects.hpp"
#include "host/features.hpp"

namespace nicol::preview {
namespace {

Scene without_effects(Scene scene, const std::set<std::string>& names) {
  for (const std::string& name : names) {
    const auto effects = effects_of(scene);   // one may bring another with it
    const bool there = std::any_of(effects.begin(), effects.end(), [&](const Effect& e) { return e.name == name; });
    if (there) scene = without_effect(scene, name);
  }
  return scene;
}

}  // namespace

bool Look::operator==(const Look& o) const {
  const auto all = [](const Look& l) {
    return std::tie(l.analyzer, l.analyzer_rad, l.polarizer_rad, l.without, l.width, l.height);
  };
  return navigation == o.navigation && all(*this) == all(o);
}

std::shared_ptr<const Prepared> prepare(const Scene& scene, const Geometry& geometry, const Look& look, int lanes) {
  auto made = std::make_shared<Prepared>();
  made->geometry = geometry;
  made->scene = navigate(without_effects(scene, look.without), made->geometry, look.navigation, look.analyzer,
                         look.analyzer_rad, look.polarizer_rad);
  made->features = decide_features(made->scene, made->geometry).mask;
  made->width = look.width;
  made->height = look.height;
  made->packed = pack(made->scene, made->geometry, made->features, look.width, look.height, lanes);
  return made;
}

}  // namespace nicol::preview
