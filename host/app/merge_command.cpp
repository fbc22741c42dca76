// `nicol merge`: parts of a picture to the whole.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

#include "host/app/commands.hpp"
#include "host/output/merge.hpp"

namespace nicol::app {
namespace {

// "2 of 3" where the parts are shares i/n of the same n: which are not there.
std::string missing_shares(const std::vector<PartNote>& parts) {
  std::set<int> there;
  int n = 0;
  for (const PartNote& part : parts) {
    int i = 0, of = 0;
    char after = 0;
    if (std::sscanf(part.name.c_str(), "share %d/%d%c", &i, &of, &after) != 2 || (n != 0 && of != n)) return "";
    n = of;
    there.insert(i);
  }
  std::string text;
  for (int i = 1; i <= n; ++i)
    if (there.count(i) == 0) text += fmt::format("{}{}/{}", text.empty() ? "" : ", ", i, n);
  return text.empty() ? "" : " (part " + text + ")";
}

std::string counted_text(const std::vector<PartNote>& parts) {
  static constexpr const char* names[] = {"not a number", "energy", "stack", "Stokes", "precise wave solver"};
  std::string text;
  for (std::size_t k = 0; k < std::size(names); ++k) {
    std::uint64_t sum = 0;
    for (const PartNote& part : parts) sum += k < part.counted.size() ? part.counted[k] : 0;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names[k], sum);
  }
  return text;
}

// What one run would say, and how many runs there were.
Notes joined_notes(const Merger& merger, const MergeCommand& command, const Frame& frame) {
  std::string names;
  std::set<std::string> devices;
  double seconds = 0, mean = 0, worst = 0;
  for (const PartNote& part : merger.parts()) {
    names += (names.empty() ? "" : " + ") + part.name;
    devices.insert(part.device);
    seconds += part.seconds;
  }
  for (const float value : frame.cut_off) {
    mean += static_cast<double>(value) / static_cast<double>(frame.plane());
    worst = std::max(worst, static_cast<double>(value));
  }
  Notes notes;
  for (const char* key : {"scene", "version", "settings", "features", "frame"})
    if (const auto found = merger.notes().find(key); found != merger.notes().end()) notes.emplace_back(key, found->second);
  notes.emplace_back("command", command.command_line);
  notes.emplace_back("parts", fmt::format("{}: {}", merger.parts().size(), names));
  notes.emplace_back("device", fmt::format("{}", fmt::join(devices, "; ")));
  notes.emplace_back("time", fmt::format("{:.3f} s in {} parts", seconds, merger.parts().size()));
  notes.emplace_back("cutOff", fmt::format("mean {:.3g}, worst {:.3g}", mean, worst));
  notes.emplace_back("counters", counted_text(merger.parts()));
  return notes;
}

}  // namespace

int merge_command(const MergeCommand& command) {
  std::vector<std::unique_ptr<FrameSink>> sinks;
  for (const std::string& path : command.outputs) sinks.push_back(make_sink(path));
  const auto start = std::chrono::steady_clock::now();
  Merger merger;
  for (const std::string& path : command.parts) merger.add(path);
  for (const std::string& warning : merger.warnings()) fmt::print(stderr, "warning: {}\n", warning);
  const std::string missing = merger.missing();
  if (!missing.empty()) {
    fmt::print(stderr, "nicol: missing: {}{}\n", missing, missing_shares(merger.parts()));
    if (!command.incomplete) {
      fmt::print(stderr, "nicol: nothing written; --incomplete writes what there is\n");
      return exit_error;
    }
  }
  Frame frame = merger.take();
  for (auto& note : joined_notes(merger, command, frame)) frame.how.push_back(std::move(note));
  for (const auto& sink : sinks) sink->write(frame);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!command.quiet)
    fmt::print(stderr, "{}: {} parts, {}x{} pixels, {} wavelengths; merged in {:.2f} s\n", command.outputs.front(),
               merger.parts().size(), frame.width, frame.height, frame.lambda_nm.size(), taken.count());
  return exit_done;
}

}  // namespace nicol::app
