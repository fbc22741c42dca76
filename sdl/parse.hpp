// Scene text to tree.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics.hpp"
#include "tree.hpp"

namespace nicol::sdl {

// Hostile text meets these and becomes an error, never a crash or a hang.
struct Limits {
  std::size_t file_bytes = 64u << 20;
  std::size_t total_bytes = 256u << 20;
  int include_depth = 64;
  int macro_depth = 96;          // POV-Ray's own is about 95
  int nesting_depth = 256;       // blocks, parentheses, brackets
  std::size_t steps = 200'000'000;  // tokens handed out, over loops and macros
  std::size_t items = 8'000'000;   // items in the tree, array elements and string bytes together
};

struct Options {
  std::vector<std::string> library_paths;      // +L, after the working directory
  std::map<std::string, double> declares;      // Declare=name=value
  double image_width = 640, image_height = 480;
  double clock = 0, clock_delta = 0, initial_clock = 0, final_clock = 0;
  double frame_number = 0, initial_frame = 0, final_frame = 0;
  std::vector<std::string> reserved;           // words that a scene may not declare
  std::size_t most_errors = 100;               // then the parse ends
  Limits limits;
  std::function<void(const std::string&)> debug;  // what #debug prints; default: standard error
  // The text of an include file by the name that the scene gives it, asked once for each name before files are looked for; none: a file.
  std::function<std::optional<std::string>(const std::string& name)> include;
};

struct Result {
  Sources sources;
  Diagnostics diagnostics{sources};
  Document document;
  Result() = default;
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
};

// Parses the file, or text under the name given. Never throws for bad input: see diagnostics.
// The tree holds what could be read, so that later stages can report more errors in one go.
void parse_file(const std::string& path, const Options& options, Result& result);
void parse_text(const std::string& name, std::string text, const Options& options, Result& result);

}  // namespace nicol::sdl
