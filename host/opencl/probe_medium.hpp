// A medium of the probe's JSON as the constants of kernels/probe_abi.h, computed in double.
#pragma once
#include <vector>

#include "host/opencl/probe_reader.hpp"

namespace nicol {

struct ProbeMedium {
  int kind = 0;       // WAVES_* of kernels/waves_kinds.h
  bool absorbs = false, active = false;
  Vector n{}, k{}, zeta{};             // principal values
  std::array<Vector, 3> axes{};        // crystal axes, world, unit
  std::size_t optic_axis = 2;          // uniaxial: which of them
};

ProbeMedium read_probe_medium(const Reader& in);

// PROBE_MEDIUM_SCALARS from `at` on.
void put_medium(std::vector<double>& scalars, std::size_t at, const ProbeMedium& medium);

// Principal value 0 (isotropic, chiral), n_o^2 (uniaxial), 3/tr(eta) (others): the medium's reference for brackets.
double reference_eps(const ProbeMedium& medium);

}  // namespace nicol
