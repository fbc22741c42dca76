// Runs gnuplot on a script.
#pragma once
#include <stdexcept>
#include <string>

namespace nicol::app {

// The message is complete.
struct GnuplotError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What gnuplot writes to its standard output. GnuplotError where it is not installed or fails, with its own words.
std::string run_gnuplot(const std::string& script);

}  // namespace nicol::app
