// The polarization ellipse of a Stokes vector.
#pragma once
#include <array>
#include <optional>

#include "host/preview/picture.hpp"
#include "host/preview/view.hpp"

namespace nicol::preview {

// The Stokes vector that a pixel shows: weighted by ybar, or at the view's wavelength. None: nothing is traced there.
std::optional<std::array<double, 4>> shown_stokes(const Picture& picture, const View& view, int x, int y);

// At no place yet. All 0 without light or polarization.
Ellipse ellipse_of(const std::array<double, 4>& stokes);

}  // namespace nicol::preview
