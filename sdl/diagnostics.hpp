// Errors and warnings of a scene: collected, all of them, and told with place, caret and macro calls.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tree.hpp"

namespace nicol::sdl {

enum class Severity { note, warning, error };

struct Diagnostic {
  Severity severity;
  std::string message;  // as POV-Ray words it after "Parse Error: "; hints on further lines
  Location where;
};

// The files read, and the chains of macro calls; resolves a Location to text.
class Sources {
 public:
  std::uint32_t add(std::string name, std::string text);
  const std::string& name(std::uint32_t file) const;
  std::string_view line(std::uint32_t file, std::uint32_t line) const;  // without its end
  // Records "macro NAME called from WHERE" and returns the index for Location::call.
  std::uint32_t push_call(std::string macro, Location from);
  struct Call {
    std::string macro;
    Location from;  // from.call leads to the caller's caller
  };
  const Call& call(std::uint32_t index) const;  // index >= 1

 private:
  struct File {
    std::string name, text;
    std::vector<std::size_t> line_starts;
  };
  std::vector<File> files_;
  std::vector<Call> calls_;
};

class Diagnostics {
 public:
  explicit Diagnostics(const Sources& sources) : sources_(sources) {}
  void note(Location where, std::string message);
  void warning(Location where, std::string message);
  void error(Location where, std::string message);
  bool failed() const { return error_count_ > 0; }
  std::size_t error_count() const { return error_count_; }
  const std::vector<Diagnostic>& all() const { return all_; }
  // First line in POV-Ray's form (File 'f.pov' line 3: Parse Error: ...), then the column, the source
  // line with a caret, and "in macro M called from 'f.pov' line 9" for each call.
  std::string text(const Diagnostic& diagnostic) const;
  std::string text() const;  // all, in the order they were found

 private:
  void add(Severity severity, Location where, std::string message);
  const Sources& sources_;
  std::vector<Diagnostic> all_;
  std::size_t error_count_ = 0;
};

// The candidate nearest to `word` by edit distance, or "" if none is near (for "did you mean").
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace nicol::sdl
