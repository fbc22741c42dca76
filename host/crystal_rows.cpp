// Tensors of a crystal from principal values and frame.
//   eps = R diag(n^2) R^T, Im eps = R diag(2 n k) R^T, eta = 1/eps
//   zeta = (tr(g)/2 - g)/n_g with n_g = n_o (uniaxial) or n[1] (biaxial: the index along the optic axes), so that light
//   along the optic axis turns by pi g/(n_g lambda) exactly
//   a~ = n2bar eta - 1,  n2bar = 3/tr eta,  G = n2bar det(eta) sym(eps Z),  Z = tr(zeta) - zeta^T
// Sources: Condon, Rev. Mod. Phys. 9, 432 (1937) (zeta); Nye, Physical Properties of Crystals, ch. 14 (g).
// Test: tests/kernels (the probe takes its constants from here: vectors_test.cpp; plates: crystal_plate_test.cpp).
#include "host/crystal_rows.hpp"

#include <cmath>

#include "kernels/waves_kinds.h"

namespace nicol {
namespace {

constexpr int order[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};
constexpr int place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

// g on the principal axes to zeta there.
SymmetricTensor zeta_of(const Medium& m, std::size_t i) {
  const double half_trace = (m.gyration[0][i] + m.gyration[1][i] + m.gyration[2][i]) / 2;
  const double n = m.symmetry == Medium::Symmetry::uniaxial ? m.n[0][i] : m.n[1][i];
  SymmetricTensor zeta;
  for (int c = 0; c < 6; ++c) zeta[c] = ((c < 3 ? half_trace : 0) - m.gyration[c][i]) / n;
  return zeta;
}

class Rows {
 public:
  void add(std::size_t at, const SymmetricTensor& t) {
    for (int c = 0; c < 6; ++c) add(at + c, t[c]);
  }
  void add(std::size_t at, double value) {
    if (rows.size() <= at) rows.resize(at + 1);
    rows[at].push_back(value);
  }
  std::vector<Samples> rows;
};

// Rows from CRYSTAL_ROW_IM_EPS on.
constexpr std::size_t after_im_eps = 6;

void add_uniaxial(const Medium& m, std::size_t i, Rows& rows) {
  const UniaxialConstants c = uniaxial_constants(m.n[0][i], m.n[2][i]);
  const Vec3& axis = m.frame_at(i)[2];
  std::size_t at = after_im_eps;
  for (const double value : {axis.x, axis.y, axis.z, c.eps_e, c.d_eps, c.d_eta}) rows.add(at++, value);
}

void add_general(const Medium& m, std::size_t i, Rows& rows) {
  const SymmetricTensor zeta = m.is_active() ? zeta_of(m, i) : SymmetricTensor{};
  const GeneralConstants c = general_constants({m.n[0][i], m.n[1][i], m.n[2][i]}, zeta);
  std::size_t at = after_im_eps;
  for (const SymmetricTensor& tensor : {c.atil, c.gq, zeta}) {
    rows.add(at, in_world(m.frame_at(i), tensor));
    at += 6;
  }
}

double mean(double a, double b, double c) { return (a + b + c) / 3; }

// 1/a^2 - 1/b^2 without cancellation.
double difference_of_eta(double a, double b) { return (b - a) * (b + a) / (a * a * b * b); }

}  // namespace

SymmetricTensor in_world(const OpticFrame& frame, const SymmetricTensor& t) {
  const double r[3][3] = {{frame[0].x, frame[1].x, frame[2].x},
                          {frame[0].y, frame[1].y, frame[2].y},
                          {frame[0].z, frame[1].z, frame[2].z}};
  SymmetricTensor out{};
  for (int c = 0; c < 6; ++c)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) out[c] += r[order[c][0]][a] * t[place[a][b]] * r[order[c][1]][b];
  return out;
}

UniaxialConstants uniaxial_constants(double n_o, double n_e) {
  return {n_e * n_e, (n_e - n_o) * (n_e + n_o), difference_of_eta(n_e, n_o)};
}

GeneralConstants general_constants(const std::array<double, 3>& n, const SymmetricTensor& zeta) {
  const double trace_eta = 1 / (n[0] * n[0]) + 1 / (n[1] * n[1]) + 1 / (n[2] * n[2]);
  const double det_eta = 1 / (n[0] * n[0] * n[1] * n[1] * n[2] * n[2]), trace = zeta[0] + zeta[1] + zeta[2];
  GeneralConstants out{3 / trace_eta, {}, {}};
  // n2bar eta_i - 1 = sum over j of (eta_i - eta_j)/tr eta
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.atil[i] += difference_of_eta(n[i], n[j]) / trace_eta;
  for (int c = 0; c < 6; ++c) {
    const double mean_eps = (n[order[c][0]] * n[order[c][0]] + n[order[c][1]] * n[order[c][1]]) / 2;
    out.gq[c] = out.n2bar * det_eta * mean_eps * ((c < 3 ? trace : 0) - zeta[c]);
  }
  return out;
}

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
    rows.add(0, in_world(m.frame_at(i), {loss(0), loss(1), loss(2), 0, 0, 0}));
    if (waves == WAVES_UNIAXIAL) add_uniaxial(m, i, rows);
    if (waves == WAVES_GENERAL) add_general(m, i, rows);
    // kappa = rho lambda/2 pi
    if (waves == WAVES_CHIRAL) rows.add(after_im_eps, m.rotation_deg_per_mm[i] / 360 * lambda_nm[i] * 1e-6);
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
