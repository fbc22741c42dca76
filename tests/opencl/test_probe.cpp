// `probe`: the answers known in closed form, and what is said about bad input.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/opencl/probe.hpp"

using namespace nicol;
using nlohmann::json;

namespace {

constexpr double pi = 3.14159265358979323846;

json medium(const char* kind, double n, double k = 0, double zeta = 0) {
  return {{"cls", kind},
          {"n_principal", {n, n, n}},
          {"k_principal", {k, k, k}},
          {"zeta_principal", {zeta, zeta, zeta}}};
}

json complex3(double x, double y, double z) { return {{x, 0.0}, {y, 0.0}, {z, 0.0}}; }

// A wave in medium 1 of index n in the xz plane, at an angle to N = z. s: E along y; else E in the plane.
json face(const json& medium1, const json& medium2, double angle_rad, bool is_s) {
  const double n = medium1["n_principal"][0], sine = std::sin(angle_rad), cosine = std::cos(angle_rad);
  const json in_plane = complex3(cosine, 0, -sine), across = complex3(0, 1, 0);
  const json h_s = complex3(-n * cosine, 0, n * sine), h_p = complex3(0, n, 0);
  return {{"id", "case"},
          {"medium1", medium1},
          {"medium2", medium2},
          {"N", {0.0, 0.0, 1.0}},
          {"incident",
           {{"k", complex3(n * sine, 0, n * cosine)}, {"E", is_s ? across : in_plane}, {"H", is_s ? h_s : h_p}}}};
}

json answer(const json& one, bool real_double = true) {
  const auto device = open_device("0");
  return json::parse(probe(*device, json{{"interface", {one}}}.dump(), real_double))["interface"][0];
}

std::string error_of(const std::string& text) {
  try {
    probe(*open_device("0"), text, true);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string error_of_face(const json& one) { return error_of(json{{"interface", {one}}}.dump()); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("normal incidence on glass reflects ((n - 1) / (n + 1))^2") {
  const json one = face(medium("isotropic", 1), medium("isotropic", 1.52), 0, true);
  const double right = 0.52 * 0.52 / (2.52 * 2.52);
  const json in_double = answer(one), in_float = answer(one, false);
  CHECK(in_double["totals"]["R"].get<double>() == doctest::Approx(right).epsilon(1e-14));
  CHECK(in_float["totals"]["R"].get<double>() == doctest::Approx(right).epsilon(1e-6));
  CHECK(in_float["totals"]["R"].get<double>() != in_double["totals"]["R"].get<double>());   // two kernels, not one
  CHECK(in_double["totals"]["T"].get<double>() == doctest::Approx(1 - right).epsilon(1e-14));
}

TEST_CASE("nothing of p is reflected at Brewster's angle, all of s beyond the critical one") {
  const json air = medium("isotropic", 1), glass = medium("isotropic", 1.52);
  CHECK(answer(face(air, glass, std::atan(1.52), false))["totals"]["R"].get<double>() < 1e-28);
  const json total = answer(face(glass, air, 60 * pi / 180, true));
  CHECK(total["totals"]["R"].get<double>() == doctest::Approx(1).epsilon(1e-14));
  CHECK(total["waves"][2]["type"] == "evanescent");
  CHECK(total["waves"][0]["type"] == "propagating");
}

TEST_CASE("light enters a chiral medium as two circular waves of n - kappa and n + kappa") {
  const json both = answer(face(medium("isotropic", 1), medium("chiral", 1.5, 0, 1e-3), 0, true));
  std::vector<double> n;
  for (std::size_t w : {2u, 3u}) {
    n.push_back(both["waves"][w]["n_phase"]);
    CHECK(both["waves"][w]["power"].get<double>() == doctest::Approx(0.48).epsilon(1e-12));
  }
  CHECK(std::min(n[0], n[1]) == doctest::Approx(1.499).epsilon(1e-14));
  CHECK(std::max(n[0], n[1]) == doctest::Approx(1.501).epsilon(1e-14));
}

TEST_CASE("a crystal cut across its optic axis reflects as its ordinary index says, one cut along it as both do") {
  json crystal = medium("uniaxial", 1.6);
  crystal["n_principal"] = {1.6, 1.6, 1.5};
  crystal["R"] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto reflected = [](double n) { return (n - 1) * (n - 1) / ((n + 1) * (n + 1)); };
  for (const bool real_double : {true, false}) {
    const double tolerance = real_double ? 1e-13 : 2e-6;
    CHECK(answer(face(medium("isotropic", 1), crystal, 0, true), real_double)["totals"]["R"].get<double>() ==
          doctest::Approx(reflected(1.6)).epsilon(tolerance));
    json lying = crystal;   // optic axis along y, as E
    lying["R"] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    CHECK(answer(face(medium("isotropic", 1), lying, 0, true), real_double)["totals"]["R"].get<double>() ==
          doctest::Approx(reflected(1.5)).epsilon(tolerance));
  }
}

TEST_CASE("waves in the bulk, and a field carried through a quarter-wave plate") {
  json crystal = medium("biaxial", 1.6);
  crystal["n_principal"] = {1.5, 1.6, 1.7};
  crystal["R"] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const json bulk = {{"id", "b"}, {"medium", crystal}, {"s", {0, 0, 1}}};
  const json plate = {{"id", "p"},  {"medium", crystal}, {"s", {0, 0, 1}},        {"x", {1, 0, 0}},
                      {"d_m", 2.5e-6}, {"lambda_m", 1e-6}, {"D_in", {{1, 0}, {1, 0}}}};
  const json both = {{"interface", json::array()}, {"bulk", {bulk}}, {"propagation", {plate}}};
  const json out = json::parse(probe(*open_device("0"), both.dump(), true));
  const json modes = out["bulk"][0]["modes"];
  CHECK(modes[0]["n"][0].get<double>() == doctest::Approx(1.5).epsilon(1e-14));
  CHECK(modes[1]["n"][0].get<double>() == doctest::Approx(1.6).epsilon(1e-14));
  CHECK(modes[0]["cos_walkoff"].get<double>() == doctest::Approx(1).epsilon(1e-14));
  // y lags behind x by 2 pi 0.1 2.5 = pi/2
  const json d = out["propagation"][0]["D_out"];
  CHECK(d[0][0].get<double>() == doctest::Approx(std::sqrt(0.5)).epsilon(1e-12));
  CHECK(d[0][1].get<double>() == doctest::Approx(-std::sqrt(0.5)).epsilon(1e-12));
  CHECK(d[1][1].get<double>() == doctest::Approx(std::sqrt(0.5)).epsilon(1e-12));
}

TEST_CASE("answers come in the order of the cases") {
  json cases = json::array();
  for (int i = 0; i < 9; ++i) {
    cases.push_back(face(medium("isotropic", 1), medium(i % 3 == 1 ? "biaxial" : "isotropic", 1.1 + 0.1 * i), 0, true));
    cases.back()["id"] = std::to_string(i);
  }
  const json answers = json::parse(probe(*open_device("0"), json{{"interface", cases}}.dump(), true))["interface"];
  REQUIRE(answers.size() == 9);
  for (int i = 0; i < 9; ++i) {
    CHECK(answers[i]["id"] == std::to_string(i));
    const double r = (0.1 + 0.1 * i) / (2.1 + 0.1 * i);
    CHECK(answers[i]["totals"]["R"].get<double>() == doctest::Approx(r * r).epsilon(1e-12));
  }
}

TEST_CASE("bad input is told by case and member") {
  const json good = face(medium("isotropic", 1), medium("isotropic", 1.5), 0.3, true);
  REQUIRE(error_of_face(good).empty());
  CHECK(has(error_of("{\"interface\": [1,"), "not JSON"));
  CHECK(has(error_of("{\"interface\": [1e999]}"), "not JSON"));
  CHECK(has(error_of("[]"), "'interface' is missing"));
  CHECK(has(error_of("{\"interface\": [7]}"), "interface[0]: expected an object"));
  CHECK(has(error_of("{\"interface\": [{}]}"), "interface[0]: member 'id' is missing"));

  json bad = good;
  bad["incident"].erase("H");
  CHECK(error_of_face(bad) == "case 'case': incident: member 'H' is missing");
  bad = good;
  bad["N"] = {0, 0, 1.001};
  CHECK(has(error_of_face(bad), "case 'case': N: not a unit vector"));
  bad = good;
  bad["N"] = {0, 1};
  CHECK(error_of_face(bad) == "case 'case': N: expected 3 numbers, found 2 elements");
  bad = good;
  bad["incident"]["k"][1][0] = nullptr;
  CHECK(error_of_face(bad) == "case 'case': incident.k[1][0]: expected a number, found null");
  bad = good;
  bad["incident"]["E"][2] = {1};
  CHECK(has(error_of_face(bad), "incident.E[2]: expected 2 numbers (re, im), found 1 elements"));
  bad = good;
  bad["medium2"]["n_principal"][0] = -1.5;
  CHECK(has(error_of_face(bad), "medium2.n_principal: an index must be positive"));
  bad = good;
  bad["medium1"]["cls"] = 3;
  CHECK(has(error_of_face(bad), "medium1.cls: expected a text, found number"));
  bad = good;
  bad["incident"]["k"] = complex3(0, 0, 2);
  CHECK(has(error_of_face(bad), "incident.k: its length 2 is no index of medium1 (1)"));
  bad = good;
  bad["N"] = {0, 0, -1};
  CHECK(has(error_of_face(bad), "incident.E: E and H carry no power from medium1 to medium2"));
}
