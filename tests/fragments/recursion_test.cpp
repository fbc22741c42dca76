// Functions that call themselves are found before a compiler gets them.
#include <doctest/doctest.h>

#include "host/fragments/recursion.hpp"

using nicol::find_recursion;

TEST_CASE("a function that calls itself, by itself or through others") {
  const auto direct = find_recursion("// one\nFUNCTION real\nrec(real a) { if (a) { return rec(a + 1); } return a; }\n");
  REQUIRE(direct);
  CHECK(direct->function == "rec");
  CHECK(direct->line == 3);
  const auto around = find_recursion("real b(real x);\nreal a(real x) { return b(x); }\nreal b(real x) { return c(x); }\n"
                                     "real c(real x) { return a(x) * b(x); }\n");
  REQUIRE(around);
  CHECK(around->function == "a");
  CHECK(around->line == 2);
}

TEST_CASE("calls of others, and what only looks like a call") {
  CHECK_FALSE(find_recursion("real a(real x) { return sqrt(x); }\nreal b(real x) { return a(a(x)); }\n"));
  CHECK_FALSE(find_recursion("real a(real x) { /* a(x) */ real a1 = x; // a(x)\n return a1 * (x); }\n"));
  CHECK_FALSE(find_recursion("typedef struct { real a; } pair;\nconstant real table[] = { (1), (2) };\nreal a(pair p) { return (p.a); }\n"));
  CHECK_FALSE(find_recursion(""));
  CHECK_FALSE(find_recursion("real a(real x) { return \"a(\" ; /* not closed"));
  CHECK_FALSE(find_recursion("}}}))) a( { a("));
}
