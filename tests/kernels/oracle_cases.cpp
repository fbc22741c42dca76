#include "tests/kernels/oracle_cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "host/opencl/probe_problem.hpp"
#include "kernels/probe_abi.h"

namespace nicol::test {
namespace {

using Json = nlohmann::json;
using Field = std::array<Complex, 3>;

Complex complex_in(const Json& pair) { return {pair[0].get<double>(), pair[1].get<double>()}; }
Field field_in(const Json& vector) { return {complex_in(vector[0]), complex_in(vector[1]), complex_in(vector[2])}; }
Complex complex_at(const std::vector<double>& answer, int at) { return {answer[at], answer[at + 1]}; }
Field field_at(const std::vector<double>& answer, int at) {
  return {complex_at(answer, at), complex_at(answer, at + 2), complex_at(answer, at + 4)};
}
double distance(const Field& a, const Field& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::norm(a[i] - b[i]);
  return std::sqrt(sum);
}
double length(const Field& a) { return distance(a, {}); }

double worse(double a, double b) { return std::isnan(a) || std::isnan(b) ? NAN : std::max(a, b); }

// Largest element of zeta where activity is not that of an isotropic medium: roots are first order in it there.
double strength(const ProbeMedium& m) {
  const bool isotropic = m.n[0] == m.n[1] && m.n[1] == m.n[2];
  return isotropic ? 0 : std::max({std::fabs(m.zeta[0]), std::fabs(m.zeta[1]), std::fabs(m.zeta[2])});
}

Field cross(const Field& a, const Field& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// h - k x E - i zeta E
double field_law(const ProbeMedium& m, const Field& k, const Field& e, const Field& h) {
  Field expected = cross(k, e);
  for (int axis = 0; axis < 3; ++axis) {
    Complex along = 0;
    for (int i = 0; i < 3; ++i) along += m.axes[axis][i] * e[i];
    for (int i = 0; i < 3; ++i) expected[i] += Complex(0, 1) * m.zeta[axis] * m.axes[axis][i] * along;
  }
  return distance(expected, h);
}

std::array<double, 3> ray_of(const Field& e, const Field& h) {
  const Field conjugate = {std::conj(h[0]), std::conj(h[1]), std::conj(h[2])};
  const Field s = cross(e, conjugate);
  const double size = std::hypot(s[0].real(), s[1].real(), s[2].real());
  return {s[0].real() / size, s[1].real() / size, s[2].real() / size};
}

double ray_error(const Field& e, const Field& h, const Json& ray) {
  const std::array<double, 3> mine = ray_of(e, h);
  return std::hypot(mine[0] - ray[0].get<double>(), mine[1] - ray[1].get<double>(), mine[2] - ray[2].get<double>());
}

}  // namespace

Json read_json(const std::string& file) {
  std::ifstream in(std::string(KERNEL_TEST_DATA) + "/" + file);
  if (!in) throw std::runtime_error("no test data: " + file);
  return Json::parse(in);
}

bool Judged::good() const {
  return std::all_of(errors.begin(), errors.end(), [](const Error& e) { return e.off <= e.allowed; });
}

double Judged::worst() const {
  double share = 0;
  for (const Error& e : errors) share = worse(share, e.off / e.allowed);
  return share;
}

std::string Judged::text() const {
  std::ostringstream out;
  for (const Error& e : errors)
    if (!(e.off <= e.allowed)) out << e.name << " off by " << e.off << " (allowed " << e.allowed << ")  ";
  return out.str();
}

Judged judge_face(const Json& face, const Kernels& kernels, Precision precision) {
  const ProbeProblem problem = read_face(face, 0);
  const std::vector<double> answer = kernels.solve(problem.scalars);
  const double kappa = std::max(strength(problem.media[0]), strength(problem.media[1])),
      first_order = 4 * kappa * kappa;
  const bool absorbs = problem.media[0].absorbs || problem.media[1].absorbs;
  const double slack = absorbs ? 0 : first_order;
  const Json &sens = face["sens"], &totals = face["totals"];
  const auto allowed = [&](const char* key) {
    return precision.floor + slack + 20 * (precision.epsilon + slack) * sens[key].get<double>();
  };
  Judged out;
  out.add("R", std::fabs(answer[ANSWER_R] - totals["R"].get<double>()), allowed("total_power"));
  out.add("T", std::fabs(answer[ANSWER_T] - totals["T"].get<double>()), allowed("total_power"));
  out.add("E_r", distance(field_at(answer, ANSWER_E_R), field_in(totals["E_r"])), allowed("field"));
  out.add("E_t", distance(field_at(answer, ANSWER_E_T), field_in(totals["E_t"])), allowed("field"));
  for (int side = 0; side < 2; ++side) {
    const Json waves[2] = {face["waves"][2 * side], face["waves"][2 * side + 1]};
    const auto at = [&](int mine) { return (2 * side + mine) * ANSWER_WAVE_SCALARS; };
    const auto k_error = [&](int mine, int theirs) { return distance(field_at(answer, at(mine) + ANSWER_WAVE_K),
        field_in(waves[theirs]["k"])); };
    const double straight = worse(k_error(0, 0), k_error(1, 1)), crossed = worse(k_error(0, 1), k_error(1, 0));
    const std::string name = side == 0 ? "reflected " : "transmitted ";
    out.add(name + "k", std::min(straight, crossed), allowed("k"));
    const double gap = waves[0]["pair_gap"].get<double>();
    const double n2 = problem.media[side].n[2] * problem.media[side].n[2];
    for (int mine = 0; mine < 2; ++mine) {
      const Field k = field_at(answer, at(mine) + ANSWER_WAVE_K), e = field_at(answer, at(mine) + ANSWER_WAVE_E);
      const Field h = field_at(answer, at(mine) + ANSWER_WAVE_H);
      out.add(name + "h = k x E + i zeta E", field_law(problem.media[side], k, e, h),
              precision.floor + 20 * precision.epsilon * (1 + sens["field"].get<double>()));
      const double blur = 20 * (precision.epsilon + slack) * n2 / gap;
      if (!(blur < 0.1)) continue;
      const Json& theirs = waves[straight <= crossed ? mine : 1 - mine];
      out.add(name + "power", std::fabs(answer[at(mine) + ANSWER_WAVE_POWER] - theirs["power"].get<double>()),
          allowed("total_power") + blur);
      out.add(name + "E", distance(e, field_in(theirs["E"])), allowed("field") + blur * length(field_in(theirs["E"])));
      if (theirs["type"] == "propagating" && theirs["power"].get<double>() > 1e-9)
        out.add(name + "ray", ray_error(e, h, theirs["ray"]), allowed("k") + blur);
    }
  }
  return out;
}

Judged judge_bulk(const Json& bulk, const Kernels& kernels, Precision precision) {
  const ProbeProblem problem = read_bulk(bulk, 0);
  const std::vector<double> answer = kernels.solve(problem.scalars);
  const auto index = [&](int j) { return complex_in(bulk["modes"][j]["n"]); };
  const double kappa = problem.media[0].absorbs ? 0 : strength(problem.media[0]), gap = std::abs(index(0) - index(1));
  Judged out;
  const auto n_error = [&](int mine, int theirs) { return std::abs(complex_at(answer,
      mine * BULK_SCALARS + BULK_N) - index(theirs)); };
  const double straight = worse(n_error(0, 0), n_error(1, 1)), crossed = worse(n_error(0, 1), n_error(1, 0));
  out.add("n", std::min(straight, crossed), precision.floor + 4 * kappa * kappa);
  const double blur = 20 * (precision.epsilon + kappa * kappa) / gap;
  if (!(blur < 0.1)) return out;
  for (int mine = 0; mine < 2; ++mine) {
    const Json& theirs = bulk["modes"][straight <= crossed ? mine : 1 - mine];
    const Field e = field_at(answer, mine * BULK_SCALARS + BULK_E), h = field_at(answer, mine * BULK_SCALARS + BULK_H);
    Field turned = e, turned_h = h, turned_d = field_at(answer, mine * BULK_SCALARS + BULK_D);
    Complex phase = 0;
    for (int i = 0; i < 3; ++i) phase += std::conj(e[i]) * field_in(theirs["E"])[i];
    phase /= std::abs(phase);
    for (int i = 0; i < 3; ++i) {
      turned[i] *= phase;
      turned_h[i] *= phase;
      turned_d[i] *= phase;
    }
    const double allowed = 5 * precision.floor + 10 * kappa * kappa + blur;
    out.add("E", distance(turned, field_in(theirs["E"])), allowed);
    out.add("H", distance(turned_h, field_in(theirs["H"])), allowed);
    out.add("D", distance(turned_d, field_in(theirs["D"])), 4 * allowed);
    out.add("ray", ray_error(e, h, theirs["ray"]), allowed);
  }
  return out;
}

Judged judge_propagation(const Json& propagation, const Kernels& kernels, Precision precision) {
  const ProbeProblem problem = read_propagation(propagation, 0);
  const std::vector<double> answer = kernels.solve(problem.scalars);
  const double kappa = strength(problem.media[0]), waves = 2 * 3.15 * problem.scalars[PROBE_DEPTH];
  const double gap = std::fabs(propagation["n"][1].get<double>() - propagation["n"][0].get<double>());
  // the phase is as good as the difference of the indices, which single precision of s and of the medium limits
  const double allowed = precision.floor + 20 * precision.epsilon * waves * gap + 4 * kappa * kappa * waves +
                         20 * (precision.epsilon + kappa * kappa) / std::max(gap, 1e-3);
  Judged out;
  double off = 0;
  for (int i = 0; i < 2; ++i)
    off = worse(off, std::abs(complex_at(answer, PROPAGATION_D_OUT + 2 * i) - complex_in(propagation["D_out"][i])));
  out.add("D_out", off, allowed);
  out.add("retardance", std::fabs(std::fabs(answer[PROPAGATION_RETARDANCE]) - std::fabs(propagation["retardance_rad"].get<double>())), allowed);
  return out;
}

}  // namespace nicol::test
