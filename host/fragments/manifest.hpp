// The manifest of a fragment: NAME.json beside NAME.cl. An object with the keys
//   name         of the fragment and of its function: letters, digits, _
//   version      a text
//   nicol        the version of the fragments' interface it was written for: 1 (kernels/fragment.h)
//   kind         "element" or "surface"
//   meaning      what it is, one sentence
//   source       of the physics and its numbers
//   parameters   [{ "name", "unit", "default", "min", "max", "meaning" }], numbers; without "default" a scene must say it
//   needs        of "fp64", and "reflection": an element that also reflects
//   reciprocal   false: it is not held to reciprocity (elements only; default true)
//   lossless     true: it is held to conserve energy (default false)
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "host/fragments/fragment.hpp"
#include "host/plugins/parameters.hpp"

namespace nicol {

// The message is whole: "wire_grid.json:3:5: ...".
struct ManifestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Manifest {
  std::shared_ptr<const Fragment> fragment;
  std::vector<plugins::Parameter> parameters;
};

// Of the file, and the OpenCL C beside it. Throws ManifestError.
Manifest read_manifest(const std::string& json_file);

}  // namespace nicol
