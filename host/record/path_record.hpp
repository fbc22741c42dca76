// What the light of one pixel meets on its way from the camera: the kernels' own tree of paths, in double, written down.
// Test: tests/record.
#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/pack.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

// A cell that paths went through; the surroundings too where a path crosses the vanishing gap between two faces.
struct MetCell {
  int cell = 0;              // index into Geometry::cells; 0: the surroundings
  int medium = 0;            // index into Scene::media
  int object = -1;           // index into Scene::objects, -1: none
  double weight = 0;         // of the heaviest path in it; 1: as heavy as at the camera, behind the camera's polarizer
  int faces = 0;             // met from inside of it
};

struct PathRecord {
  std::vector<MetCell> cells;         // in the order they were first met
  std::vector<int> polarizers;        // indices into Scene::polarizers that paths passed, the camera's too; ascending
  std::vector<int> emissions;         // indices into Scene::emissions that paths ended at, where those shine; ascending
  bool sky = false;                   // paths ended at the sky
  int faces = 0;                      // met by all paths together; seams, and faces that shine towards the path, do not count
  int deepest = 0;                    // faces along the longest path, and polarizers on the way to them
  std::array<double, 4> stokes{};     // what all of it brings: S0..S3 per nm, in the picture's axes
  // Names as effects_of() has them (host/effects.hpp), of what changed the light on the way: in the order of that list.
  //   polarization        by a polarizer, by a crystal, or by a face met aslant
  //   coherence           a path carried both waves of a crystal as amplitudes
  //   conical_rays        a path met the binormal of a crystal, and the rays around the cone were traced
  //   calcite_polarizers  one was passed
  //   the others          by the media that paths went through (dispersion: by a polarizer passed too), as they are at the
  //                       scene's wavelengths
  std::vector<std::string> effects;
};

// Of the ray through the middle of pixel (x, y) of a picture of width x height, counted from its upper left corner, at one
// of the scene's wavelengths (index into Scene::lambda_nm). `features` as the scene is rendered with. It costs what the
// pixel costs in a picture; threads may record at once. Throws std::out_of_range for a pixel or wavelength that there is
// not, RecordStopped soon after `stop` is set, std::runtime_error that says why for a scene with fragments of plugins: only the
// device runs those.
struct RecordStopped : std::runtime_error {
  RecordStopped() : std::runtime_error("stopped") {}
};
PathRecord record_paths(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height, int x,
                        int y, std::size_t wavelength, const std::atomic<bool>* stop = nullptr);

}  // namespace nicol
