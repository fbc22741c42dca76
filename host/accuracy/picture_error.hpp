// How far a picture is from a better one, and how far its step of wavelength leaves it from the integral.
#pragma once
#include <cstddef>
#include <string>

#include "host/output/frame.hpp"

namespace nicol {

// Stokes: length of the difference of the vectors S0..S3, over pixels and common wavelengths, relative to the
// mean S0 of the reference. XYZ: length of the difference of the three, over pixels, relative to the reference's
// mean Y. CIEDE2000: of both pictures' colours times the reference's exposure, white D65 with Y = 1.
struct PictureError {
  double stokes_rms = 0, stokes_max = 0;
  double xyz_rms = 0, xyz_max = 0;
  double ciede_mean = 0, ciede_95 = 0, ciede_worst = 0;  // 95: what 95 % of the pixels stay below
  std::size_t pixels = 0, wavelengths = 0;               // that were compared; no common wavelength: Stokes are 0
  // "The RMS error": the larger of Stokes and XYZ. NaN where one is.
  double rms() const;
};

// Wavelengths may differ: Stokes are compared where both have one (to 1e-6 nm), XYZ by the wavelengths of
// each. Only rows that are done in both count. Throws std::invalid_argument for pictures of different sizes.
PictureError picture_error(const Frame& picture, const Frame& reference);

// Error of the picture's colours by its step of wavelength, estimated from the picture alone.
struct SpectralStep {
  bool known = false;
  std::string reason;  // not known: why ("2 wavelengths")
  double order = 2;    // of the error in the step, as observed: 1 to 2
  double xyz_rms = 0, xyz_max = 0;  // relative to the mean Y
  double ciede_mean = 0, ciede_95 = 0, ciede_worst = 0;
};

// Richardson: the trapezoid rule over every wavelength against that over every second one (both ends kept, weights
// remade) differs by 2^order - 1 times the error left; the order by every fourth. Known for three or more equally
// spaced wavelengths. Of six scenes of the gallery (isotropic, dispersive, birefringent, pleochroic, active) at steps
// from 30 to 2 nm, xyz_rms was 0.5 to 8 times what steps of 1 nm showed, below 5 nm 0.5 to 6 times.
SpectralStep spectral_step(const Frame& picture);

}  // namespace nicol
