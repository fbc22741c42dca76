// What the kernels trace one by one. Usually each wavelength is a channel. Where nothing on the way of
// light depends on wavelength, one geometry serves all: then each shape of source spectrum is a channel,
// and the picture at every wavelength is a combination of those.
#pragma once
#include <vector>

#include "host/scene.hpp"

namespace nicol {

struct Channels {
  int count = 0;
  bool shared = false;                 // true: source shapes, false: wavelengths
  std::vector<double> mixing;          // shared: [channel * wavelengths + wavelength]
  std::vector<std::vector<double>> emission;  // shared: share of each channel in each emission
  std::vector<double> sky;             // shared: likewise in the sky
};

Channels choose_channels(const Scene& scene);

// Of the lights and the sky, per nm, over all wavelengths.
double brightest_radiance(const Scene& scene);

}  // namespace nicol
