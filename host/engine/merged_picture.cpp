// See merged_picture.hpp.
#include "host/engine/merged_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace nicol::engine {
namespace {

// "2 of 3" where the parts are shares i/n of the same n: which are not there.
std::string missing_shares(const std::vector<PartNote>& parts) {
  std::set<int> there;
  int n = 0;
  for (const PartNote& part : parts) {
    int i = 0, of = 0;
    char after = 0;
    if (std::sscanf(part.name.c_str(), "share %7d/%7d%c", &i, &of, &after) != 2 || (n != 0 && of != n)) return "";
    if (i < 1 || i > of) return "";
    n = of;
    there.insert(i);
  }
  constexpr int most_named = 20;
  const int missing = n - static_cast<int>(there.size());
  std::string text;
  for (int i = 1, named = 0; i <= n && named < most_named; ++i)
    if (there.count(i) == 0) text += fmt::format("{}{}/{}", named++ == 0 ? "" : ", ", i, n);
  if (missing > most_named) text += fmt::format(" and {} more", missing - most_named);
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
Notes joined_notes(const Merger& merger, const std::string& command_line, const Frame& frame) {
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
  notes.emplace_back("command", command_line);
  notes.emplace_back("parts", fmt::format("{}: {}", merger.parts().size(), names));
  notes.emplace_back("device", fmt::format("{}", fmt::join(devices, "; ")));
  notes.emplace_back("time", fmt::format("{:.3f} s in {} parts", seconds, merger.parts().size()));
  notes.emplace_back("cutOff", fmt::format("mean {:.3g}, worst {:.3g}", mean, worst));
  notes.emplace_back("counters", counted_text(merger.parts()));
  return notes;
}

}  // namespace

MergedPicture merge_parts(const std::vector<std::string>& paths, bool incomplete, const std::string& command_line) {
  Merger merger;
  for (const std::string& path : paths) merger.add(path);
  MergedPicture merged;
  merged.parts = merger.parts().size();
  merged.warnings = merger.warnings();
  merged.missing = merger.missing();
  if (!merged.missing.empty()) merged.missing += missing_shares(merger.parts());
  if (!merged.missing.empty() && !incomplete) return merged;
  merged.frame = merger.take();
  for (auto& note : joined_notes(merger, command_line, merged.frame)) merged.frame.how.push_back(std::move(note));
  if (merged.missing.empty())
    for (auto& note : notes_of_whole(merger.parts().front().whole)) merged.frame.how.push_back(std::move(note));
  return merged;
}

}  // namespace nicol::engine
