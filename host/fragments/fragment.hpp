// A fragment: optics of a surface or a polarizing element that a plugin brings as OpenCL C. What kernels/fragment.h asks of its
// source, and what its manifest says of it.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace nicol {

struct Fragment {
  enum class Kind {
    element,  // a sheet without thickness: passes light, and may throw it back
    surface   // a face between isotropic media, in place of Fresnel's
  };
  Kind kind = Kind::element;
  std::string name, version, meaning, source;  // source: of the physics and its numbers
  std::string file, text;                      // where the OpenCL C lies, and what it says
  std::vector<std::string> parameters;         // names, as P_name in the text
  bool reflects = false;                       // an element that also reflects
  bool needs_fp64 = false;
  bool reciprocal = true, lossless = false;    // what it is held to
};

}  // namespace nicol
