// What a sweep found, as a table, as CSV, as advice, and as a script for gnuplot.
#pragma once
#include <string>

#include "host/app/accuracy_sweep.hpp"

namespace nicol::app {

// What `nicol render` is to be told for a picture of this setting.
std::string render_command_text(const AccuracyCommand& command, const AccuracySetting& setting);

std::string accuracy_table(const AccuracyCommand& command, const Sweep& sweep);

// One line a setting, the reference first; relative errors as numbers (0.01 is 1 %).
std::string accuracy_csv(const AccuracyCommand& command, const Sweep& sweep);

// Error against time, both logarithmic. `terminal`: gnuplot's, to standard output.
std::string accuracy_plot(const AccuracyCommand& command, const Sweep& sweep, const std::string& terminal);

}  // namespace nicol::app
