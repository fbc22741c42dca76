#include "tests/kernels/wave_media.hpp"

#include "host/opencl/probe_problem.hpp"
#include "kernels/probe_abi.h"

namespace nicol::test {
namespace {

Vec3 dice_direction(Dice& dice) {
  const double z = 2 * dice() - 1, azimuth = 2 * pi * dice(), r = std::sqrt(1 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

}  // namespace

std::vector<double> medium_with(const std::array<double, 3>& n, const std::array<double, 3>& zeta, Dice& dice) {
  const Vec3 c = dice_direction(dice), other = dice_direction(dice), a = unit(plus(other, scaled(-dot(other, c), c))),
      b = cross(c, a);
  const nlohmann::json medium = {{"cls", "any"},
                                 {"n_principal", n},
                                 {"k_principal", {0, 0, 0}},
                                 {"zeta_principal", zeta},
                                 {"R", {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}}};
  std::vector<double> scalars(PROBE_MEDIUM_SCALARS);
  put_medium(scalars, 0, read_probe_medium(Reader(medium, "medium")));
  return scalars;
}

std::vector<double> random_medium(Optics optics, double birefringence, double kappa, Dice& dice) {
  const bool active = optics == Optics::chiral || optics == Optics::uniaxial_active || optics == Optics::biaxial_active;
  const bool biaxial = optics == Optics::biaxial || optics == Optics::biaxial_active;
  if (optics == Optics::isotropic || optics == Optics::chiral) {
    const double n = 1 + dice(), z = active ? kappa * (0.1 + 0.9 * dice()) * (dice() < 0.5 ? -1 : 1) : 0;
    return medium_with({n, n, n}, {z, z, z}, dice);
  }
  const double least = 1.4 + 0.6 * dice();
  std::array<double, 3> n{least, least, least + birefringence};
  if (biaxial) n[1] = least + birefringence * (0.1 + 0.8 * dice());
  if (!biaxial && dice() < 0.5) n = {n[2], n[2], n[0]};
  std::array<double, 3> zeta{};
  if (active) {
    for (double& z : zeta) z = kappa * (2 * dice() - 1);
    if (!biaxial) zeta[1] = zeta[0];
  }
  return medium_with(n, zeta, dice);
}

WaveCase random_face(const std::vector<double>& one, const std::vector<double>& two, int wave, Dice& dice) {
  WaveCase face{one, two, dice_direction(dice), dice_direction(dice), wave};
  if (dot(face.normal, face.s) < 0) face.s = scaled(-1, face.s);
  return face;
}

}  // namespace nicol::test
