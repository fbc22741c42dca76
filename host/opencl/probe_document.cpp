// What comes in and what goes out of the probe, without a device.
#include "host/opencl/probe_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/opencl/probe_problem.hpp"
#include "kernels/probe_abi.h"

namespace nicol {
namespace {

using nlohmann::json;

constexpr std::size_t problems_per_launch = 16384;

json complex_vector(const double* v) { return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}; }

// Re(E x H*)
Vector flux_of(const double* e, const double* h) {
  const auto term = [&](int i, int j) { return e[2 * i] * h[2 * j] + e[2 * i + 1] * h[2 * j + 1]; };
  return {term(1, 2) - term(2, 1), term(2, 0) - term(0, 2), term(0, 1) - term(1, 0)};
}

// Direction of the flux; that of the wave normal where the wave carries nothing.
json ray_of(const double* e, const double* h, const json& normal) {
  const Vector s = flux_of(e, h);
  const double length = std::hypot(s[0], s[1], s[2]);
  return length > 1e-30 ? json{s[0] / length, s[1] / length, s[2] / length} : normal;
}

json wave_answer(const double* wave, int index, const ProbeProblem& problem) {
  const double* k = wave + ANSWER_WAVE_K;
  const double n_phase = std::hypot(k[0], k[2], k[4]);
  const bool complex_q = problem.media[0].absorbs, absorbs = problem.media[index / 2].absorbs;
  const char* type = complex_q || absorbs                 ? "attenuated"
                     : wave[ANSWER_WAVE_P + 1] != 0 ? "evanescent"
                                                          : "propagating";
  const bool runs = type[0] != 'e';
  const json normal = {k[0] / n_phase, k[2] / n_phase, k[4] / n_phase};
  return {{"side", index < 2 ? "r" : "t"},
          {"type", type},
          {"p", {wave[ANSWER_WAVE_P], wave[ANSWER_WAVE_P + 1]}},
          {"k", complex_vector(k)},
          {"n_phase", n_phase},
          {"s", runs ? normal : json()},
          {"ray", runs ? ray_of(wave + ANSWER_WAVE_E, wave + ANSWER_WAVE_H, normal) : json()},
          {"E", complex_vector(wave + ANSWER_WAVE_E)},
          {"H", complex_vector(wave + ANSWER_WAVE_H)},
          {"power", wave[ANSWER_WAVE_POWER]}};
}

json face_answer(const ProbeProblem& problem, const double* answer) {
  json waves = json::array();
  double sum_powers = 0;
  for (int i = 0; i < 4; ++i) {
    waves.push_back(wave_answer(answer + i * ANSWER_WAVE_SCALARS, i, problem));
    sum_powers += answer[i * ANSWER_WAVE_SCALARS + ANSWER_WAVE_POWER];
  }
  return {{"id", problem.id},
          {"waves", waves},
          {"totals",
           {{"R", answer[ANSWER_R]},
            {"T", answer[ANSWER_T]},
            {"sum_powers", sum_powers},
            {"E_r", complex_vector(answer + ANSWER_E_R)},
            {"E_t", complex_vector(answer + ANSWER_E_T)}}}};
}

// Power absorbed per unit length of the ray over k0, to first order: Re(E* . Im(eps) . E)/|Re(E x h*)|.
double absorbed_along_ray(const double* wave, const ProbeMedium& m) {
  const Vector s = flux_of(wave + BULK_E, wave + BULK_H);
  double absorbed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Complex along = 0;
    for (std::size_t j = 0; j < 3; ++j) along += m.axes[i][j] * Complex(wave[BULK_E + 2 * j], wave[BULK_E + 2 * j + 1]);
    absorbed += 2 * m.n[i] * m.k[i] * std::norm(along);
  }
  return absorbed / std::hypot(s[0], s[1], s[2]);
}

constexpr double degenerate_gap = 1e-12;

json bulk_answer(const ProbeProblem& problem, const double* answer) {
  json modes = json::array();
  const double gap = std::hypot(answer[BULK_GAP], answer[BULK_GAP + 1]);
  for (int j = 0; j < 2; ++j) {
    const double* wave = answer + j * BULK_SCALARS;
    const Vector& s = problem.normal;
    const json ray = ray_of(wave + BULK_E, wave + BULK_H, {s[0], s[1], s[2]});
    modes.push_back({{"n", {wave[BULK_N], wave[BULK_N + 1]}},
                     {"E", complex_vector(wave + BULK_E)},
                     {"H", complex_vector(wave + BULK_H)},
                     {"D", complex_vector(wave + BULK_D)},
                     {"ray", ray},
                     {"degenerate", gap < degenerate_gap},
                     {"alpha_ray_over_k0", absorbed_along_ray(wave, problem.media[0])},
                     {"cos_walkoff", s[0] * ray[0].get<double>() + s[1] * ray[1].get<double>() +
                         s[2] * ray[2].get<double>()}});
  }
  return {{"id", problem.id}, {"modes", modes}};
}

json propagation_answer(const ProbeProblem& problem, const double* answer) {
  const double* d = answer + PROPAGATION_D_OUT;
  return {{"id", problem.id},
          {"n", {answer[PROPAGATION_N], answer[PROPAGATION_N + 2]}},
          {"retardance_rad", answer[PROPAGATION_RETARDANCE]},
          {"D_out", {{d[0], d[1]}, {d[2], d[3]}}}};
}

json parse(const std::string& text) {
  json input;
  try {
    input = json::parse(text);
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("the input is not JSON: ") + error.what());
  }
  if (!input.is_object() || !input.contains("interface") || !input["interface"].is_array())
    throw std::runtime_error("member 'interface' is missing: expected an object with an array of face problems");
  return input;
}

// The answers of all cases of one kind, in their order.
template <class Read, class Answer>
json solve_cases(const json& cases, const ProbeSolver& solve, Read read, Answer answer_of) {
  std::vector<ProbeProblem> problems;
  for (std::size_t i = 0; i < cases.size(); ++i) problems.push_back(read(cases[i], i));
  json answers = json::array();
  for (std::size_t begin = 0; begin < problems.size(); begin += problems_per_launch) {
    const std::size_t end = std::min(problems.size(), begin + problems_per_launch);
    std::vector<double> scalars;
    for (std::size_t i = begin; i < end; ++i)
      scalars.insert(scalars.end(), problems[i].scalars.begin(), problems[i].scalars.end());
    const std::vector<double> solved = solve(scalars);
    for (std::size_t i = begin; i < end; ++i)
      answers.push_back(answer_of(problems[i], solved.data() + (i - begin) * ANSWER_SCALARS));
  }
  return answers;
}

const json& cases_of(const json& input, const char* kind) {
  if (!input[kind].is_array()) throw std::runtime_error(fmt::format("member '{}': expected an array", kind));
  return input[kind];
}

}  // namespace

std::string answer_document(const std::string& text, const std::string& device, const std::string& real,
                            const ProbeSolver& solve) {
  const json input = parse(text);
  json output;
  output["device"] = device;
  output["real"] = real;
  output["interface"] = solve_cases(input["interface"], solve, read_face, face_answer);
  if (input.contains("bulk")) output["bulk"] = solve_cases(cases_of(input, "bulk"), solve, read_bulk, bulk_answer);
  if (input.contains("propagation"))
    output["propagation"] = solve_cases(cases_of(input, "propagation"), solve, read_propagation, propagation_answer);
  return output.dump(1, ' ');   // doubles as the shortest text that reads back to the same bits
}

}  // namespace nicol
