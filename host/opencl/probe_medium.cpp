#include "host/opencl/probe_medium.hpp"

#include <algorithm>

#include "host/crystal_rows.hpp"
#include "kernels/probe_abi.h"
#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

bool all_equal(const Vector& v) { return v[0] == v[1] && v[1] == v[2]; }
bool any_nonzero(const Vector& v) { return v[0] != 0 || v[1] != 0 || v[2] != 0; }

// Columns of R, or of the rotation of the quaternion (w, x, y, z).
std::array<Vector, 3> read_axes(const Reader& in) {
  std::array<Vector, 3> rows;
  if (in.has("R")) {
    for (std::size_t i = 0; i < 3; ++i) rows[i] = in.member("R").element(i, 3, "rows").vector();
  } else {
    const Reader quaternion = in.member("quat_wxyz");
    std::array<double, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = quaternion.element(i, 4, "numbers").number();
    const auto [w, x, y, z] = c;
    if (std::fabs(w * w + x * x + y * y + z * z - 1) > 1e-9) quaternion.fail("not a unit quaternion");
    rows = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  }
  std::array<Vector, 3> axes;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) axes[i][j] = rows[j][i];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double product = axes[i][0] * axes[j][0] + axes[i][1] * axes[j][1] + axes[i][2] * axes[j][2];
      if (std::fabs(product - (i == j)) > 1e-9) in.member("R").fail("its columns are not orthonormal");
    }
  return axes;
}

int kind_of(const ProbeMedium& m, std::size_t& optic_axis) {
  if (all_equal(m.n) && all_equal(m.k) && all_equal(m.zeta)) return m.active ? WAVES_CHIRAL : WAVES_ISOTROPIC;
  if (m.active) return WAVES_GENERAL;
  for (const std::size_t i : {2, 0, 1}) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    if (m.n[j] != m.n[l] || m.k[j] != m.k[l]) continue;
    optic_axis = i;
    return WAVES_UNIAXIAL;
  }
  return WAVES_GENERAL;
}

SymmetricTensor diagonal(const Vector& value) { return {value[0], value[1], value[2], 0, 0, 0}; }

// A tensor on the crystal's axes, in the world, every `stride`-th scalar.
void put_tensor(std::vector<double>& s, std::size_t at, const SymmetricTensor& on_axes, const ProbeMedium& m,
                std::size_t stride = 1) {
  OpticFrame frame;
  for (std::size_t i = 0; i < 3; ++i) frame[i] = {m.axes[i][0], m.axes[i][1], m.axes[i][2]};
  const SymmetricTensor tensor = in_world(frame, on_axes);
  for (std::size_t c = 0; c < 6; ++c) s[at + c * stride] = tensor[c];
}

}  // namespace

ProbeMedium read_probe_medium(const Reader& in) {
  ProbeMedium m;
  m.n = in.member("n_principal").vector();
  m.k = in.member("k_principal").vector();
  m.zeta = in.member("zeta_principal").vector();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(m.n[i] > 0)) in.member("n_principal").fail("an index must be positive");
    if (m.k[i] < 0) in.member("k_principal").fail("k must not be negative (gain)");
  }
  in.member("cls").text();
  m.absorbs = any_nonzero(m.k);
  m.active = any_nonzero(m.zeta);
  m.kind = kind_of(m, m.optic_axis);
  m.axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (m.kind == WAVES_UNIAXIAL || m.kind == WAVES_GENERAL) m.axes = read_axes(in);
  return m;
}

double reference_eps(const ProbeMedium& m) {
  if (m.kind == WAVES_ISOTROPIC || m.kind == WAVES_CHIRAL) return m.n[0] * m.n[0];
  const double n_o = m.n[(m.optic_axis + 1) % 3];
  if (m.kind == WAVES_UNIAXIAL) return n_o * n_o;
  return 3 / (1 / (m.n[0] * m.n[0]) + 1 / (m.n[1] * m.n[1]) + 1 / (m.n[2] * m.n[2]));
}

void put_medium(std::vector<double>& s, std::size_t at, const ProbeMedium& m) {
  s[at + PROBE_MEDIUM_KIND] = m.kind;
  s[at + PROBE_MEDIUM_ACTIVE] = m.active;
  s[at + PROBE_MEDIUM_ABSORBS] = m.absorbs;
  s[at + PROBE_MEDIUM_EPS] = reference_eps(m);
  s[at + PROBE_MEDIUM_N] = std::sqrt(reference_eps(m));
  s[at + PROBE_MEDIUM_KAPPA] = m.kind == WAVES_CHIRAL ? m.zeta[0] : 0;
  const std::size_t ordinary = (m.optic_axis + 1) % 3;
  s[at + PROBE_MEDIUM_INDEX] = m.n[ordinary];
  s[at + PROBE_MEDIUM_INDEX + 1] = m.k[ordinary];
  s[at + PROBE_MEDIUM_INDEX_E] = m.n[m.optic_axis];
  s[at + PROBE_MEDIUM_INDEX_E + 1] = m.k[m.optic_axis];
  put_tensor(s, at + PROBE_MEDIUM_ZETA, diagonal(m.zeta), m);
  Vector re, im;
  for (std::size_t i = 0; i < 3; ++i) {
    re[i] = (m.n[i] - m.k[i]) * (m.n[i] + m.k[i]);
    im[i] = 2 * m.n[i] * m.k[i];
  }
  put_tensor(s, at + PROBE_MEDIUM_TENSOR, diagonal(re), m, 2);
  put_tensor(s, at + PROBE_MEDIUM_TENSOR + 1, diagonal(im), m, 2);
  if (m.kind == WAVES_UNIAXIAL) {
    const double n_o = m.n[(m.optic_axis + 1) % 3], n_e = m.n[m.optic_axis];
    for (std::size_t i = 0; i < 3; ++i) s[at + PROBE_MEDIUM_AXIS + i] = m.axes[m.optic_axis][i];
    s[at + PROBE_MEDIUM_N] = n_o;
    const UniaxialConstants c = uniaxial_constants(n_o, n_e);
    s[at + PROBE_MEDIUM_EPS_E] = c.eps_e;
    s[at + PROBE_MEDIUM_D_EPS] = c.d_eps;
    s[at + PROBE_MEDIUM_D_ETA] = c.d_eta;
  } else if (m.kind == WAVES_GENERAL) {
    const GeneralConstants c = general_constants(m.n, diagonal(m.zeta));
    put_tensor(s, at + PROBE_MEDIUM_ATIL, c.atil, m);
    put_tensor(s, at + PROBE_MEDIUM_GQ, c.gq, m);
  } else {
    s[at + PROBE_MEDIUM_N] = m.n[0];
  }
}

}  // namespace nicol
