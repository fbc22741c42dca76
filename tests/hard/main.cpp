// nicol_hard [--group NAME] [--case NAME] [--list]: the table of hard cases; 1 if a bound is broken. --digest N: of
// the picture that way N draws, for repeat.cpp.
#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <string>

#include "tests/hard/bench.hpp"

using namespace nicol::hard;

namespace {

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto& part : {face_cases(), crystal_cases(), solid_cases(), path_cases(), sweep_cases(),
      repeat_cases()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

void run(const Case& one, Table& table) {
  for (const Way& way : all_ways()) {
    Bench bench(way, one.name, table);
    try {
      one.run(bench);
    } catch (const std::exception& error) {
      bench.hold(fmt::format("runs: {}", error.what()), "a case that fails is broken", 0, 1);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string group, name;
  bool list = false;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--list")) list = true;
    else if (!std::strcmp(argv[i], "--digest") && i + 1 < argc) {
      fmt::print("{}\n", picture_digest(all_ways().at(std::stoul(argv[++i])), 0.03));
      return 0;
    } else if (!std::strcmp(argv[i], "--group") && i + 1 < argc) group = argv[++i];
    else if (!std::strcmp(argv[i], "--case") && i + 1 < argc) name = argv[++i];
    else {
      fmt::print(stderr, "nicol_hard [--list] [--group NAME] [--case NAME]\n");
      return 1;
    }
  }
  Table table;
  std::size_t cases = 0;
  const auto start = std::chrono::steady_clock::now();
  for (const Case& one : all_cases()) {
    if ((!group.empty() && one.group != group) || (!name.empty() && one.name != name)) continue;
    ++cases;
    if (list) fmt::print("{:<10} {}\n", one.group, one.name);
    else run(one, table);
  }
  if (list) return 0;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}{} cases, {} quantities, {} numbers held; {} bounds broken; the worst takes {:.2g} of its bound; "
             "{:.0f} s\n",
             table.text(), cases, table.rows().size(), table.cells(), table.broken(), table.largest_share(), seconds);
  return cases > 0 && table.kept() ? 0 : 1;
}
