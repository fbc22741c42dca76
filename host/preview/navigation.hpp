// Camera and polarizers turned by hand, counted from where the scene has them.
#pragma once
#include <string>

#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol::preview {

// What the mouse has done to the camera. All zero: as the scene says.
struct Navigation {
  // Around the pivot, about the camera's up, then its right: > 0 turns the near side of the content right, up.
  double yaw_rad = 0, pitch_rad = 0;
  // In widths and heights of the picture at the pivot, as zoomed: > 0 moves the content right, up.
  double pan_right = 0, pan_up = 0;
  // Powers of 2: > 0 comes nearer (perspective: distance to the pivot / 2^zoom; orthographic: width and height / 2^zoom).
  double zoom = 0;
  bool operator==(const Navigation& o) const;
  bool operator!=(const Navigation& o) const { return !(*this == o); }
};

// What hands may ask for: beyond, float has no digits left for the camera's place.
inline constexpr double least_zoom = -20, most_zoom = 40;

// The point on the camera's axis beside the middle of the solids (of the sheets, if there are none); ahead of the camera
// always.
Vec3 pivot_of(const Scene& scene, const Geometry& geometry);

// World mm. Its polarizer is not turned: see navigate().
Camera moved(const Camera& base, const Navigation& navigation, const Vec3& pivot_mm);

enum class Analyzer {
  as_scene,
  none,      // taken away
  added      // an ideal one, passing light that is horizontal in the picture, where the camera has none
};

// The scene as seen: camera moved, its analyzer (and analyzer's plane) with it and turned by analyzer_rad
// (counter-clockwise as the picture shows it), every other polarizer turned by polarizer_rad (counter-clockwise seen from
// the side its normal points to). An analyzer taken away stays in Scene::polarizers, unused. `geometry`
// belongs to the scene read; its camera_cell becomes that of the moved camera.
Scene navigate(const Scene& scene, Geometry& geometry, const Navigation& navigation, Analyzer analyzer, double analyzer_rad,
               double polarizer_rad);

// The innermost cell around a point in world mm; on a face: the cell outside of it; on a seam: one of its solid's.
int cell_around(const Geometry& geometry, const Vec3& point_mm);

// The camera as text of the scene language, to paste: `camera { location <..> direction <..> right <..> up <..>
// polarizer { .. } }`, 17 digits, in the scene's left-handed units of mm_per_unit millimetres. Read again it gives the
// same camera. A calcite polarizer's indices are the default ones, and a comment says so where the scene's differ at all.
std::string camera_text(const Scene& scene);

}  // namespace nicol::preview
