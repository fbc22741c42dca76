// Places to text: first line in POV-Ray's form, then column, source line, caret, macro calls, hints.
#include "diagnostics.hpp"

#include <algorithm>

namespace nicol::sdl {

std::uint32_t Sources::add(std::string name, std::string text) {
  File file{std::move(name), std::move(text), {0}};
  for (std::size_t i = 0; i < file.text.size(); ++i) {
    if (file.text[i] == '\n') file.line_starts.push_back(i + 1);
  }
  files_.push_back(std::move(file));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

const std::string& Sources::name(std::uint32_t file) const {
  static const std::string nowhere = "?";
  return file < files_.size() ? files_[file].name : nowhere;
}

std::string_view Sources::line(std::uint32_t file, std::uint32_t line) const {
  if (file >= files_.size() || line < 1 || line > files_[file].line_starts.size()) return {};
  const File& f = files_[file];
  const std::size_t start = f.line_starts[line - 1];
  std::size_t end = line < f.line_starts.size() ? f.line_starts[line] - 1 : f.text.size();
  while (end > start && (f.text[end - 1] == '\n' || f.text[end - 1] == '\r')) --end;
  return std::string_view(f.text).substr(start, end - start);
}

std::uint32_t Sources::push_call(std::string macro, Location from) {
  calls_.push_back({std::move(macro), from});
  return static_cast<std::uint32_t>(calls_.size());
}

const Sources::Call& Sources::call(std::uint32_t index) const { return calls_.at(index - 1); }

void Diagnostics::add(Severity severity, Location where, std::string message) {
  if (severity == Severity::error) ++error_count_;
  all_.push_back({severity, std::move(message), where});
}
void Diagnostics::note(Location where, std::string message) {
  add(Severity::note, where, std::move(message));
}
void Diagnostics::warning(Location where, std::string message) {
  add(Severity::warning, where, std::move(message));
}
void Diagnostics::error(Location where, std::string message) {
  add(Severity::error, where, std::move(message));
}

namespace {

constexpr std::size_t excerpt_width = 100;

// The source line around the column, fit to be shown, and a caret under it.
std::string excerpt(std::string_view line, std::size_t column) {
  const std::size_t at = std::min(column > 0 ? column - 1 : 0, line.size());
  const std::size_t from = at > excerpt_width - 20 ? at - (excerpt_width - 20) : 0;
  std::string shown = "    ", caret = "    ";
  for (std::size_t i = from; i < std::min(line.size(), from + excerpt_width); ++i) {
    const auto c = static_cast<unsigned char>(line[i]);
    shown += c == '\t' ? ' ' : c < 32 || c == 127 ? '?' : line[i];
    // The caret counts characters: the bytes that continue a UTF-8 character take no room.
    if (i < at && (c & 0xC0) != 0x80) caret += ' ';
  }
  return shown + '\n' + caret + "^\n";
}

// The innermost calls and the outermost; of a deep recursion not all.
std::string calls_text(const Sources& sources, std::uint32_t innermost) {
  constexpr std::size_t most_first = 6, most_last = 2;
  std::vector<std::string> lines;
  for (std::uint32_t c = innermost; c != 0; c = sources.call(c).from.call) {
    const Sources::Call& call = sources.call(c);
    lines.push_back("  in macro " + call.macro + " called from '" + sources.name(call.from.file) +
                    "' line " + std::to_string(call.from.line) + '\n');
  }
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool shown = lines.size() <= most_first + most_last + 1 || i < most_first ||
                       i + most_last >= lines.size();
    if (shown) out += lines[i];
    else if (i == most_first)
      out += "  ... " + std::to_string(lines.size() - most_first - most_last) + " calls more\n";
  }
  return out;
}

const char* title(Severity severity) {
  switch (severity) {
    case Severity::note: return "Parse Note: ";
    case Severity::warning: return "Parse Warning: ";
    case Severity::error: break;
  }
  return "Parse Error: ";
}

}  // namespace

std::string Diagnostics::text(const Diagnostic& d) const {
  std::string out = "File '" + sources_.name(d.where.file) + "' line " +
                    std::to_string(d.where.line) + ": " + title(d.severity);
  const std::size_t first_end = d.message.find('\n');
  out += d.message.substr(0, first_end) + '\n';
  out += "  column " + std::to_string(d.where.column) + '\n';
  out += excerpt(sources_.line(d.where.file, d.where.line), d.where.column);
  out += calls_text(sources_, d.where.call);
  if (first_end != std::string::npos) out += "  " + d.message.substr(first_end + 1) + '\n';
  return out;
}

std::string Diagnostics::text() const {
  std::string out;
  for (const Diagnostic& d : all_) out += text(d);
  return out;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  const std::size_t allowed = word.size() <= 4 ? 1 : word.size() <= 8 ? 2 : 3;
  std::size_t best = allowed + 1;
  std::string_view found;
  std::vector<std::size_t> row;
  for (const std::string& candidate : candidates) {
    const std::size_t n = candidate.size(), m = word.size();
    if (candidate == word || n > m + allowed || m > n + allowed || n > 64) continue;
    row.resize(n + 1);
    for (std::size_t j = 0; j <= n; ++j) row[j] = j;
    for (std::size_t i = 1; i <= m; ++i) {  // Wagner and Fischer 1974, one row kept
      std::size_t corner = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= n; ++j) {
        const std::size_t above = row[j];
        const std::size_t change = corner + (word[i - 1] == candidate[j - 1] ? 0 : 1);
        row[j] = std::min({above + 1, row[j - 1] + 1, change});
        corner = above;
      }
    }
    if (row[n] < best && row[n] < std::max(m, n)) {
      best = row[n];
      found = candidate;
    }
  }
  return std::string(found);
}

}  // namespace nicol::sdl
