// What a plugin's fragment must be before it comes into a picture: OpenCL C that this device builds, and optics that could be.
//
// It is built alone with the headers that it may use, and asked at the scene's wavelengths, 0 to 89 degrees of incidence, azimuths
// (elements) and from both sides, in the picture's precision. With M = the amplitudes of transmission over those of reflection:
//   finite       no NaN
//   passive      the largest eigenvalue of M^H M, the most that any polarization gains, is at most 1
//   lossless     (manifest) so is the least
//   reciprocal   light that goes back: s' = -s, p' = p (fragment.h), so with Q = diag(1, -1)
//                elements  t(-l) = Q t(l)^T Q,  r(-l_r) = Q r(l)^T Q  for light along l, thrown back along l_r
//                surfaces  t from 1 to 2 = t from 2 to 1, at angles of the same tangential wave vector
//                (de Hoop 1959; Potton, Rep. Prog. Phys. 67, 717 (2004))
// Fluxes in absorbing media interfere, so surfaces are held to the last three only between transparent ones, and elements too.
// Off by more than refused_above refuses the scene; above what rounding makes it is a warning.
// Test: tests/fragments.
#pragma once
#include <string>

#include "host/fragments/scene_fragments.hpp"
#include "host/opencl/render.hpp"

namespace nicol {

// The plugin, its place, and what is wrong with numbers or compiler messages (file:line: ...).
struct FragmentError : DeviceError {
  using DeviceError::DeviceError;
};

// Throws FragmentError; returns warnings, one a line. What was found of a fragment with these values at these wavelengths on this device is
// remembered within the process.
std::string check_fragments(Device& device, const SceneFragments& fragments, const KernelOptions& options);

}  // namespace nicol
