// Discs against planes and polygons.
#pragma once
#include "parts.hpp"

namespace nicol::solids {

enum class DiscSide { inside, outside, on, both };

// Where the whole disc lies with respect to a plane; exact (its radius is taken as the double that
// it is).
DiscSide disc_side(const ExactPlane& plane, const SheetPart& disc);

// Whether the disc without its hole covers some area of a convex polygon in its plane. In double:
// where they only graze each other either answer leaves the same picture.
bool disc_covers_some(const SheetPart& disc, const ExactPlane& plane,
                      const std::vector<ExactPoint>& corners);

// Likewise for two discs in one plane.
bool discs_overlap(const SheetPart& a, const SheetPart& b);

}  // namespace nicol::solids
