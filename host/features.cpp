#include "host/features.hpp"

#include <algorithm>

#include "host/channels.hpp"
#include "host/crystal_rows.hpp"
#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

enum : std::uint32_t {
#define FEATURE(name, bit, meaning) FEATURE_##name = 1u << bit,
#include "kernels/features.def"
#undef FEATURE
};

// Up to this many channels, lanes hold pixels: fewer lanes would idle than over wavelengths.
constexpr int few_channels = 4;

std::string at(const Location& where) { return " at line " + std::to_string(where.line); }

// Collects, for each bit, the first thing that calls for it and why it is left out otherwise.
class Decision {
 public:
  void call(std::uint32_t bit, const std::string& reason) {
    if (mask_ & bit) return;
    mask_ |= bit;
    reasons_.emplace_back(bit, reason);
  }
  void leave(std::uint32_t bit, const std::string& reason) { left_.emplace_back(bit, reason); }
  bool on(std::uint32_t bit) const { return (mask_ & bit) != 0; }
  std::uint32_t mask() const { return mask_; }
  std::string reason(std::uint32_t bit) const {
    for (const auto& [b, reason] : on(bit) ? reasons_ : left_)
      if (b == bit) return reason;
    return on(bit) ? "" : "nothing in the scene calls for it";
  }

 private:
  std::uint32_t mask_ = 0;
  std::vector<std::pair<std::uint32_t, std::string>> reasons_, left_;
};

bool any_nonzero(const Samples& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

void decide_light(const Scene& scene, Decision& d) {
  const bool solids = std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return o.medium.has_value(); });
  if (!scene.settings.polarization) {
    d.leave(FEATURE_polarization, "the scene says `polarization off`");
  } else if (solids) {
    for (const Object& object : scene.objects)
      if (object.medium) d.call(FEATURE_polarization, "faces of the " + object.kind + at(object.where) + " polarize");
  } else if (!scene.polarizers.empty()) {
    d.call(FEATURE_polarization, "polarizer" + at(scene.polarizers.front().where));
  } else {
    d.leave(FEATURE_polarization, "nothing in the scene polarizes");
  }
  const bool analyzer = scene.camera.polarizer && scene.polarizers[*scene.camera.polarizer].kind != Polarizer::Kind::fragment;
  if (d.on(FEATURE_polarization) && !analyzer)
    d.call(FEATURE_full_jones, scene.camera.polarizer ? "a plugin's element at the camera" : "no analyzer at the camera");
  if (!d.on(FEATURE_full_jones))
    d.leave(FEATURE_full_jones, scene.camera.polarizer ? "the analyzer leaves one row" : "no polarization");
  for (const Polarizer& polarizer : scene.polarizers) {
    if (polarizer.kind == Polarizer::Kind::fragment) continue;
    const bool calcite = polarizer.kind == Polarizer::Kind::calcite;
    d.call(calcite ? FEATURE_calcite_polarizer : FEATURE_ideal_polarizer,
           std::string(calcite ? "calcite" : "ideal") + " polarizer" + at(polarizer.where));
  }
  if (scene.camera.orthographic) d.call(FEATURE_orthographic, "camera" + at(scene.camera.where));
}

// Crystals are crystals only where light has a polarization.
bool is_crystal(const Scene& scene, const Medium& medium) {
  return scene.settings.polarization && waves_of(medium) != WAVES_ISOTROPIC;
}

void decide_crystal(const Scene& scene, const Medium& medium, const std::string& where, Decision& d) {
  if (waves_of(medium) == WAVES_ISOTROPIC) return;
  if (!scene.settings.polarization) {
    d.leave(FEATURE_birefringence, "no polarization: crystals are taken by their mean index");
    return;
  }
  d.call(FEATURE_birefringence, where);
  if (waves_of(medium) == WAVES_GENERAL) d.call(FEATURE_general_waves, where);
  if (medium.is_active() || medium.circular_waves) d.call(FEATURE_gyration, where);
  for (const Samples& k : medium.k)
    if (any_nonzero(k)) d.call(FEATURE_pleochroism, where);
  if (scene.settings.coherence) {
    d.call(FEATURE_coherent_waves, "the two waves of " + where);
  } else {
    d.leave(FEATURE_coherent_waves, "the scene says `coherence off`");
  }
  if (medium.symmetry != Medium::Symmetry::biaxial) return;
  if (scene.settings.conical_rays > 0) {
    d.call(FEATURE_conical_rays, std::to_string(scene.settings.conical_rays) + " `conical_rays`, " + where);
  } else {
    d.leave(FEATURE_conical_rays, "the scene asks for no `conical_rays`");
  }
}

void decide_media(const Scene& scene, Decision& d) {
  for (const Object& object : scene.objects) {
    if (!object.medium) continue;
    const Medium& medium = scene.media[*object.medium];
    const std::string where = "medium '" + medium.name + "' of the " + object.kind + at(object.where);
    decide_crystal(scene, medium, where, d);
    const bool absorbs = any_nonzero(medium.k[0]) || any_nonzero(medium.k[1]) || any_nonzero(medium.k[2]);
    if (absorbs && !is_crystal(scene, medium)) d.call(FEATURE_absorption, where);
    if (!any_nonzero(medium.rotation_deg_per_mm) || is_crystal(scene, medium)) continue;
    if (d.on(FEATURE_polarization)) {
      d.call(FEATURE_rotation, where);
    } else {
      d.leave(FEATURE_rotation, "no polarization to turn");
    }
  }
  if (any_nonzero(scene.media.front().k[0])) d.call(FEATURE_absorption, "the surroundings");
}

void decide_fragments(const Scene& scene, const SceneFragments* fragments, Decision& d) {
  const auto plugin = [&](int use) { return "plugin '" + scene.fragments[use].fragment->name + "'" + at(scene.fragments[use].where); };
  for (const Polarizer& polarizer : scene.polarizers)
    if (polarizer.kind == Polarizer::Kind::fragment) d.call(FEATURE_fragment_elements, plugin(polarizer.fragment));
  for (const Object& object : scene.objects)
    for (const FaceSurface& surface : object.face_surfaces)
      d.call(FEATURE_fragment_surfaces, plugin(surface.fragment) + " on the " + object.kind + at(object.where));
  if (!fragments) return;
  if (!d.on(FEATURE_fragment_elements)) d.leave(FEATURE_fragment_elements, "no polarizer is a plugin's");
  if (!d.on(FEATURE_fragment_surfaces)) d.leave(FEATURE_fragment_surfaces, "no face wears a plugin's surface");
}

void decide_shapes(const Scene& scene, const Geometry& geometry, Decision& d) {
  const auto where = [&](int object) { return scene.objects[object].kind + at(scene.objects[object].where); };
  for (const Sheet& sheet : geometry.sheets) {
    if (sheet.emission >= 0) d.call(FEATURE_luminous_sheets, where(sheet.object));
    if (sheet.polarizer >= 0) d.call(FEATURE_polarizing_sheets, where(sheet.object));
    if (sheet.has_disc) d.call(FEATURE_discs, where(sheet.object));
  }
  int solids = 0;
  for (std::size_t i = 1; i < geometry.cells.size(); ++i) {
    const Cell& cell = geometry.cells[i];
    if (++solids == 2) d.call(FEATURE_many_solids, where(cell.object));
    if (!cell.children.empty() || !cell.sheets.empty()) d.call(FEATURE_nested_solids, where(cell.object));
    for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
      if (geometry.faces[f].emission < 0) continue;
      d.call(FEATURE_luminous_faces, where(cell.object));
      d.call(FEATURE_light_contacts, where(cell.object));
    }
    for (int p = cell.first_patch; p < cell.first_patch + cell.patch_count; ++p) {
      const Patch& patch = geometry.patches[p];
      if (patch.has_disc) d.call(FEATURE_discs, where(cell.object));
      switch (patch.behind) {
        case Patch::Behind::light: d.call(FEATURE_light_contacts, where(cell.object) + " stands on a light"); break;
        case Patch::Behind::polarizer: d.call(FEATURE_polarizer_contacts, where(cell.object)); break;
        default: d.call(FEATURE_solid_contacts, where(cell.object)); break;
      }
    }
  }
  if (solids == 1) d.leave(FEATURE_many_solids, "one solid");
}

}  // namespace

Features decide_features(const Scene& scene, const Geometry& geometry) {
  Decision d;
  decide_light(scene, d);
  decide_media(scene, d);
  decide_shapes(scene, geometry, d);
  if (is_crystal(scene, scene.media[geometry.cells[geometry.camera_cell].medium]))
    d.call(FEATURE_camera_in_crystal, "camera" + at(scene.camera.where));
  Features out;
  out.fragments = fragments_of(scene, geometry);
  decide_fragments(scene, out.fragments.get(), d);
  const Channels channels = choose_channels(scene);
  if (scene.settings.error > 0 || scene.settings.sample_error > 0)
    d.call(FEATURE_path_signatures, scene.settings.error > 0 ? "an error is to be kept" : "a sampling error is to be kept");
  else
    d.leave(FEATURE_path_signatures, "every pixel gets as many samples");
  const std::string wavelengths = std::to_string(scene.lambda_nm.size());
  if (channels.count <= few_channels) {
    d.call(FEATURE_lanes_over_pixels, std::to_string(channels.count) + (channels.shared ? " shape(s) of source spectrum" : " wavelength(s)"));
  } else {
    d.leave(FEATURE_lanes_over_pixels, wavelengths + " wavelengths fill the lanes");
  }
  if (channels.shared)
    out.notes.push_back("nothing on the way of light depends on wavelength: one geometry serves all " + wavelengths + " wavelengths");
  if (scene.lambda_nm.size() == 1) out.notes.push_back("monochromatic: one wavelength is traced");
  out.mask = d.mask();
#define FEATURE(name, bit, meaning) \
  out.rows.push_back({#name, meaning, d.on(FEATURE_##name), d.reason(FEATURE_##name)});
#include "kernels/features.def"
#undef FEATURE
  return out;
}

}  // namespace nicol
