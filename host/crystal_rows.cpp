// Tensors of a crystal from principal values and frame.
//   eps = R diag(n^2) R^T, Im eps = R diag(2 n k) R^T, eta = 1/eps
//   zeta = (tr(g)/2 - g)/n_g with n_g = n_o (uniaxial) or n[1] (biaxial: the index along the optic axes), so that light
//   along the optic axis turns by pi g/(n_g lambda) exactly
//   a~ = n2bar eta - 1,  n2bar = 3/tr eta,  G = n2bar det(eta) sym(eps Z),  Z = tr(zeta) - zeta^T
// Sources: Condon, Rev. Mod. Phys. 9, 432 (1937) (zeta); Nye, Physical Properties of Crystals, ch. 14 (g).
// Test: tests/render/crystal_test.cpp.
#include "host/crystal_rows.hpp"

#include <cmath>

#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

using Tensor = std::array<std::array<double, 3>, 3>;

constexpr int order[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};

Tensor symmetric(const std::array<double, 6>& v) {
  Tensor t{};
  for (int i = 0; i < 6; ++i) t[order[i][0]][order[i][1]] = t[order[i][1]][order[i][0]] = v[i];
  return t;
}

// R t R^T with the columns of R given.
Tensor in_world(const OpticFrame& frame, const Tensor& t) {
  const double r[3][3] = {{frame[0].x, frame[1].x, frame[2].x},
                          {frame[0].y, frame[1].y, frame[2].y},
                          {frame[0].z, frame[1].z, frame[2].z}};
  Tensor out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) out[i][j] += r[i][a] * t[a][b] * r[j][b];
  return out;
}

Tensor diagonal(double a, double b, double c) { return symmetric({a, b, c, 0, 0, 0}); }

Tensor zeta_of(const Medium& m, std::size_t i) {
  std::array<double, 6> g{};
  for (int c = 0; c < 6; ++c) g[c] = m.gyration[c][i];
  const double half_trace = (g[0] + g[1] + g[2]) / 2;
  const double n = m.symmetry == Medium::Symmetry::uniaxial ? m.n[0][i] : m.n[1][i];
  for (int c = 0; c < 6; ++c) g[c] = ((c < 3 ? half_trace : 0) - g[c]) / n;
  return symmetric(g);
}

// n2bar det(eta) sym(eps Z), all on the principal axes.
Tensor gyration_term(const Tensor& zeta, const double n[3], double n2bar) {
  const double trace = zeta[0][0] + zeta[1][1] + zeta[2][2];
  const double det_eta = 1 / (n[0] * n[0] * n[1] * n[1] * n[2] * n[2]);
  Tensor product{}, out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product[i][j] = n[i] * n[i] * ((i == j ? trace : 0) - zeta[j][i]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i][j] = n2bar * det_eta * (product[i][j] + product[j][i]) / 2;
  return out;
}

class Rows {
 public:
  void add(std::size_t at, const Tensor& t) {
    for (int c = 0; c < 6; ++c) add(at + c, t[order[c][0]][order[c][1]]);
  }
  void add(std::size_t at, double value) {
    if (rows.size() <= at) rows.resize(at + 1);
    rows[at].push_back(value);
  }
  std::vector<Samples> rows;
};

void add_uniaxial(const Medium& m, std::size_t i, Rows& rows) {
  const double n_o = m.n[0][i], n_e = m.n[2][i];
  const double d_eps = (n_e - n_o) * (n_e + n_o);
  const Vec3& axis = m.frame_at(i)[2];
  const double values[] = {axis.x, axis.y, axis.z, n_e * n_e, d_eps, -d_eps / (n_e * n_e * n_o * n_o)};
  for (int c = 0; c < 6; ++c) rows.add(6 + c, values[c]);
}

void add_general(const Medium& m, std::size_t i, Rows& rows) {
  const double n[3] = {m.n[0][i], m.n[1][i], m.n[2][i]};
  const double eta[3] = {1 / (n[0] * n[0]), 1 / (n[1] * n[1]), 1 / (n[2] * n[2])};
  const double n2bar = 3 / (eta[0] + eta[1] + eta[2]);
  // n2bar eta_0 - 1 = ((eta_0 - eta_1) + (eta_0 - eta_2))/tr eta: no cancellation of near indices
  const auto deviation = [&](int a, int b, int c) {
    const auto step = [&](int x, int y) { return (n[y] - n[x]) * (n[y] + n[x]) * eta[x] * eta[y]; };
    return (step(a, b) + step(a, c)) / (eta[0] + eta[1] + eta[2]);
  };
  const OpticFrame& frame = m.frame_at(i);
  rows.add(6, in_world(frame, diagonal(deviation(0, 1, 2), deviation(1, 2, 0), deviation(2, 0, 1))));
  const Tensor zeta = m.is_active() ? zeta_of(m, i) : Tensor{};
  rows.add(12, in_world(frame, gyration_term(zeta, n, n2bar)));
  rows.add(18, in_world(frame, zeta));
}

double mean(double a, double b, double c) { return (a + b + c) / 3; }

}  // namespace

int waves_of(const Medium& m) {
  if (m.symmetry == Medium::Symmetry::isotropic) return m.circular_waves ? WAVES_CHIRAL : WAVES_ISOTROPIC;
  return m.symmetry == Medium::Symmetry::uniaxial && !m.is_active() ? WAVES_UNIAXIAL : WAVES_GENERAL;
}

Samples reference_index(const Medium& m) {
  if (waves_of(m) != WAVES_GENERAL) return m.n[0];
  Samples out;
  for (std::size_t i = 0; i < m.n[0].size(); ++i) {
    double trace = 0;
    for (int a = 0; a < 3; ++a) trace += 1 / (m.n[a][i] * m.n[a][i]);
    out.push_back(std::sqrt(3 / trace));
  }
  return out;
}

std::vector<Samples> crystal_rows(const Medium& m, const std::vector<double>& lambda_nm) {
  Rows rows;
  const int waves = waves_of(m);
  if (waves == WAVES_ISOTROPIC) return {};
  for (std::size_t i = 0; i < m.n[0].size(); ++i) {
    const auto loss = [&](int a) { return 2 * m.n[a][i] * m.k[a][i]; };
    rows.add(0, in_world(m.frame_at(i), diagonal(loss(0), loss(1), loss(2))));
    if (waves == WAVES_UNIAXIAL) add_uniaxial(m, i, rows);
    if (waves == WAVES_GENERAL) add_general(m, i, rows);
    // kappa = rho lambda/2 pi
    if (waves == WAVES_CHIRAL) rows.add(6, m.rotation_deg_per_mm[i] / 360 * lambda_nm[i] * 1e-6);
  }
  return rows.rows;
}

Medium without_polarization(const Medium& m) {
  Medium out = m;
  out.symmetry = Medium::Symmetry::isotropic;
  out.gyration = {};
  out.circular_waves = false;
  for (std::size_t i = 0; i < m.n[0].size(); ++i) {
    const double n = mean(m.n[0][i], m.n[1][i], m.n[2][i]), k = mean(m.k[0][i], m.k[1][i], m.k[2][i]);
    for (int a = 0; a < 3; ++a) {
      out.n[a][i] = n;
      out.k[a][i] = k;
    }
  }
  return out;
}

}  // namespace nicol
