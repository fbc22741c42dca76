// Whether half-spaces enclose a finite solid.
#pragma once
#include <optional>
#include <vector>

#include "host/scene.hpp"

namespace nicol::crystallography {

// A direction (unit length) in which nothing closes the solid; nothing if it is bounded. Offsets do not
// matter. Of all normals, two span every edge direction of the open cone, so those and their
// opposites are tried. O(n^2) if bounded, n^3 at worst.
std::optional<Vec3> open_direction(const std::vector<HalfSpace>& faces);

}  // namespace nicol::crystallography
