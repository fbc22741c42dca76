// Eight lanes give bit for bit what one lane gives (C++ without contraction), each lane on its own.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/kernels/under_test.hpp"
#include "tests/kernels/vectors.hpp"

using namespace nicol::test;

TEST_CASE("eight lanes are eight times one lane") {
  const Kernels* pairs[2][2] = {{&float1, &float8}, {&double1, &double8}};
  for (const auto& pair : pairs) {
    const Kernels &one = *pair[0], &eight = *pair[1];
    CHECK(rc::check("lanes, " + eight.name, [&](unsigned seed) {
      Dice dice{seed};
      std::vector<FresnelCase> faces;
      std::vector<TurnCase> turns;
      std::vector<ActiveCase> active;
      for (int i = 0; i < 24; ++i) {
        const double n1 = 1 + dice(), n2 = 1 + dice();
        faces.push_back({n1 * dice(), (n2 - n1) * (n2 + n1), n1 * n1});
        turns.push_back({1000 * (dice() - 0.5), 20 * dice()});
        // lanes of one vector share their class
        active.push_back({n1, i < 8 ? 0 : 1e-3 * (0.1 + dice()), n2, i < 16 ? 1e-3 * (0.1 + dice()) : 0, n1 * (0.01 + 0.98 * dice()), i % 2});
      }
      const auto f1 = one.fresnel(faces), f8 = eight.fresnel(faces);
      const auto t1 = one.rotation(turns), t8 = eight.rotation(turns);
      const auto a1 = one.active_face(active), a8 = eight.active_face(active);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        RC_ASSERT(f1[i].r_s == f8[i].r_s);
        RC_ASSERT(f1[i].r_p == f8[i].r_p);
        RC_ASSERT(f1[i].t_s == f8[i].t_s);
        RC_ASSERT(f1[i].t_p == f8[i].t_p);
        RC_ASSERT(f1[i].p2 == f8[i].p2);
        RC_ASSERT(t1[i] == t8[i]);
        RC_ASSERT(a1[i].power == a8[i].power);
        RC_ASSERT(a1[i].t == a8[i].t);
      }
    }));
  }
}
