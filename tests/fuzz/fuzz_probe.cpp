// Any bytes are problems for the probe: read, packed, solved by the code of the kernels (as C++), told as
// JSON. Bad input is told as std::runtime_error; nothing crashes, hangs or is undefined.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/opencl/probe_document.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/native_probe.hpp"

namespace {

const std::vector<std::string> words = {
    "\"interface\"", "\"bulk\"", "\"propagation\"", "\"id\"", "\"medium\"", "\"medium1\"", "\"medium2\"", "\"incident\"",
    "\"N\"", "\"R\"", "\"quat_wxyz\"", "\"cls\"", "\"n_principal\"", "\"k_principal\"", "\"zeta_principal\"", "\"k\"",
    "\"E\"", "\"H\"", "\"s\"", "\"x\"", "\"d_m\"", "\"lambda_m\"", "\"D_in\"", "null", "true", "[]", "{}", "[0, 0, 1]",
    "\"uniaxial\"", "\"\\u0000\""};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::string answer;
  try {
    answer = nicol::answer_document(text, "none", "double", nicol::fuzz::solve_natively);
  } catch (const nlohmann::json::exception&) {
    std::abort();  // a member that was not looked at before it was read
  } catch (const std::runtime_error& error) {
    if (error.what()[0] == '\0') std::abort();
    return 0;
  }
  if (!nlohmann::json::accept(answer)) std::abort();
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return nicol::fuzz::mutate_input(data, size, most, seed, words);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size, const std::uint8_t* two,
                                                 std::size_t two_size, std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  return nicol::fuzz::cross_over(one, one_size, two, two_size, out, most, seed, words);
}
