// What a fragment's text is asked before a compiler gets it: functions that call themselves, names that could meet another fragment's.
#include <doctest/doctest.h>

#include "host/fragments/source_text.hpp"

using namespace nicol;

namespace {

std::optional<NamedLine> find_recursion(const std::string& text) { return nicol::find_recursion(scan_source(text)); }

// "name:line" of what does not begin with aa; "" if all does.
std::string foreign(const std::string& text) {
  const auto at = find_foreign_name(scan_source(text), "aa");
  return at ? at->name + ":" + std::to_string(at->line) : "";
}

}  // namespace

TEST_CASE("a function that calls itself, by itself or through others") {
  const auto direct = find_recursion("// one\nFUNCTION real\nrec(real a) { if (a) { return rec(a + 1); } return a; }\n");
  REQUIRE(direct);
  CHECK(direct->name == "rec");
  CHECK(direct->line == 3);
  const auto around = find_recursion("real b(real x);\nreal a(real x) { return b(x); }\nreal b(real x) { return c(x); }\n"
                                     "real c(real x) { return a(x) * b(x); }\n");
  REQUIRE(around);
  CHECK(around->name == "a");
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

TEST_CASE("macros, types, constants and functions that could be another fragment's too") {
  CHECK(foreign("FUNCTION real aa_f(real x) { return x; }\nFUNCTION real helper(real x) { return x; }\n") == "helper:2");
  CHECK(foreign("// aa\n#define STEPS 7\n") == "STEPS:2");
  CHECK(foreign("\n#  define SQUARE(x) \\\n  ((x) * (x))\n") == "SQUARE:2");
  CHECK(foreign("typedef struct { real x, y; } pair;\n") == "pair:1");
  CHECK(foreign("typedef struct pair { real x, y; } aa_pair;\n") == "pair:1");
  CHECK(foreign("constant scalar aa_one = 1, *two = 0;\n") == "two:1");
  CHECK(foreign("constant scalar table[2] = {1, 2};\n") == "table:1");
  CHECK(foreign("enum aa_kind { aa_first, second = 3 };\n") == "second:1");
  CHECK(foreign("#ifdef X\nFUNCTION real aa(real x) { return x; }\n#endif\nFUNCTION vec3 one_more(void) { return vec(0, 0, 0); }") == "one_more:4");
}

TEST_CASE("names that stay in a fragment, and those that begin with its own") {
  CHECK(foreign("#define AA_STEPS 7\n#define SHORT 1\nFUNCTION real aaf(real x) { real y = x, z[2]; SHORT; return y; }\n#undef SHORT\n") == "");
  CHECK(foreign("typedef struct { real x, y[2]; } aa_pair;\nFUNCTION aa_pair aa_g(aa_pair p, real q) { aa_pair m = p; return m; }\n") == "");
  CHECK(foreign("constant scalar aa_table[] = {1, sqrt(2.0f)};\nconstant scalar aa_x = cos(1.0f), aa_y = aa_x;\nFUNCTION real sqrt_of(real x);\n") == "");
  CHECK(foreign("__attribute__((unused)) FUNCTION real aa(real x) { return other(x); }\n/* real helper(real x) { } */") == "");
  CHECK(foreign("real helper(real x) {") == "");   // not closed: for the compiler to tell
  CHECK(foreign("") == "");
}
