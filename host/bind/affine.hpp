// Transforms as lists of elementary steps (row vectors, as POV-Ray), one Affine each so that their
// exact composition is left to the solids; and what such a list does to points, directions and
// normals.
#pragma once
#include <vector>

#include "host/scene.hpp"

namespace nicol {

using Affines = std::vector<Affine>;

Affine translation(Vec3 by);
Affine scaling(Vec3 by);
void append_rotation(Affines& list, Vec3 angle_deg);  // about x, then y, then z

double determinant(const Affine& a);
double determinant_sign(const Affines& list);  // +1, -1, or 0 for a flat one
Affine inverse(const Affine& a);
Affines inverse(const Affines& list);

Vec3 transform_point(const Affine& a, Vec3 p);
Vec3 transform_direction(const Affine& a, Vec3 d);
Vec3 transform_point(const Affines& list, Vec3 p);
Vec3 transform_direction(const Affines& list, Vec3 d);
Vec3 transform_normal(const Affines& list, Vec3 n);  // keeps the side that n points to
HalfSpace transform(const Affines& list, const HalfSpace& half_space);

}  // namespace nicol
