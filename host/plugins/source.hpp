// What plugins bring, as the rest of the program sees it: names, parameters and functions.
#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "host/plugins/parameters.hpp"
#include "host/scene.hpp"

namespace nicol::plugins {

// The message is complete and names the plugin's file.
struct PluginError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Entry {
  std::string name, meaning;
  std::string file;  // the shared object
  std::vector<Parameter> parameters;
};

// All functions throw PluginError.
struct Dispersion : Entry {
  struct Index {
    double n = 1, k = 0;
  };
  std::function<Index(const Values&, double lambda_nm)> at;  // n > 0, k >= 0
};
struct Spectrum : Entry {
  std::function<double(const Values&, double lambda_nm)> radiance;  // >= 0
};
using FindFile = std::function<std::string(const std::string& name)>;  // "" if there is none
using SolidShape = std::variant<ConvexShape, MeshShape>;
struct Solid : Entry {
  std::function<SolidShape(const Values&, const FindFile&)> make;  // in scene units
};

// Where a scene's plugins come from.
class PluginSource {
 public:
  virtual ~PluginSource() = default;
  // Throw PluginError: not found (with where it was looked for), not to be loaded, of another kind. What they return lasts as long
  // as the source.
  virtual const Dispersion& dispersion(const std::string& name) = 0;
  virtual const Spectrum& spectrum(const std::string& name) = 0;
  virtual const Solid& solid(const std::string& name) = 0;
};

}  // namespace nicol::plugins
