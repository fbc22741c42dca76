#include "tests/kernels/oracle_cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "kernels/probe_abi.h"

namespace nicol::test {
namespace {

using Json = nlohmann::json;
using Field = std::array<Complex, 3>;

Complex complex_in(const Json& pair) { return {pair[0].get<double>(), pair[1].get<double>()}; }
Field field_in(const Json& vector) { return {complex_in(vector[0]), complex_in(vector[1]), complex_in(vector[2])}; }
Field field_at(const std::vector<double>& answer, int at) {
  return {Complex{answer[at], answer[at + 1]}, Complex{answer[at + 2], answer[at + 3]}, Complex{answer[at + 4], answer[at + 5]}};
}
double distance(const Field& a, const Field& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::norm(a[i] - b[i]);
  return std::sqrt(sum);
}
double kappa_of(const Json& medium) { return medium["zeta"][0][0].get<double>(); }
Complex index_of(const Json& medium) { return {medium["n_principal"][0].get<double>(), medium["k_principal"][0].get<double>()}; }

void put(std::vector<double>& problem, int at, const Field& v) {
  for (int i = 0; i < 3; ++i) {
    problem[at + 2 * i] = v[i].real();
    problem[at + 2 * i + 1] = v[i].imag();
  }
}

double worse(double a, double b) { return std::isnan(a) || std::isnan(b) ? NAN : std::max(a, b); }

// h = k x E + i kappa E of the waves that carry energy or not: off by how much.
double field_law(const std::vector<double>& answer, int wave, double kappa) {
  const int at = wave * ANSWER_WAVE_SCALARS;
  const Field k = field_at(answer, at + ANSWER_WAVE_K), e = field_at(answer, at + ANSWER_WAVE_E);
  const Complex i(0, 1);
  const Field h = {k[1] * e[2] - k[2] * e[1] + i * kappa * e[0], k[2] * e[0] - k[0] * e[2] + i * kappa * e[1],
                   k[0] * e[1] - k[1] * e[0] + i * kappa * e[2]};
  return distance(h, field_at(answer, at + ANSWER_WAVE_H));
}

}  // namespace

Json read_json(const std::string& file) {
  std::ifstream in(std::string(KERNEL_TEST_DATA) + "/" + file);
  if (!in) throw std::runtime_error("no test data: " + file);
  return Json::parse(in);
}

std::vector<double> probe_problem(const Json& face) {
  const Json &one = face["medium1"], &two = face["medium2"], &incident = face["incident"];
  std::vector<double> p(PROBE_SCALARS);
  p[PROBE_CLASS1] = kappa_of(one) != 0 ? PROBE_CHIRAL : PROBE_ISOTROPIC;
  p[PROBE_CLASS2] = kappa_of(two) != 0 ? PROBE_CHIRAL : PROBE_ISOTROPIC;
  const Complex n1 = index_of(one), n2 = index_of(two), in = complex_in(incident["n"]);
  p[PROBE_ABSORBS] = n1.imag() != 0 || n2.imag() != 0;
  for (int i = 0; i < 3; ++i) p[PROBE_NORMAL + i] = face["N"][i].get<double>();
  put(p, PROBE_K, field_in(incident["k"]));
  put(p, PROBE_E, field_in(incident["E"]));
  put(p, PROBE_H, field_in(incident["H"]));
  const auto put_medium = [&](int index_at, int kappa_at, int brackets_at, Complex n, double kappa) {
    p[index_at] = n.real();
    p[index_at + 1] = n.imag();
    p[kappa_at] = kappa;
    for (int wave = 0; wave < 2; ++wave) {
      const Complex to = n + (wave == 0 ? -kappa : kappa), bracket = (to - in) * (to + in);
      p[brackets_at + 2 * wave] = bracket.real();
      p[brackets_at + 2 * wave + 1] = bracket.imag();
    }
  };
  put_medium(PROBE_N1, PROBE_KAPPA1, PROBE_BRACKETS1, n1, kappa_of(one));
  put_medium(PROBE_N2, PROBE_KAPPA2, PROBE_BRACKETS2, n2, kappa_of(two));
  return p;
}

bool Judged::good() const {
  return std::all_of(errors.begin(), errors.end(), [](const Error& e) { return e.off <= e.allowed; });
}

std::string Judged::text() const {
  std::ostringstream out;
  for (const Error& e : errors) out << e.name << " off by " << e.off << " (allowed " << e.allowed << ")  ";
  return out.str();
}

Judged judge(const Json& face, const std::vector<double>& answer, double floor, double epsilon) {
  const Json& sens = face["sens"];
  const auto allowed = [&](const char* key) { return floor + 20 * epsilon * sens[key].get<double>(); };
  const Json& totals = face["totals"];
  Judged out;
  out.errors.push_back({"R", std::fabs(answer[ANSWER_R] - totals["R"].get<double>()), allowed("total_power")});
  out.errors.push_back({"T", std::fabs(answer[ANSWER_T] - totals["T"].get<double>()), allowed("total_power")});
  out.errors.push_back({"E_r", distance(field_at(answer, ANSWER_E_R), field_in(totals["E_r"])), allowed("field")});
  out.errors.push_back({"E_t", distance(field_at(answer, ANSWER_E_T), field_in(totals["E_t"])), allowed("field")});
  double k_off = 0, power_off = 0, law_off = 0, power_allowed = allowed("total_power");
  for (int side = 0; side < 2; ++side) {
    const Json waves[2] = {face["waves"][2 * side], face["waves"][2 * side + 1]};
    const auto k_error = [&](int mine, int theirs) {
      return distance(field_at(answer, (2 * side + mine) * ANSWER_WAVE_SCALARS + ANSWER_WAVE_K), field_in(waves[theirs]["k"]));
    };
    const double straight = worse(k_error(0, 0), k_error(1, 1)), crossed = worse(k_error(0, 1), k_error(1, 0));
    k_off = worse(k_off, std::min(straight, crossed));
    const double kappa = kappa_of(face[side == 0 ? "medium1" : "medium2"]);
    for (int w = 0; w < 2; ++w) law_off = worse(law_off, field_law(answer, 2 * side + w, kappa));
    const double gap = waves[0]["pair_gap"].get<double>();
    if (gap < 1e-5) continue;
    power_allowed = std::max(power_allowed, allowed("total_power") + 20 * epsilon / gap);
    for (int w = 0; w < 2; ++w) {
      const int mine = (2 * side + w) * ANSWER_WAVE_SCALARS + ANSWER_WAVE_POWER, theirs = straight <= crossed ? w : 1 - w;
      power_off = worse(power_off, std::fabs(answer[mine] - waves[theirs]["power"].get<double>()));
    }
  }
  out.errors.push_back({"k", k_off, allowed("k")});
  out.errors.push_back({"power of a wave", power_off, power_allowed});
  out.errors.push_back({"h = k x E + i kappa E", law_off, floor + 20 * epsilon * (1 + sens["field"].get<double>())});
  return out;
}

}  // namespace nicol::test
