#include "host/fragments/scene_fragments.hpp"

#include <algorithm>
#include <set>

#include "host/crystal_rows.hpp"
#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string calls(const std::vector<std::shared_ptr<const Fragment>>& fragments, Fragment::Kind kind, const std::string& run,
                  const std::string& in, const std::string& out) {
  std::string text = "FUNCTION void " + run + "(int fragment, PRIVATE const " + in + "* in, GLOBAL const scalar* parameter, PRIVATE " +
                     out + "* out) {\n  switch (fragment) {\n";
  for (std::size_t i = 0; i < fragments.size(); ++i)
    if (fragments[i]->kind == kind)
      text += "    case " + std::to_string(i) + ": " + fragments[i]->name + "(in, parameter, out); break;\n";
  return text + "    default: break;\n  }\n}\n";
}

// Uses that something in the scene has.
std::set<int> uses_in(const Scene& scene) {
  std::set<int> used;
  for (const Polarizer& polarizer : scene.polarizers)
    if (polarizer.kind == Polarizer::Kind::fragment) used.insert(polarizer.fragment);
  for (const Object& object : scene.objects)
    for (const FaceSurface& surface : object.face_surfaces) used.insert(surface.fragment);
  return used;
}

void add_media(const Medium& one, const Medium& two, std::vector<FragmentMedia>& list) {
  if (one.symmetry != Medium::Symmetry::isotropic || two.symmetry != Medium::Symmetry::isotropic) return;
  const bool known = std::any_of(list.begin(), list.end(), [&](const FragmentMedia& m) {
    return m.n1 == one.n[0] && m.k1 == one.k[0] && m.n2 == two.n[0] && m.k2 == two.k[0];
  });
  if (!known) list.push_back({one.n[0], one.k[0], two.n[0], two.k[0]});
}

// Elements: where sheets lie and the camera stands. Surfaces: on both sides of the faces that wear them.
std::vector<FragmentMedia> media_of(const Scene& scene, const Geometry& geometry, int use) {
  std::vector<FragmentMedia> media;
  if (scene.fragments[use].fragment->kind == Fragment::Kind::element) {
    std::set<int> around{0, geometry.cells[geometry.camera_cell].medium};
    for (const Sheet& sheet : geometry.sheets) around.insert(geometry.cells[sheet.cell].medium);
    for (const int medium : around) add_media(scene.media[medium], scene.media[medium], media);
    return media;
  }
  for (const Cell& cell : geometry.cells) {
    if (cell.object < 0) continue;
    const auto& worn = scene.objects[cell.object].face_surfaces;
    if (std::any_of(worn.begin(), worn.end(), [use](const FaceSurface& s) { return s.fragment == use; }))
      add_media(scene.media[cell.medium], scene.media[geometry.cells[cell.parent].medium], media);
  }
  return media;
}

}  // namespace

std::string kernel_text(const std::vector<std::shared_ptr<const Fragment>>& fragments) {
  std::string text =
      "#ifndef NICOL_SCENE_FRAGMENTS_H\n#define NICOL_SCENE_FRAGMENTS_H\n#include \"fragment.h\"\n#define FRAGMENTS_HERE 1\n";
  for (const auto& fragment : fragments) {
    const auto& names = fragment->parameters;
    for (std::size_t i = 0; i < names.size(); ++i) text += "#define P_" + names[i] + " parameter[" + std::to_string(i) + "]\n";
    text += "#line 1 " + quoted(fragment->file) + "\n" + fragment->text + "\n#line 1 \"scene_fragments.h\"\n";
    for (const std::string& name : names) text += "#undef P_" + name + "\n";
  }
  text += calls(fragments, Fragment::Kind::element, "run_element", "ElementIn", "ElementOut");
  text += calls(fragments, Fragment::Kind::surface, "run_surface", "SurfaceIn", "SurfaceOut");
  return text + "#endif\n";
}

int surface_of_face(const Object& object, int shape_face) {
  int use = -1;
  for (const FaceSurface& surface : object.face_surfaces)
    if (surface.face < 0 || surface.face == shape_face) use = surface.fragment;
  return use;
}

std::shared_ptr<const SceneFragments> fragments_of(const Scene& scene, const Geometry& geometry) {
  const std::set<int> used = uses_in(scene);
  if (used.empty()) return nullptr;
  auto made = std::make_shared<SceneFragments>();
  std::vector<std::shared_ptr<const Fragment>> fragments;
  for (std::size_t i = 0; i < scene.fragments.size(); ++i) {
    const FragmentUse& use = scene.fragments[i];
    SceneFragments::Use row;
    row.fragment = use.fragment;
    row.values = use.values;
    row.place = use.place.empty() ? "line " + std::to_string(use.where.line) : use.place;
    if (used.count(static_cast<int>(i))) {
      auto found = std::find(fragments.begin(), fragments.end(), use.fragment);
      if (found == fragments.end()) found = fragments.insert(fragments.end(), use.fragment);
      row.index = static_cast<int>(found - fragments.begin());
      row.media = media_of(scene, geometry, static_cast<int>(i));
    }
    made->uses.push_back(std::move(row));
  }
  made->text = kernel_text(fragments);
  made->lambda_nm = scene.lambda_nm;
  return made;
}

void refuse_surfaces(const Scene& scene, const Geometry& geometry, sdl::Diagnostics& diagnostics) {
  const auto is_crystal = [&](int medium) {
    return scene.settings.polarization && waves_of(scene.media[medium]) != WAVES_ISOTROPIC;
  };
  const auto worn_by = [&](const Cell& cell, int face) {
    return cell.object < 0 ? -1 : surface_of_face(scene.objects[cell.object], geometry.faces[face].shape_face);
  };
  for (const Cell& cell : geometry.cells) {
    if (cell.object < 0 || scene.objects[cell.object].face_surfaces.empty()) continue;
    const Object& object = scene.objects[cell.object];
    if (is_crystal(cell.medium) || is_crystal(geometry.cells[cell.parent].medium))
      diagnostics.error(object.where, "this " + object.kind + " wears a plugin's surface next to the crystal '" +
                                          scene.media[is_crystal(cell.medium) ? cell.medium : geometry.cells[cell.parent].medium].name +
                                          "': surfaces are for faces between isotropic media");
    for (int p = cell.first_patch; p < cell.first_patch + cell.patch_count; ++p)
      if (geometry.patches[p].behind == Patch::Behind::cell_contact && worn_by(cell, geometry.patches[p].face) >= 0)
        diagnostics.error(object.where, "a face of this " + object.kind +
                                            " that wears a plugin's surface is in optical contact with another solid: leave a gap "
                                            "('optical_contact off'), or name other faces ('face')");
  }
}

}  // namespace nicol
