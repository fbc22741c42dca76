// The fragments of plugins that a scene names, as kernels hold them and as they are checked.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

// Media on both sides of a use, by wavelength: of a surface inside and outside of its solid, of an element the same twice.
struct FragmentMedia {
  std::vector<double> n1, k1, n2, k2;
};

struct SceneFragments {
  struct Use {
    std::shared_ptr<const Fragment> fragment;
    int index = 0;                      // of the fragment in the text
    std::vector<double> values;
    std::string place;                  // "scene.pov:12"
    std::vector<FragmentMedia> media;   // that light meets it in
  };
  std::string text;                     // what stands in place of kernels/scene_fragments.h
  std::vector<Use> uses;                // as Scene::fragments
  std::vector<double> lambda_nm;
};

// Null if nothing in the scene uses a fragment.
std::shared_ptr<const SceneFragments> fragments_of(const Scene& scene, const Geometry& geometry);

// The use that a face of an object wears, -1: none. `shape_face` as Face::shape_face.
int surface_of_face(const Object& object, int shape_face);

// Text in place of kernels/scene_fragments.h that holds these fragments: compiler messages name their own files and lines.
std::string kernel_text(const std::vector<std::shared_ptr<const Fragment>>& fragments);

// Tells where a surface cannot be: next to a crystal, in optical contact.
void refuse_surfaces(const Scene& scene, const Geometry& geometry, sdl::Diagnostics& diagnostics);

}  // namespace nicol
