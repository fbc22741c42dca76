#include "host/opencl/probe_problem.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "kernels/probe_abi.h"

namespace nicol {
namespace {

using nlohmann::json;
using Complex = std::complex<double>;
using Vector = std::array<double, 3>;
using ComplexVector = std::array<Complex, 3>;

// Reads members and tells where it is when something is wrong.
class Reader {
 public:
  Reader(const json& value, std::string where) : value_(value), where_(std::move(where)) {}

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(where_ + ": " + what); }

  Reader member(const char* name) const {
    if (!value_.is_object()) fail("expected an object");
    const auto found = value_.find(name);
    if (found == value_.end()) fail(fmt::format("member '{}' is missing", name));
    return {*found, fmt::format("{}{}{}", where_, where_.back() == ']' || where_.back() == '\'' ? ": " : ".", name)};
  }

  std::string text() const {
    if (!value_.is_string()) fail(fmt::format("expected a text, found {}", value_.type_name()));
    return value_.get<std::string>();
  }

  double number() const {
    if (!value_.is_number()) fail(fmt::format("expected a number, found {}", value_.type_name()));
    const double x = value_.get<double>();
    if (!std::isfinite(x)) fail("the number is not finite");
    return x;
  }

  Reader element(std::size_t i, std::size_t size, const char* what) const {
    if (!value_.is_array() || value_.size() != size)
      fail(fmt::format("expected {} {}, found {}", size, what,
                       value_.is_array() ? fmt::format("{} elements", value_.size()) : value_.type_name()));
    return {value_[i], fmt::format("{}[{}]", where_, i)};
  }

  Vector vector() const {
    Vector v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = element(i, 3, "numbers").number();
    return v;
  }

  ComplexVector complex_vector() const {
    ComplexVector v;
    for (std::size_t i = 0; i < 3; ++i) {
      const Reader z = element(i, 3, "complex numbers");
      v[i] = {z.element(0, 2, "numbers (re, im)").number(), z.element(1, 2, "numbers (re, im)").number()};
    }
    return v;
  }

 private:
  const json& value_;
  std::string where_;
};

struct Medium {
  std::string kind;
  Complex n;          // n + i k
  double kappa = 0;
  bool absorbs = false, chiral = false;
  std::string unsupported;
};

bool same_on_all_axes(const Vector& v) { return v[0] == v[1] && v[1] == v[2]; }

Medium read_medium(const Reader& in) {
  const Vector n = in.member("n_principal").vector(), k = in.member("k_principal").vector(),
               zeta = in.member("zeta_principal").vector();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(n[i] > 0)) in.member("n_principal").fail("an index must be positive");
    if (k[i] < 0) in.member("k_principal").fail("k must not be negative (gain)");
  }
  Medium m;
  m.kind = in.member("cls").text();
  m.n = {n[0], k[0]};
  m.kappa = zeta[0];
  m.absorbs = k[0] > 0;
  m.chiral = m.kappa != 0;
  if ((m.kind != "isotropic" && m.kind != "chiral") || !same_on_all_axes(n) || !same_on_all_axes(k) ||
      !same_on_all_axes(zeta))
    m.unsupported = fmt::format("medium of class {}: the kernels trace isotropic and chiral media", m.kind);
  else if (m.absorbs && m.chiral)
    m.unsupported = "a chiral medium that absorbs: the kernels trace transparent ones";
  return m;
}

// Index of a medium's wave: hand -1 right, +1 left (physics of circular waves: n - kappa, n + kappa).
Complex wave_index(const Medium& m, int hand) { return m.n + hand * m.kappa; }

// (a - b)(a + b): keeps the digits of close indices, a^2 - b^2 does not.
Complex bracket(Complex a, Complex b) { return (a - b) * (a + b); }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Incident {
  Vector normal;
  ComplexVector k, e, h;
};

Incident read_incident(const Reader& face) {
  Incident in;
  in.normal = face.member("N").vector();
  if (std::fabs(dot(in.normal, in.normal) - 1) > 1e-9)
    face.member("N").fail(fmt::format("not a unit vector: its length is {:.9g}", std::sqrt(dot(in.normal, in.normal))));
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

// The index of the incident wave: the medium's own value, which |k| only picks out.
Complex incident_index(const Reader& face, const Medium& m, const ComplexVector& k) {
  const Complex length = std::sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
  const Complex right = wave_index(m, -1), left = wave_index(m, 1);
  const Complex index = std::abs(length - right) < std::abs(length - left) ? right : left;
  if (std::abs(length - index) > 1e-6 * std::abs(index))
    face.member("incident").member("k").fail(
        fmt::format("its length {:.9g} is no index of medium1 ({:.9g})", length.real(), index.real()));
  return index;
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

std::vector<double> scalars_of(const Incident& in, const Medium& medium1, const Medium& medium2, Complex index) {
  std::vector<double> s(PROBE_SCALARS);
  s[PROBE_CLASS1] = medium1.chiral ? PROBE_CHIRAL : PROBE_ISOTROPIC;
  s[PROBE_CLASS2] = medium2.chiral ? PROBE_CHIRAL : PROBE_ISOTROPIC;
  s[PROBE_ABSORBS] = medium1.absorbs || medium2.absorbs;
  for (std::size_t i = 0; i < 3; ++i) s[PROBE_NORMAL + i] = in.normal[i];
  put(s, PROBE_K, in.k);
  put(s, PROBE_E, in.e);
  put(s, PROBE_H, in.h);
  put(s, PROBE_N1, medium1.n);
  put(s, PROBE_N2, medium2.n);
  s[PROBE_KAPPA1] = medium1.kappa;
  s[PROBE_KAPPA2] = medium2.kappa;
  for (int wave = 0; wave < 2; ++wave) {
    put(s, PROBE_BRACKETS1 + 2 * wave, bracket(wave_index(medium1, 2 * wave - 1), index));
    put(s, PROBE_BRACKETS2 + 2 * wave, bracket(wave_index(medium2, 2 * wave - 1), index));
  }
  return s;
}

}  // namespace

ProbeProblem read_problem(const json& face, std::size_t position) {
  ProbeProblem problem;
  const Reader unnamed(face, fmt::format("interface[{}]", position));
  problem.id = unnamed.member("id").text();
  const Reader named(face, fmt::format("case '{}'", problem.id));
  const Medium medium1 = read_medium(named.member("medium1")), medium2 = read_medium(named.member("medium2"));
  const Incident incident = read_incident(named);
  problem.absorbs[0] = medium1.absorbs;
  problem.absorbs[1] = medium2.absorbs;
  problem.unsupported = !medium1.unsupported.empty() ? medium1.unsupported : medium2.unsupported;
  if (problem.unsupported.empty() && (medium1.absorbs || medium2.absorbs) && (medium1.chiral || medium2.chiral))
    problem.unsupported = "a face between a medium that absorbs and a chiral one";
  if (problem.unsupported.empty())
    problem.scalars = scalars_of(incident, medium1, medium2, incident_index(named, medium1, incident.k));
  return problem;
}

}  // namespace nicol
