// `nicol expect`: the numbers that scenes must give, held against what they give.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "host/app/commands.hpp"
#include "host/app/expectations.hpp"
#include "host/app/told_scene.hpp"

namespace nicol::app {
namespace {

std::string numbers(const std::vector<double>& values) {
  return fmt::format("{:.7g}", fmt::join(values, ", "));
}

void print_outcome(const LoadedScene& loaded, const Expectation& expectation,
                   const Outcome& outcome) {
  std::string what = quantity_name(expectation.quantity);
  if (expectation.lambda_nm > 0) what += fmt::format(" at {:g} nm", expectation.lambda_nm);
  if (expectation.length_mm > 0) what += fmt::format(", {:g} mm", expectation.length_mm);
  fmt::print("  {}  {}  {} in ({:g}, {:g})\n", outcome.pass ? "pass" : "FAIL",
             loaded.place(expectation.where), what, expectation.at[0], expectation.at[1]);
  fmt::print("        expected {} within {:g}{}", numbers(expectation.value), expectation.tolerance,
             expectation.relative ? " of it" : "");
  if (!outcome.value.empty()) fmt::print(", is {}", numbers(outcome.value));
  if (!outcome.difference.empty())
    fmt::print(", off by {:.3g}", fmt::join(outcome.difference, ", "));
  if (!outcome.reason.empty()) fmt::print(": {}", outcome.reason);
  fmt::print("\n");
  if (!expectation.source.empty()) fmt::print("        source: {}\n", expectation.source);
}

// Answers how many failed.
int print_all(const LoadedScene& loaded, Device& device, const DeviceOptions& options) {
  const std::vector<Outcome> outcomes =
      evaluate_expectations(loaded, device, kernel_options(options));
  int failures = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    print_outcome(loaded, loaded.scene.expectations[i], outcomes[i]);
    if (!outcomes[i].pass) ++failures;
  }
  fmt::print("{} in {}: {} of {} hold\n", loaded.scene.path, options.real,
             outcomes.size() - static_cast<std::size_t>(failures), outcomes.size());
  std::fflush(stdout);
  return failures;
}

// Both: what the device has of the two.
std::vector<std::string> wanted_reals(const DeviceOptions& options, const Device& device) {
  if (options.real != "both") return {options.real};
  if (info(device).has_fp64) return {"double", "float"};
  fmt::print(stderr, "nicol: {} has no double precision; float only\n", info(device).name);
  return {"float"};
}

// Answers whether all of the scene's expectations hold.
bool holds(const LoadedScene& loaded, DeviceOptions options) {
  const auto device = open_wanted_device(options);
  int failures = 0;
  for (const std::string& real : wanted_reals(options, *device)) {
    options.real = real;
    failures += print_all(loaded, *device, options);
  }
  return failures == 0;
}

}  // namespace

int expect_command(const ExpectCommand& command) {
  int code = exit_done;
  for (const std::string& path : command.scenes) {
    const auto loaded = load_and_tell(path, command.options, Expectations::always);
    if (!loaded) {
      code = exit_error;
    } else if (loaded->scene.expectations.empty()) {
      fmt::print("{}: expects nothing\n", path);
    } else if (!holds(*loaded, command.device)) {
      code = exit_error;
    }
  }
  return code;
}

}  // namespace nicol::app
