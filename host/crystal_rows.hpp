// The rows of a crystal in the kernels' tables (abi.h): its dielectric and gyration tensors in the world.
#pragma once
#include <vector>

#include "host/scene.hpp"

namespace nicol {

// A symmetric tensor: xx yy zz yz zx xy.
using SymmetricTensor = std::array<double, 6>;

// A tensor given on the axes of `frame`, in the world.
SymmetricTensor in_world(const OpticFrame& frame, const SymmetricTensor& on_axes);

// What the kernels know of a uniaxial crystal beside n_o: n_e^2, n_e^2 - n_o^2, 1/n_e^2 - 1/n_o^2.
struct UniaxialConstants {
  double eps_e, d_eps, d_eta;
};
UniaxialConstants uniaxial_constants(double n_o, double n_e);

// Of a biaxial or active one, on its principal axes: n2bar = 3/tr(eta), n2bar eta - 1, and the gyration term.
struct GeneralConstants {
  double n2bar;
  SymmetricTensor atil, gq;
};
GeneralConstants general_constants(const std::array<double, 3>& n, const SymmetricTensor& zeta);

// WAVES_* of kernels/waves_kinds.h: which solver the medium needs.
int waves_of(const Medium& medium);

// The index that MEDIUM_ROW_N holds: n, n_o, or sqrt(3/tr eta), eta = 1/eps.
Samples reference_index(const Medium& medium);

// The rows from CRYSTAL_ROW_IM_EPS on; nothing for isotropic media.
std::vector<Samples> crystal_rows(const Medium& medium, const std::vector<double>& lambda_nm);

// The isotropic medium that stands for a crystal where polarization is off: mean index and extinction.
Medium without_polarization(const Medium& medium);

}  // namespace nicol
