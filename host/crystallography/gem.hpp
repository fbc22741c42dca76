// Gem cuts as faceters write them: facets by the tooth of an index gear, the angle from the girdle
// plane, and the distance from the centre. Crown angles are positive, pavilion angles negative, +-90 is
// the girdle, 0 the table, -0 the culet (R. W. Strickland, GemCad User's Manual, 1992).
//
// Axes: y is up (the table's normal), the gear turns from +z towards +x: seen from above the table with x
// to the right and z up, tooth 0 is at the top and teeth count clockwise. Left-handed space.
//   normal = (sin|angle| sin phi, +-cos angle, sin|angle| cos phi),  phi = 360 deg * tooth / gear
// Test: tests/crystallography/gem_test.cpp.
#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/scene.hpp"

namespace nicol::crystallography {

struct GemTier {  // facets of one angle and distance
  double angle_deg = 0;
  double distance = 0;
  std::vector<double> teeth;
  std::string name;
};

struct GemCut {
  double gear = 96;
  double gear_angle_deg = 0;  // added to every phi
  std::vector<GemTier> tiers;
  double refractive_index = 0;  // that the cut was made for; 0: not said
  std::string title;
};

// Unit outward normal of a facet.
Vec3 facet_normal(double angle_deg, double tooth, double gear);

// Tier by tier, tooth by tooth.
std::vector<HalfSpace> half_spaces(const GemCut& cut);

// Twice the distance of the nearest girdle facet (angle +-90); 0 without a girdle.
double girdle_width(const GemCut& cut);

// GemCad's text format (.asc): "g gear [angle of tooth 0]", "y folds y|n", "I index", "H title", "F footnote",
// "a angle distance tooth ... n name ... G instruction"; lines without a letter go on. Teeth are listed in
// full: "y" adds none.
struct GemCadError {
  int line = 0;
  std::string message;
};
std::variant<GemCut, GemCadError> read_gemcad(std::string_view text);

}  // namespace nicol::crystallography
