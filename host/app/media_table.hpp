// A table of media: indices, birefringence, optic axes, activity, absorption, range and source.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"
#include "host/scene.hpp"

namespace nicol::app {

// `nicol explain --media`: of the media of a scene as it binds them, or of all that an include file
// declares (`.inc`; without a name, minerals.inc). Prints to standard output; errors to standard error.
int print_media(const ExplainCommand& command);

// The names that a library declares as interiors, in their order.
std::vector<std::string> declared_interiors(const std::string& text);

// One row of the table: "uniaxial +, active", "1.5443 1.5534", ... `at` indexes the wavelengths of
// the samples.
struct MediumRow {
  std::string name, kind, indices, birefringence, two_v, rotation, absorption, range, source;
};
MediumRow describe(const Medium& medium, const std::vector<double>& lambda_nm, std::size_t at);

}  // namespace nicol::app
