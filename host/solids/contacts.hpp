// Where faces lie on something else, exactly; and where they nearly do.
#pragma once
#include <utility>
#include <vector>

#include "nesting.hpp"
#include "solids.hpp"

namespace nicol::solids {

// Fills geometry.patches and each cell's share of them. Cells, faces and sheets must be there
// already: cell i + 1 is solid part i, sheet i is sheet part i. `centres` are the exact local
// origins of the objects.
void find_contacts(const Scene& scene, const Parts& parts, const Nesting& nesting,
                   const std::vector<ExactPoint>& centres, Geometry& geometry,
                   sdl::Diagnostics& diagnostics);

// Warns of faces that come closer than `near_mm` without touching.
void warn_of_near_contacts(const Scene& scene, const Parts& parts, const Nesting& nesting,
                           double near_mm, const Geometry& geometry, sdl::Diagnostics& diagnostics);

// The plane relative to a local origin, in double.
Plane local_plane(const ExactPlane& plane, const ExactPoint& centre);

}  // namespace nicol::solids
