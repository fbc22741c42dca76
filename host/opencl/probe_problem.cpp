#include "host/opencl/probe_problem.hpp"

#include <algorithm>

#include "kernels/probe_abi.h"

namespace nicol {
namespace {

using nlohmann::json;

enum Kind { isotropic_kind = 0, uniaxial_kind = 1, chiral_kind = 3 };  // of kernels/wave_medium.h

// Waves of an isotropic medium: hand -1 right, n - kappa, and +1 left, n + kappa (complex where it absorbs).
Complex wave_index(const ProbeMedium& m, int hand) { return Complex(m.n[0], m.k[0]) + hand * m.zeta[0]; }

// (a - b)(a + b): keeps the digits of close indices, a^2 - b^2 does not.
Complex bracket(Complex a, Complex b) { return (a - b) * (a + b); }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Incident {
  Vector normal;
  ComplexVector k, e, h;
};

Incident read_incident(const Reader& face) {
  Incident in;
  in.normal = face.member("N").unit_vector();
  const Reader incident = face.member("incident");
  in.k = incident.member("k").complex_vector();
  in.e = incident.member("E").complex_vector();
  in.h = incident.member("H").complex_vector();
  Vector flux;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    flux[i] = (in.e[j] * std::conj(in.h[l]) - in.e[l] * std::conj(in.h[j])).real();
  }
  if (!(dot(flux, in.normal) > 0)) incident.member("E").fail("E and H carry no power from medium1 to medium2");
  return in;
}

// Which wave of medium 1 comes in, and |k|^2: the medium's own value where |k| only picks it out.
struct IncidentWave {
  int known;
  Complex index, k2;
};

IncidentWave isotropic_wave(const ProbeMedium& m, Complex length) {
  const Complex right = wave_index(m, -1), left = wave_index(m, 1);
  const bool is_right = std::abs(length - right) < std::abs(length - left);
  const Complex index = is_right ? right : left;
  return {m.active ? !is_right : 2, index, index * index};
}

// The dispersion relation of the ordinary or of the extraordinary wave holds better.
IncidentWave uniaxial_wave(const ProbeMedium& m, const ComplexVector& k, Complex k2) {
  const std::size_t ordinary = (m.optic_axis + 1) % 3;
  const Complex n_o(m.n[ordinary], m.k[ordinary]), n_e(m.n[m.optic_axis], m.k[m.optic_axis]);
  const Complex eps_o = n_o * n_o, eps_e = n_e * n_e;
  Complex along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += k[i] * m.axes[m.optic_axis][i];
  const double off_o = std::abs(k2 - eps_o);
  const double off_e = std::abs((k2 * eps_o + (eps_e - eps_o) * along * along - eps_o * eps_e) / eps_e);
  return off_o <= off_e ? IncidentWave{0, n_o, eps_o} : IncidentWave{1, std::sqrt(k2), k2};
}

IncidentWave incident_wave(const Reader& face, const ProbeMedium& m, const ComplexVector& k) {
  const Complex k2 = k[0] * k[0] + k[1] * k[1] + k[2] * k[2], length = std::sqrt(k2);
  const bool isotropic = reference_eps(m) == m.n[0] * m.n[0] && m.n[0] == m.n[1] && m.n[1] == m.n[2];
  IncidentWave wave = {-1, length, k2};
  if (isotropic && m.zeta[0] == m.zeta[1] && m.zeta[1] == m.zeta[2]) wave = isotropic_wave(m, length);
  else if (m.kind == uniaxial_kind) wave = uniaxial_wave(m, k, k2);
  const auto [least, most] = std::minmax_element(m.n.begin(), m.n.end());
  const double slack = 1e-6 * *most + 2 * std::max({std::fabs(m.zeta[0]), std::fabs(m.zeta[1]), std::fabs(m.zeta[2])});
  if (isotropic && std::abs(length - wave.index) > 1e-6 * std::abs(wave.index))
    face.member("incident").member("k").fail(
        fmt::format("its length {:.9g} is no index of medium1 ({:.9g})", length.real(), wave.index.real()));
  if (length.real() < *least - slack || length.real() > *most + slack)
    face.member("incident").member("k").fail(
        fmt::format("its length {:.9g} is no index of medium1 ({:.9g} to {:.9g})", length.real(), *least, *most));
  return wave;
}

void put(std::vector<double>& scalars, int at, const ComplexVector& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    scalars[at + 2 * i] = v[i].real();
    scalars[at + 2 * i + 1] = v[i].imag();
  }
}

void put(std::vector<double>& scalars, int at, Complex z) {
  scalars[at] = z.real();
  scalars[at + 1] = z.imag();
}

// eps of the medium (ordinary; of absorbing ones complex) less |k|^2.
Complex bracket_of(const ProbeMedium& m, const IncidentWave& wave) {
  const std::size_t ordinary = (m.optic_axis + 1) % 3;
  const bool by_index = m.kind == isotropic_kind || m.kind == chiral_kind || m.kind == uniaxial_kind;
  return by_index ? bracket(Complex(m.n[ordinary], m.k[ordinary]), wave.index) : reference_eps(m) - wave.k2;
}

Reader named_case(const json& value, const char* kind, std::size_t position, std::string& id) {
  const Reader unnamed(value, fmt::format("{}[{}]", kind, position));
  id = unnamed.member("id").text();
  return {value, fmt::format("case '{}'", id)};
}

}  // namespace

ProbeProblem read_face(const json& value, std::size_t position) {
  ProbeProblem problem;
  const Reader face = named_case(value, "interface", position, problem.id);
  for (std::size_t i = 0; i < 2; ++i) problem.media[i] = read_probe_medium(face.member(i == 0 ? "medium1" : "medium2"));
  const Incident in = read_incident(face);
  const IncidentWave wave = incident_wave(face, problem.media[0], in.k);
  std::vector<double>& s = problem.scalars;
  s.resize(PROBE_SCALARS);
  s[PROBE_TASK] = PROBE_FACE;
  s[PROBE_KNOWN] = wave.known;
  for (std::size_t i = 0; i < 3; ++i) s[PROBE_NORMAL + i] = in.normal[i];
  put(s, PROBE_K, in.k);
  put(s, PROBE_E, in.e);
  put(s, PROBE_H, in.h);
  put(s, PROBE_BRACKET1, bracket_of(problem.media[0], wave));
  put(s, PROBE_BRACKET2, bracket_of(problem.media[1], wave));
  put_medium(s, PROBE_MEDIUM1, problem.media[0]);
  put_medium(s, PROBE_MEDIUM2, problem.media[1]);
  return problem;
}

ProbeProblem read_bulk(const json& value, std::size_t position) {
  ProbeProblem problem;
  const Reader bulk = named_case(value, "bulk", position, problem.id);
  problem.media[0] = read_probe_medium(bulk.member("medium"));
  problem.normal = bulk.member("s").unit_vector();
  problem.scalars.resize(PROBE_SCALARS);
  problem.scalars[PROBE_TASK] = PROBE_BULK;
  for (std::size_t i = 0; i < 3; ++i) problem.scalars[PROBE_NORMAL + i] = problem.normal[i];
  put_medium(problem.scalars, PROBE_MEDIUM1, problem.media[0]);
  return problem;
}

ProbeProblem read_propagation(const json& value, std::size_t position) {
  ProbeProblem problem = read_bulk(value, position);
  const Reader in = named_case(value, "propagation", position, problem.id);
  const Vector x = in.member("x").unit_vector();
  if (std::fabs(dot(x, problem.normal)) > 1e-9) in.member("x").fail("not across s");
  const double lambda = in.member("lambda_m").number();
  if (!(lambda > 0)) in.member("lambda_m").fail("a wavelength must be positive");
  std::vector<double>& s = problem.scalars;
  s[PROBE_TASK] = PROBE_PROPAGATION;
  for (std::size_t i = 0; i < 3; ++i) s[PROBE_K + i] = x[i];
  for (std::size_t i = 0; i < 2; ++i) put(s, static_cast<int>(PROBE_D_IN + 2 * i), in.member("D_in").element(i, 2,
      "complex numbers").complex());
  s[PROBE_DEPTH] = in.member("d_m").number() / lambda;
  return problem;
}

}  // namespace nicol
