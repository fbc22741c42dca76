// `nicol accuracy`: what accuracy costs in time. Table to standard output, CSV and plots to files.
#include "host/app/accuracy_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "host/app/accuracy_report.hpp"
#include "host/app/accuracy_sweep.hpp"
#include "host/app/gnuplot.hpp"
#include "host/app/interrupt.hpp"
#include "host/app/progress_bar.hpp"
#include "host/app/told_scene.hpp"
#include "host/output/atomic_file.hpp"

namespace nicol::app {
namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& bytes) {
  AtomicFile file(path.string());
  file.write(bytes.data(), bytes.size());
  file.commit();
}

fs::path csv_path(const AccuracyCommand& command) {
  if (command.output.empty()) return fs::path(command.scene).stem().string() + "_accuracy.csv";
  fs::path path = command.output;
  if (path.extension() != ".csv")
    throw UsageError(fmt::format("-o {}: the table is written as .csv; the plots lie beside it", command.output));
  return path;
}

// Before anything is rendered; the trials go away again.
void check_targets(const fs::path& csv) {
  for (const char* suffix : {".csv", ".png", ".svg"})
    AtomicFile trial(fs::path(csv).replace_extension(suffix).string());
}

void write_plots(const AccuracyCommand& command, const Sweep& sweep, const fs::path& csv) {
  const struct {
    const char *suffix, *terminal;
  } plots[] = {{".png", "pngcairo size 1200,800 font 'Sans,12'"},
               {".svg", "svg size 1200,800 font 'Sans,14' background '#FFFFFF'"}};
  for (const auto& plot : plots) {
    const fs::path path = fs::path(csv).replace_extension(plot.suffix);
    write_file(path, run_gnuplot(accuracy_plot(command, sweep, plot.terminal)));
    fmt::print(stderr, "{}\n", path.string());
  }
}

void check_numbers(const AccuracyCommand& command) {
  if (!(command.longest_seconds > 0)) throw UsageError("--longest takes seconds greater than 0");
  if (!(command.reference_step_nm > 0)) throw UsageError("--reference-step takes nanometres greater than 0");
  parse_relative_error(command.reference_error);
}

}  // namespace

std::vector<std::string> accuracy_knobs() {
  std::vector<std::string> names;
  for (const Knob knob : {Knob::wavelengths, Knob::depth, Knob::cut_off, Knob::precision, Knob::samples, Knob::adaptive,
                          Knob::effects, Knob::combined})
    names.push_back(knob_name(knob));
  return names;
}

int accuracy_command(const AccuracyCommand& command) {
  check_numbers(command);
  const fs::path csv = csv_path(command);
  check_targets(csv);
  const auto loaded = load_and_tell(command.scene, command.options, Expectations::where_they_apply);
  if (!loaded) return exit_error;
  const auto device = open_wanted_device(command.device);
  const std::atomic<bool>& cancel = finish_first();
  Sweep sweep;
  {
    ProgressBar bar(!command.quiet);
    sweep = run_sweep(command, *loaded, *device, cancel, bar);
  }
  if (sweep.measurements.empty()) {
    fmt::print(stderr, "nicol: interrupted before anything was measured\n");
    return exit_interrupted;
  }
  fmt::print("{}", accuracy_table(command, sweep));
  std::fflush(stdout);
  write_file(csv, accuracy_csv(command, sweep));
  fmt::print(stderr, "{}\n", csv.string());
  try {
    write_plots(command, sweep, csv);
  } catch (const GnuplotError& error) {
    fmt::print(stderr, "nicol: {}\n", error.what());
  }
  return sweep.interrupted ? exit_interrupted : exit_done;
}

}  // namespace nicol::app
