// The one place where the units and the handedness of scene text become nicol's.
//
// Text: POV-Ray's left-handed axes, scene units, degrees, absorption per mm, wavelengths in nm.
// Scene: right-handed world, mm, rad, extinction coefficients, wavelengths in nm.
//
// to_world() negates z. A mirror of the whole scene together with its camera leaves the picture as
// it was, so the picture is POV-Ray's, and what the eye sees right-handed is right-handed in the
// computation. `crystal { }` is written in right-handed Cartesian axes X, Y, Z. from_crystal() puts
// them as mineralogists draw them: X towards the viewer (-z), Y to the right (+x), Z up (+y), that
// is (x, y, z) = (Y, Z, -X). It mirrors, and to_world() mirrors back: together they are a proper
// rotation, and right quartz stays right quartz.
#pragma once
#include "host/scene.hpp"

namespace nicol {

Affine to_world(double mm_per_unit);
Affine from_crystal();

// Exactly 0, +-1/2 and +-1 where the true value is that.
double sin_deg(double angle_deg);
double cos_deg(double angle_deg);
double radians(double angle_deg);

// k of a medium that dims intensity by exp(-absorb_per_mm * path_mm): k = a lambda / (4 pi).
double extinction(double absorb_per_mm, double lambda_nm);

}  // namespace nicol
