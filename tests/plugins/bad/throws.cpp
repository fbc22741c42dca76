// Throws in its entry, or in its callback.
#include <nicol_plugin.h>

#include <stdexcept>

namespace {

int burst(void*, const nicol_host_v1*, const nicol_values_v1*, double, double*, double*) {
  throw std::runtime_error("the lamp has burst");
}

}  // namespace

int nicol_plugin_v1(const nicol_host_v1* host) {
#ifdef BAD_THROWS_AT_ENTRY
  throw std::runtime_error("no lamp at all");
#endif
  nicol_dispersion_v1 formula{};
  formula.struct_size = sizeof formula;
  formula.name = NAME;
  formula.index = burst;
  return host->add_dispersion(host, &formula);
}
