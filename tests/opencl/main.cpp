// Runs with caches of its own, so that nothing warm hides a cold start and nothing is left behind.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <stdlib.h>

#include <filesystem>

#include "host/opencl/render.hpp"

int main(int argc, char** argv) {
  if (const auto code = nicol::serve_as_builder(argc, argv)) return *code;
  char folder[] = "/tmp/nicol-opencl-test-XXXXXX";
  if (!mkdtemp(folder)) return 1;
  setenv("XDG_CACHE_HOME", folder, 1);
  setenv("POCL_CACHE_DIR", (std::string(folder) + "/pocl").c_str(), 1);
  unsetenv("NICOL_KERNEL_DIR");
  const int result = doctest::Context(argc, argv).run();
  std::filesystem::remove_all(folder);
  return result;
}
