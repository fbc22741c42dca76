// Random transparent media of every class, and faces between them.
#pragma once
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

namespace nicol::test {

enum class Optics { isotropic, chiral, uniaxial, biaxial, uniaxial_active, biaxial_active };
constexpr int optics_count = 6;

// Axes any; mean index 1 to 2 for isotropic media, 1.4 to 2 for crystals; birefringence as given; zeta up to `kappa`.
std::vector<double> random_medium(Optics optics, double birefringence, double kappa, Dice& dice);
// Constants of a medium with principal indices and zeta on random axes.
std::vector<double> medium_with(const std::array<double, 3>& n, const std::array<double, 3>& zeta, Dice& dice);

// A wave that comes in from any direction, its wave normal towards the face.
WaveCase random_face(const std::vector<double>& one, const std::vector<double>& two, int wave, Dice& dice);

}  // namespace nicol::test
