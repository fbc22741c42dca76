// What each pixel of a picture may be off by, as a picture.
#pragma once
#include <vector>

#include "host/output/frame.hpp"

namespace nicol {

// The frame of the map of `picture`, for any sink. EXR channels, in units of the picture's radiance per nm: error.cutoff (bound: weight
// cut off times the brightest light), error.sampling (estimate; RMS over wavelengths), error.rounding (estimate, alike
// everywhere), error.total (their sum). Colours: the total relative to the mean radiance, from black (1e-7 and less) over blue, magenta,
// red and yellow to white (1 and more), a seventh of the way for each decade.
// sampling: Frame::sample_error, or of one value for all pixels. NaN is shown green.
Frame error_map(const Frame& picture, const std::vector<float>& sampling, double brightest, double rounding,
                double mean_radiance);

}  // namespace nicol
