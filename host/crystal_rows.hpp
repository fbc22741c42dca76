// The rows of a crystal in the kernels' tables (abi.h): its dielectric and gyration tensors in the world.
#pragma once
#include <vector>

#include "host/scene.hpp"

namespace nicol {

// WAVES_* of kernels/waves.h: which solver the medium needs.
int waves_of(const Medium& medium);

// The index that MEDIUM_ROW_N holds: n, n_o, or sqrt(3/tr eta), eta = 1/eps.
Samples reference_index(const Medium& medium);

// The rows from CRYSTAL_ROW_IM_EPS on; nothing for isotropic media.
std::vector<Samples> crystal_rows(const Medium& medium, const std::vector<double>& lambda_nm);

// The isotropic medium that stands for a crystal where polarization is off: mean index and extinction.
Medium without_polarization(const Medium& medium);

}  // namespace nicol
