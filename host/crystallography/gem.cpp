// Facets to half-spaces: see gem.hpp.
#include "host/crystallography/gem.hpp"

#include <algorithm>

#include "host/crystallography/degrees.hpp"

namespace nicol::crystallography {

Vec3 facet_normal(double angle_deg, double tooth, double gear) {
  const double phi_deg = 360 * tooth / gear;
  const double out = std::abs(sin_deg(angle_deg)), up = cos_deg(angle_deg);
  return {out * sin_deg(phi_deg), std::signbit(angle_deg) ? -up : up, out * cos_deg(phi_deg)};
}

std::vector<HalfSpace> half_spaces(const GemCut& cut) {
  std::vector<HalfSpace> faces;
  for (const GemTier& tier : cut.tiers) {
    const bool flat = tier.angle_deg == 0;  // table and culet: one facet, whatever the tooth
    for (std::size_t i = 0; i < (flat ? 1 : tier.teeth.size()); ++i) {
      const double tooth = flat ? 0 : tier.teeth[i] + cut.gear_angle_deg / 360 * cut.gear;
      faces.push_back({facet_normal(tier.angle_deg, tooth, cut.gear), tier.distance});
    }
  }
  return faces;
}

double girdle_width(const GemCut& cut) {
  double nearest = 0;
  for (const GemTier& tier : cut.tiers) {
    if (std::abs(tier.angle_deg) != 90) continue;
    nearest = nearest == 0 ? tier.distance : std::min(nearest, tier.distance);
  }
  return 2 * nearest;
}

}  // namespace nicol::crystallography
