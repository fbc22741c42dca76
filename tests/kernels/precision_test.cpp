// Faces in single against double precision where digits are hardest to keep. Both get the same input, rounded to
// float; 99.9 of 100 faces stay within the budget of their stratum.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "host/opencl/probe_problem.hpp"
#include "kernels/probe_abi.h"
#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol::test;
using nicol::Vec3;
using nlohmann::json;

namespace {

Vec3 any_unit(Dice& dice) {
  const double z = 2 * dice() - 1, azimuth = 2 * pi * dice(), r = std::sqrt(1 - z * z);
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}
Vec3 across(const Vec3& s, Dice& dice) {
  const Vec3 v = any_unit(dice);
  return unit(plus(v, scaled(-dot(v, s), s)));
}
json listed(const Vec3& v) { return {v.x, v.y, v.z}; }

// Principal indices on axes x, y, c.
json material(const std::array<double, 3>& n, const Vec3& a, const Vec3& c, double zeta = 0) {
  const Vec3 b = cross(c, a);
  return {{"cls", "any"},
          {"n_principal", n},
          {"k_principal", {0, 0, 0}},
          {"zeta_principal", {zeta, zeta, -1.898 * zeta}},
          {"R", {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}}};
}
json upright(const std::array<double, 3>& n, double zeta = 0) { return material(n, {1, 0, 0}, {0, 0, 1}, zeta); }

json complex3(const std::vector<double>& v, std::size_t at) { return {{v[at], v[at + 1]}, {v[at + 2], v[at + 3]},
    {v[at + 4], v[at + 5]}}; }

struct Incidence {
  json one, two;
  Vec3 s;
  double q = -1;  // tangential wave vector; negative: any normal
};

// Largest of the errors of R, T and E_t; negative if the light does not come in.
double error_in_float(const Incidence& in, Dice& dice) {
  const json bulk = {{"id", "b"}, {"medium", in.one}, {"s", listed(in.s)}};
  const std::vector<double> waves = double1.solve(nicol::read_bulk(bulk, 0).scalars);
  const std::size_t at = dice() < 0.5 ? 0 : BULK_SCALARS;
  const double n = waves[at + BULK_N], sine = in.q / n;
  if (sine >= 1) return -1;
  Vec3 normal = any_unit(dice);
  if (in.q >= 0) normal = unit(plus(scaled(std::sqrt(1 - sine * sine), in.s), scaled(sine, across(in.s, dice))));
  else if (dot(normal, in.s) < 0) normal = scaled(-1, normal);
  const json face = {{"id", "f"},
                     {"medium1", in.one},
                     {"medium2", in.two},
                     {"N", listed(normal)},
                     {"incident",
                      {{"k", {{n * in.s.x, 0}, {n * in.s.y, 0}, {n * in.s.z, 0}}},
                       {"E", complex3(waves, at + BULK_E)},
                       {"H", complex3(waves, at + BULK_H)}}}};
  nicol::ProbeProblem problem;
  try {
    problem = nicol::read_face(face, 0);
  } catch (const std::runtime_error&) {
    return -1;  // the ray runs away from the face
  }
  for (int i = PROBE_NORMAL; i < PROBE_BRACKET1; ++i) problem.scalars[i] = static_cast<float>(problem.scalars[i]);
  const std::vector<double> fine = double1.solve(problem.scalars), rough = float1.solve(problem.scalars);
  double error = std::max(std::fabs(fine[ANSWER_R] - rough[ANSWER_R]), std::fabs(fine[ANSWER_T] - rough[ANSWER_T]));
  double field = 0;
  for (int i = 0; i < 6; ++i) field += std::pow(fine[ANSWER_E_T + i] - rough[ANSWER_E_T + i], 2);
  error = std::max(error, std::sqrt(field));
  return std::isnan(error) ? 1e9 : error;
}

template <class Next>
void hold(const char* name, double budget, Next next) {
  Dice dice{2024};
  std::vector<double> errors;
  for (int trial = 0; trial < 20000 && errors.size() < 3000; ++trial) {
    const double error = error_in_float(next(dice), dice);
    if (error >= 0) errors.push_back(error);
  }
  REQUIRE(errors.size() >= 1500);
  std::sort(errors.begin(), errors.end());
  const double most = errors[static_cast<std::size_t>(0.999 * static_cast<double>(errors.size()))];
  MESSAGE(std::string(name) << ": median " << errors[errors.size() / 2] << ", 99.9 % " << most << ", largest " << errors.back());
  CHECK(most < budget);
}

const std::array<double, 3> aragonite{1.530, 1.681, 1.685}, topaz{1.606, 1.609, 1.616}, quartz{1.5442, 1.5442, 1.5533};

double any_distance(Dice& dice, double least, double most) { return least * std::pow(most / least, dice()); }

// Wave normal `angle` from the binormal in the plane of the least and the largest index.
Vec3 near_binormal(const std::array<double, 3>& n, double angle, Dice& dice) {
  const auto square = [](double x) { return x * x; };
  const double cosine = n[0] / n[1] * std::sqrt((square(n[2]) - square(n[1])) / (square(n[2]) - square(n[0])));
  const Vec3 axis{std::sqrt(1 - cosine * cosine), 0, cosine};
  return unit(plus(axis, scaled(angle, across(axis, dice))));
}

}  // namespace

TEST_CASE("single precision where digits are hardest to keep") {
  const json air = upright({1, 1, 1});
  hold("air to aragonite", 1e-6, [&](Dice& d) { return Incidence{air, upright(aragonite), any_unit(d)}; });
  hold("air to weak biaxial", 1e-6, [&](Dice& d) { return Incidence{air, upright({1.55, 1.5500003, 1.550001}),
      any_unit(d)}; });
  hold("aragonite to air", 1e-5, [&](Dice& d) { return Incidence{upright(aragonite), air, any_unit(d), 0.98 * d()}; });
  hold("aragonite to air, total", 1e-5, [&](Dice& d) { return Incidence{upright(aragonite), air, any_unit(d),
      1.02 + 0.45 * d()}; });
  hold("active quartz to air", 1e-5, [&](Dice& d) { return Incidence{upright(quartz, 3.552e-5), air, any_unit(d),
      0.98 * d()}; });
  // p2^2 = p1^2 + bracket, the bracket known to 2^-24: p2 to 3e-4 at the critical angle, E_t of p light to ten times
  // that
  hold("topaz to air, 1e-7 to 1e-2 from critical", 4e-3, [&](Dice& d) {
    return Incidence{upright(topaz), air, any_unit(d), 1 + (d() < 0.5 ? 1 : -1) * any_distance(d, 1e-7, 1e-2)};
  });
  // all angles, critical ones among them
  const std::array<double, 3> strong{1.5, 1.9, 2.4};
  hold("diamond to a crystal of 1.5, 1.9, 2.4", 1e-4, [&](Dice& d) { return Incidence{upright({2.42, 2.42, 2.42}),
      upright(strong), any_unit(d)}; });
  hold("a crystal of 1.5, 1.9, 2.4 to air", 1e-4, [&](Dice& d) { return Incidence{upright(strong), air, any_unit(d),
      1.45 * d()}; });
  hold("twin of topaz", 4e-4, [&](Dice& d) {
    const Vec3 c = any_unit(d);
    return Incidence{upright(topaz), material(topaz, across(c, d), c), any_unit(d)};
  });
  hold("aragonite near its binormal, to air", 6e-4, [&](Dice& d) {
    return Incidence{upright(aragonite), air, near_binormal(aragonite, any_distance(d, 1e-7, 1e-2), d), 0.95 * d()};
  });
}
