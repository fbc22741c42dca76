// Rows of `nicol explain --media`.
#include <doctest/doctest.h>

#include "host/app/media_table.hpp"

namespace nicol::app {

namespace {

Medium crystal(Medium::Symmetry symmetry, double n0, double n1, double n2) {
  Medium m;
  m.name = "test";
  m.symmetry = symmetry;
  m.n = {Samples{n0}, Samples{n1}, Samples{n2}};
  m.k.fill(Samples{0});
  m.rotation_deg_per_mm = {0};
  return m;
}

}  // namespace

TEST_CASE("media table: quartz") {
  Medium m = crystal(Medium::Symmetry::uniaxial, 1.54424, 1.54424, 1.55338);
  m.gyration.fill(Samples{0});
  m.gyration[2] = {1.0971e-4};
  m.range_nm = {200, 2000};
  const MediumRow row = describe(m, {589.3}, 0);
  CHECK(row.kind == "uniaxial +, active");
  CHECK(row.indices == "1.5442 1.5534");
  CHECK(row.birefringence == "0.0091");
  CHECK(row.two_v == "");
  CHECK(row.rotation == "21.70");
  CHECK(row.absorption == "");
  CHECK(row.range == "200 to 2000");
}

TEST_CASE("media table: class mm2 turns along its two optic axes in opposite senses") {
  Medium m = crystal(Medium::Symmetry::biaxial, 1.5301, 1.6815, 1.6858);
  m.gyration.fill(Samples{0});
  m.gyration[4] = {1e-4};
  const MediumRow row = describe(m, {589.3}, 0);
  CHECK(row.kind == "biaxial -, active");
  CHECK(row.two_v == "17.8");
  // tan V = (1.6858/1.5301) sqrt(0.486241/0.0144794): V = 81.098 deg. g = 2 g13 sin V cos V = 3.0575e-5,
  // and 180 g/(1.6815 x 589.3e-6 mm) = 5.554.
  CHECK(row.rotation == "5.55 -5.55");
}

TEST_CASE("media table: indices that cross, absorption where it is strongest") {
  Medium m = crystal(Medium::Symmetry::biaxial, 1.6, 1.5, 1.55);
  m.k = {Samples{0, 1e-4}, Samples{0, 2e-4}, Samples{3e-4, 0}};
  for (Samples& n : m.n) n.push_back(n[0]);
  const MediumRow row = describe(m, {500, 600}, 0);
  CHECK(row.birefringence == "0.1000");
  CHECK(row.absorption == "0 0 7.54 at 500 nm");
}

TEST_CASE("media table: interiors that a library declares") {
  const auto names = declared_interiors(
      "#declare A = interior {\n//#declare B = interior {\n#declare C = interior{ ior 1 }\n"
      "#declare D = index { }\n #declare  E  =  interior");
  CHECK(names == std::vector<std::string>{"A", "C", "E"});
}

}  // namespace nicol::app
