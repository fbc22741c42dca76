// What the light of one pixel meets on its way from the camera: the kernels' own tree of paths, in double, written down.
#pragma once
#include <string>
#include <vector>

#include "host/pack.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

// A cell that paths went through.
struct MetCell {
  int cell = 0;              // index into Geometry::cells; 0: the surroundings
  int medium = 0;            // index into Scene::media
  int object = -1;           // index into Scene::objects, -1: none
  double weight = 0;         // of the heaviest path in it, relative to a full one
  int faces = 0;             // met from inside of it
};

struct PathRecord {
  std::vector<MetCell> cells;         // in the order they were first met
  std::vector<int> polarizers;        // indices into Scene::polarizers that paths passed, the camera's too; ascending
  std::vector<int> emissions;         // indices into Scene::emissions that paths ended at; ascending
  bool sky = false;                   // paths ended at the sky
  int faces = 0;                      // met by all paths together
  int deepest = 0;                    // faces along the longest path
  // Names as effects_of() has them (host/effects.hpp), of what changed the light on the way: in the order of that list.
  std::vector<std::string> effects;
};

// Of the ray through the middle of pixel (x, y) of a picture of width x height at one of the scene's wavelengths. `features` as the scene is rendered with.
PathRecord record_paths(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height, int x, int y,
                        std::size_t wavelength);

}  // namespace nicol
