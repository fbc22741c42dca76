// False colours in linear sRGB: straight lines and a circle in Oklab, so that equal steps look equally far apart.
// Source: B. Ottosson, "A perceptual color space for image processing" (2020), bottosson.github.io/posts/oklab.
// None is clipped: all lie in sRGB (tests/preview/view_test.cpp).
#pragma once
#include <array>

namespace nicol::preview {

using Rgb = std::array<float, 3>;

// 0..1: dark blue, greyish, yellow, for eyes of every kind.
Rgb sequential_colour(float value);

// -1..1: blue, light grey at 0, red.
Rgb diverging_colour(float value);

// Hue by azimuth (twice its angle, as azimuth + 180 deg is the same), chroma by the degree of linear polarization:
// s1, s2 over S0. Lightness is the same for all.
Rgb angle_colour(float s1, float s2);

// Of sin(2 ellipticity) = S3/|(S1, S2, S3)|: the diverging colours, equal steps of the angle.
Rgb ellipticity_colour(float sine);

// Neutral dark grey.
Rgb nothing_there();

}  // namespace nicol::preview
