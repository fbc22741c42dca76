// libFuzzer's entry: any bytes are a scene; what parses must print and parse to the same.
#include <cstdlib>

#include "sdl/parse.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nicol::sdl;
  Options options;
  options.limits.steps = 20'000;
  options.limits.items = 20'000;
  options.debug = [](const std::string&) {};
  Result result;
  parse_text("fuzz.pov", std::string(reinterpret_cast<const char*>(data), size), options, result);
  const std::string told = result.diagnostics.text();
  if (result.diagnostics.failed()) return 0;
  std::size_t weight = 0;
  for (const Item& item : result.document.items) weight += item.block()->weight;
  if (weight > 2000) return 0;
  Result again;
  parse_text("again.pov", print(result.document), options, again);
  if (again.diagnostics.failed() || !equal(result.document, again.document)) std::abort();
  return 0;
}
