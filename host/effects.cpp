// Effects left out, each by the simplest medium, polarizer or setting that does without it.
//   dispersion            n(lambda) -> n(middle), axes likewise
//   rotatory_dispersion   rho(lambda) -> rho(middle); of crystals g(lambda) -> g(middle) n/n(middle) lambda/middle,
//                         for rho = pi g/(n lambda)
//   birefringence         n1 n2 n3 -> their mean, and so k; no gyration
//   pleochroism           k1 k2 k3 -> their mean
// Test: tests/accuracy/effects_test.cpp.
#include "host/effects.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "host/crystal_rows.hpp"
#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

bool any_nonzero(const Samples& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}
bool varies(const Samples& values) {
  return std::any_of(values.begin(), values.end(), [&](double v) { return v != values.front(); });
}
void freeze(Samples& values, std::size_t at) {
  if (values.empty()) return;
  const double value = values[at];
  std::fill(values.begin(), values.end(), value);
}

// The wavelength nearest to the middle of the scene's.
std::size_t middle(const Scene& scene) {
  const std::vector<double>& lambda_nm = scene.lambda_nm;
  const double centre_nm = (lambda_nm.front() + lambda_nm.back()) / 2;
  const auto nearer = [&](double a, double b) { return std::fabs(a - centre_nm) < std::fabs(b - centre_nm); };
  return static_cast<std::size_t>(std::min_element(lambda_nm.begin(), lambda_nm.end(), nearer) - lambda_nm.begin());
}

std::string middle_text(const Scene& scene) {
  std::ostringstream text;
  text << scene.lambda_nm[middle(scene)] << " nm";
  return text.str();
}

bool is_crystal(const Scene& scene, const Medium& medium) {
  return scene.settings.polarization && waves_of(medium) != WAVES_ISOTROPIC;
}
bool is_birefringent(const Scene& scene, const Medium& medium) {
  return scene.settings.polarization && medium.symmetry != Medium::Symmetry::isotropic;
}
bool turns_light(const Scene& scene, const Medium& medium) {
  return scene.settings.polarization && (any_nonzero(medium.rotation_deg_per_mm) || medium.is_active());
}
bool absorbs(const Scene&, const Medium& medium) {
  return std::any_of(medium.k.begin(), medium.k.end(), any_nonzero);
}
bool is_pleochroic(const Scene& scene, const Medium& medium) {
  return is_birefringent(scene, medium) && (medium.k[0] != medium.k[1] || medium.k[1] != medium.k[2]);
}
bool disperses(const Scene&, const Medium& medium) {
  return std::any_of(medium.n.begin(), medium.n.end(), varies) || medium.frame.size() > 1;
}
bool has_rotatory_dispersion(const Scene& scene, const Medium& medium) {
  return turns_light(scene, medium) && scene.lambda_nm.size() > 1 &&
         (medium.is_active() || varies(medium.rotation_deg_per_mm));
}
bool has_circular_waves(const Scene& scene, const Medium& medium) {
  return scene.settings.polarization && medium.circular_waves;
}
bool has_cone(const Scene& scene, const Medium& medium) {
  return is_crystal(scene, medium) && medium.symmetry == Medium::Symmetry::biaxial && scene.settings.conical_rays > 0;
}

// Whether a medium that light may meet is such.
bool any_medium(const Scene& scene, bool (*is)(const Scene&, const Medium&)) {
  std::set<int> met{0};
  for (const Object& object : scene.objects)
    if (object.medium) met.insert(*object.medium);
  return std::any_of(met.begin(), met.end(),
                     [&](int m) { return is(scene, scene.media[static_cast<std::size_t>(m)]); });
}

bool is_calcite(const Polarizer& polarizer) { return polarizer.kind == Polarizer::Kind::calcite; }
bool polarizer_disperses(const Polarizer& polarizer) {
  return is_calcite(polarizer) && (varies(polarizer.n_o) || varies(polarizer.n_e));
}
bool any_polarizer(const Scene& scene, bool (*is)(const Polarizer&)) {
  return std::any_of(scene.polarizers.begin(), scene.polarizers.end(), is);
}

bool polarizes(const Scene& scene) {
  return scene.settings.polarization &&
         (!scene.polarizers.empty() || std::any_of(scene.objects.begin(), scene.objects.end(),
                                                   [](const Object& object) { return object.medium.has_value(); }));
}

template <class Change>
Scene with_media(Scene scene, const Change& change) {
  for (Medium& medium : scene.media) change(medium);
  return scene;
}

Scene only_intensities(Scene scene) {
  scene.settings.polarization = false;
  return scene;
}

Scene without_coherence(Scene scene) {
  scene.settings.coherence = false;
  return scene;
}

Scene without_dispersion(Scene scene) {
  const std::size_t at = middle(scene);
  for (Polarizer& polarizer : scene.polarizers) {
    freeze(polarizer.n_o, at);
    freeze(polarizer.n_e, at);
  }
  return with_media(std::move(scene), [at](Medium& medium) {
    for (Samples& n : medium.n) freeze(n, at);
    medium.frame = {medium.frame_at(at)};
  });
}

Scene without_rotatory_dispersion(Scene scene) {
  const std::size_t at = middle(scene);
  const std::vector<double> lambda_nm = scene.lambda_nm;
  return with_media(std::move(scene), [&](Medium& medium) {
    freeze(medium.rotation_deg_per_mm, at);
    // The index along an optic axis: n_o, or the middle one.
    const Samples& n = medium.symmetry == Medium::Symmetry::biaxial ? medium.n[1] : medium.n[0];
    for (Samples& g : medium.gyration) {
      freeze(g, at);
      for (std::size_t i = 0; i < g.size(); ++i) g[i] *= n[i] / n[at] * lambda_nm[i] / lambda_nm[at];
    }
  });
}

Scene without_rotation(Scene scene) {
  return with_media(std::move(scene), [](Medium& medium) {
    std::fill(medium.rotation_deg_per_mm.begin(), medium.rotation_deg_per_mm.end(), 0);
    medium.circular_waves = false;
    medium.gyration = {};
  });
}

Scene without_circular_waves(Scene scene) {
  return with_media(std::move(scene), [](Medium& medium) { medium.circular_waves = false; });
}

Scene without_absorption(Scene scene) {
  return with_media(std::move(scene), [](Medium& medium) {
    for (Samples& k : medium.k) std::fill(k.begin(), k.end(), 0);
  });
}

Scene without_pleochroism(Scene scene) {
  return with_media(std::move(scene), [](Medium& medium) {
    for (std::size_t i = 0; i < medium.k[0].size(); ++i) {
      const double mean = (medium.k[0][i] + medium.k[1][i] + medium.k[2][i]) / 3;
      for (Samples& k : medium.k) k[i] = mean;
    }
  });
}

Scene without_birefringence(Scene scene) {
  return with_media(std::move(scene), [](Medium& medium) {
    if (medium.symmetry != Medium::Symmetry::isotropic) medium = without_polarization(medium);
  });
}

Scene without_conical_rays(Scene scene) {
  scene.settings.conical_rays = 0;
  return scene;
}

Scene without_calcite_polarizers(Scene scene) {
  for (Polarizer& polarizer : scene.polarizers)
    if (polarizer.kind == Polarizer::Kind::calcite) polarizer.kind = Polarizer::Kind::ideal;
  return scene;
}

bool is_element(const Polarizer& polarizer) { return polarizer.kind == Polarizer::Kind::fragment; }
bool names_fragments(const Scene& scene) {
  return any_polarizer(scene, is_element) ||
         std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return !o.face_surfaces.empty(); });
}
Scene without_fragments(Scene scene) {
  for (Polarizer& polarizer : scene.polarizers)
    if (is_element(polarizer)) polarizer.kind = Polarizer::Kind::ideal;
  for (Object& object : scene.objects) object.face_surfaces.clear();
  return scene;
}

struct Removal {
  Effect effect;
  bool there;
  Scene (*remove)(Scene);
};

std::vector<Removal> removals(const Scene& scene) {
  const bool crystals = any_medium(scene, is_crystal);
  const std::string at = " as at " + middle_text(scene);
  return {
      {{"polarization", "intensities only"}, polarizes(scene), only_intensities},
      {{"coherence", "the two waves of a crystal add as intensities"}, crystals && scene.settings.coherence,
       without_coherence},
      {{"dispersion", "refractive indices" + at}, any_medium(scene, disperses) || any_polarizer(scene, polarizer_disperses),
       without_dispersion},
      {{"rotation", "no optical activity"}, any_medium(scene, turns_light), without_rotation},
      {{"rotatory_dispersion", "optical rotation" + at}, any_medium(scene, has_rotatory_dispersion),
       without_rotatory_dispersion},
      {{"circular_waves", "one ray of the mean index"}, any_medium(scene, has_circular_waves), without_circular_waves},
      {{"absorption", "clear media"}, any_medium(scene, absorbs), without_absorption},
      {{"pleochroism", "the mean absorption for all directions"}, any_medium(scene, is_pleochroic),
       without_pleochroism},
      {{"birefringence", "isotropic media of the mean index"}, any_medium(scene, is_birefringent),
       without_birefringence},
      {{"conical_rays", "one ray at a binormal"}, any_medium(scene, has_cone), without_conical_rays},
      {{"calcite_polarizers", "ideal polarizers"}, any_polarizer(scene, is_calcite), without_calcite_polarizers},
      {{"fragments", "ideal polarizers and bare faces in place of plugins'"}, names_fragments(scene), without_fragments},
  };
}

}  // namespace

std::vector<Effect> effects_of(const Scene& scene) {
  std::vector<Effect> effects;
  for (const Removal& removal : removals(scene))
    if (removal.there) effects.push_back(removal.effect);
  return effects;
}

std::vector<std::string> effects_of_medium(const Scene& scene, const Medium& medium) {
  std::vector<std::string> names;
  const auto call = [&](const char* name, bool (*is)(const Scene&, const Medium&)) {
    if (is(scene, medium)) names.push_back(name);
  };
  call("polarization", is_crystal);
  call("dispersion", disperses);
  call("rotation", turns_light);
  call("rotatory_dispersion", has_rotatory_dispersion);
  call("circular_waves", has_circular_waves);
  call("absorption", absorbs);
  call("pleochroism", is_pleochroic);
  call("birefringence", is_birefringent);
  return names;
}

std::vector<std::string> effects_of_polarizer(const Scene& scene, const Polarizer& polarizer) {
  std::vector<std::string> names;
  if (scene.settings.polarization) names.push_back("polarization");
  if (polarizer_disperses(polarizer)) names.push_back("dispersion");
  if (is_calcite(polarizer)) names.push_back("calcite_polarizers");
  if (is_element(polarizer)) names.push_back("fragments");
  return names;
}

const std::vector<std::string>& effect_names() {
  static const std::vector<std::string> names = [] {
    Scene scene;
    scene.lambda_nm = {580};
    scene.media.resize(1);
    std::vector<std::string> all;
    for (const Removal& removal : removals(scene)) all.push_back(removal.effect.name);
    return all;
  }();
  return names;
}

Scene without_effect(const Scene& scene, const std::string& name) {
  for (const Removal& removal : removals(scene))
    if (removal.there && removal.effect.name == name) return removal.remove(scene);
  throw std::invalid_argument("the scene has no effect '" + name + "' that could be left out");
}

}  // namespace nicol
