// Scene and geometry to the flat buffers of kernels/abi.h.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/features.hpp"
#include "host/fragments/scene_fragments.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

// What the kernels get. Scalars are double here; the render converts them to the device's real.
// `channels` are what the kernel traces one by one: wavelengths or source shapes, see channels.hpp.
struct PackedScene {
  std::vector<std::int32_t> ints;
  std::vector<double> reals;
  std::vector<double> tables;      // rows of `stride` values
  int channels = 0;
  int stride = 0;                  // channels rounded up to a multiple of the lanes
  int width = 0, height = 0;
  std::uint32_t features = 0;
  // mixing[c * wavelengths + w]: share of channel c in wavelength w; empty when channels are the wavelengths.
  std::vector<double> mixing;
  std::shared_ptr<const SceneFragments> fragments;   // of plugins; null: none
  KernelContents contents() const { return {features, fragments}; }
};

// Some of a scene's wavelengths, neighbours of one another.
struct WavelengthRange {
  std::size_t first = 0, count = 0;   // count 0: all
};

// `pixels_across`: of the picture whose pixels these are (0: `width`); their size decides what adds as amplitudes.
// `only`: these wavelengths are packed, each as it is in the whole scene; where channels are shared, all channels, with the shares of these.
PackedScene pack(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height,
                 int lanes, int pixels_across = 0, WavelengthRange only = {});

}  // namespace nicol
