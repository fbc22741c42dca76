// Expands #include on the host. A file with an include guard is written out once, unless its first
// place stood in a conditional block that may be inactive.
#include "host/opencl/kernel_source.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "host/opencl/device.hpp"

namespace nicol {
namespace {

std::string embedded_file(const std::string& name) {
  for (const EmbeddedFile& file : embedded_kernels()) {
    if (file.name != name) continue;
    std::string text;
    for (std::string_view chunk : file.chunks) text += chunk;
    return text;
  }
  throw DeviceError(fmt::format("kernel file '{}' is not part of this program", name));
}

// True if the first two directives are #ifndef X, #define X.
bool is_guarded(const std::string& text) {
  std::istringstream in(text);
  std::string line, hash_ifndef, name, hash_define, defined;
  while (std::getline(in, line) && (line.empty() || line[0] != '#')) {
  }
  std::istringstream(line) >> hash_ifndef >> name;
  std::getline(in, line);
  std::istringstream(line) >> hash_define >> defined;
  return hash_ifndef == "#ifndef" && hash_define == "#define" && !name.empty() && name == defined;
}

class Expander {
 public:
  explicit Expander(const std::string& fragments) : fragments_(fragments) {}
  std::string expand(const std::string& name) {
    add(name, "", 0, true);
    return out_.str();
  }

 private:
  void add(const std::string& name, const std::string& from, int from_line, bool unconditional);

  std::string text_of(const std::string& name) const {
    return name == "scene_fragments.h" && !fragments_.empty() ? fragments_ : kernel_file(name);
  }

  const std::string& fragments_;
  std::ostringstream out_;
  std::set<std::string> done_;
  std::vector<std::string> open_;
};

void Expander::add(const std::string& name, const std::string& from, int from_line, bool unconditional) {
  static const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)".*)re");
  static const std::regex block_start(R"(^\s*#\s*if.*)"), block_end(R"(^\s*#\s*endif.*)");
  for (const std::string& outer : open_)
    if (outer == name) throw DeviceError(fmt::format("{}:{}: '{}' includes itself", from, from_line, name));
  const std::string text = text_of(name);
  const bool guarded = is_guarded(text);
  if (guarded && done_.count(name)) return;
  if (guarded && unconditional) done_.insert(name);
  open_.push_back(name);
  out_ << "#line 1 \"" << name << "\"\n";
  std::istringstream in(text);
  std::string line;
  int depth = guarded ? -1 : 0;
  for (int number = 1; std::getline(in, line); ++number) {
    std::smatch found;
    if (line.find('#') == std::string::npos) {
      out_ << line << '\n';
    } else if (std::regex_match(line, found, include)) {
      add(found[1], name, number, unconditional && depth == 0);
      out_ << "#line " << number + 1 << " \"" << name << "\"\n";
    } else {
      depth += std::regex_match(line, block_start) ? 1 : std::regex_match(line, block_end) ? -1 : 0;
      out_ << line << '\n';
    }
  }
  open_.pop_back();
}

}  // namespace

std::string kernel_file(const std::string& name) {
  const char* folder = std::getenv("NICOL_KERNEL_DIR");
  if (folder && *folder) {
    std::ifstream in(std::string(folder) + "/" + name, std::ios::binary);
    std::ostringstream text;
    if (in && text << in.rdbuf()) return text.str();
  }
  return embedded_file(name);
}

std::string expand_includes(const std::string& name, const std::string& fragments) { return Expander(fragments).expand(name); }

}  // namespace nicol
