// The straight way of one camera ray through the first solid it meets.
//
// A ray of light in air refracts at the first face into the solid (Snell: the component along the
// face scales by n1/n2) and runs to the first face that it leaves by. Valid for isotropic solids in
// isotropic surroundings; a non-convex solid is followed through its first convex part. Proved by
// tests/app/chord_test.cpp.
#pragma once
#include <array>
#include <optional>

#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol::app {

struct Chord {
  int cell = 0;
  double length_mm = 0;
};

// place: 0..1 from the left and from the top of the picture; lambda: index into Scene::lambda_nm.
// Nothing if the ray meets no solid. The camera stands outside of all solids.
std::optional<Chord> first_chord(const Scene& scene, const Geometry& geometry,
                                 const std::array<double, 2>& place, std::size_t lambda);

}  // namespace nicol::app
