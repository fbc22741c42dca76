// Spectra of the Stokes vector, and polarization ellipses, drawn.
#pragma once
#include <imgui.h>

#include "host/preview/pixel_info.hpp"
#include "host/window/style.hpp"

namespace nicol::window {

// S0..S3 per nm over the wavelength, at the cursor; `other`, if any, by thin dashed lines. One wavelength: bars. The
// mouse reads values.
void spectrum_plot(const Fonts& fonts, ImVec2 size, const preview::PixelInfo& shown, const preview::PixelInfo* other);

// As the receiver sees it: the ellipse scaled by the degree of polarization within the circle of full polarization, an
// arrow for the sense in which the field turns (right-handed: clockwise).
void draw_ellipse(ImDrawList& list, ImVec2 middle, float radius, const preview::Ellipse& ellipse, bool arrow,
                  float thickness);

ImU32 handedness_colour(const preview::Ellipse& ellipse);

}  // namespace nicol::window
