#include "tests/kernels/under_test.hpp"

namespace nicol::test {

const std::vector<const Kernels*>& all_kernels() {
  static const std::vector<const Kernels*> all{&float1, &float8, &double1, &double8};
  return all;
}

}  // namespace nicol::test
