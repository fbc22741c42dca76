// The physics held to textbooks, to the oracle and to conservation laws.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
