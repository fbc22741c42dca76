// The cheapest settings that keep a picture to an error, found on a few pixels before it is rendered.
#pragma once
#include <memory>
#include <string>

#include "host/engine/loaded_scene.hpp"

namespace nicol::engine {

struct ChosenSettings {
  bool real_double = false;
  bool reachable = true;
  std::string text;    // what was chosen
  std::string reason;  // not reachable: why
  double seconds = 0;  // that choosing took
};

// error: RMS of Stokes vectors and of XYZ, relative to the mean radiance, against the picture converged in everything. Changes
// the scene's settings; reads the scene anew where it needs more wavelengths, unless the command names them. Never takes
// fewer than the scene has: each is part of the picture. Depth goes with the cut-off. Sampling gets 0.7 of the error, the step of wavelength 0.45, the cut-off 0.35,
// rounding 0.3: together 0.95.
ChosenSettings choose_settings(std::unique_ptr<LoadedScene>& loaded, const PictureOptions& command, Device& device,
                               double error, const std::atomic<bool>& cancel);

}  // namespace nicol::engine
