// See source_text.hpp.
#include "host/fragments/source_text.hpp"

#include <algorithm>
#include <cctype>

namespace nicol {
namespace {

using Token = SourceToken;

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_name(const Token& token) { return in_name(token.text[0]) && !std::isdigit(static_cast<unsigned char>(token.text[0])); }

// How far a comment or a text in quotes that begins at `at` goes; 0 if none does.
std::size_t passed_over(std::string_view text, std::size_t at) {
  const auto end = [&](std::string_view mark, std::size_t from) {
    const std::size_t found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  if (text.substr(at, 2) == "//") return end("\n", at) - at - (end("\n", at) < text.size() ? 1 : 0);
  if (text.substr(at, 2) == "/*") return end("*/", at + 2) - at;
  if (text[at] == '"') return end("\"", at + 1) - at;
  return 0;
}

// The tokens of the text, those of preprocessor lines apart: each line a list that begins behind its #.
struct Lexed {
  std::vector<Token> tokens;
  std::vector<std::vector<Token>> directives;
};

Lexed lex(std::string_view text) {
  Lexed lexed;
  int line = 1;
  bool directive = false, line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t size = passed_over(text, at);
    if (size > 0) {
      line += static_cast<int>(std::count(text.begin() + at, text.begin() + at + size, '\n'));
      at += size;
      continue;
    }
    size = 1;
    if (text.substr(at, 2) == "\\\n") {   // the line goes on
      size = 2;
      ++line;
    } else if (text[at] == '\n') {
      directive = false;
      line_begins = true;
      ++line;
    } else if (text[at] == '#' && line_begins) {
      directive = true;
      lexed.directives.emplace_back();
    } else if (!std::isspace(static_cast<unsigned char>(text[at]))) {
      while (in_name(text[at]) && at + size < text.size() && in_name(text[at + size])) ++size;
      (directive ? lexed.directives.back() : lexed.tokens).push_back({text.substr(at, size), line});
      line_begins = false;
    }
    at += size;
  }
  return lexed;
}

std::vector<Token> macros_of(const std::vector<std::vector<Token>>& directives) {
  std::vector<Token> macros;
  for (const auto& words : directives) {
    if (words.size() < 2) continue;
    if (words[0].text == "define") macros.push_back(words[1]);
    if (words[0].text == "undef")
      macros.erase(std::remove_if(macros.begin(), macros.end(), [&](const Token& m) { return m.text == words[1].text; }), macros.end());
  }
  return macros;
}

// Goes through the tokens once. A name before parentheses outside of all braces, with a body behind them, is a function; names before
// parentheses inside are what it calls. Outside of all braces and parentheses a name behind another (or behind * or }) that ends at
// one of = [ ; , is declared, and so is one between struct, union or enum and a brace.
class Scanner {
 public:
  Scanner(const std::vector<Token>& tokens, SourceText& source) : tokens_(tokens), source_(source) {}

  void scan() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      if (is_name(tokens_[at_])) see_name();
      else see_mark(tokens_[at_].text);
    }
    source_.balanced = source_.balanced && braces_ == 0;
  }

 private:
  std::string_view text(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string_view(); }
  bool outside() const { return braces_ == 0 && brackets_ == 0; }
  bool is_tag(std::string_view word) const { return word == "struct" || word == "union" || word == "enum"; }

  void see_name() {
    const Token& token = tokens_[at_];
    const std::string_view next = text(at_ + 1), before = at_ > 0 ? text(at_ - 1) : std::string_view();
    if (next == "(") {
      if (outside() && !in_value_ && token.text != "__attribute__") head_ = token;
      if (inside_) inside_->calls.insert(token.text);
    } else if (in_enum_ && braces_ == 1 && (before == "{" || before == ",")) {
      source_.declared.push_back(token);
    } else if (outside() && !in_value_) {
      const bool behind = at_ > 0 && (is_name(tokens_[at_ - 1]) || before == "*" || before == "}" || before == ",");
      const bool ends = next == "=" || next == "[" || next == ";" || next == ",";
      if ((behind && ends) || (is_tag(before) && next == "{")) source_.declared.push_back(token);
      if (token.text == "enum") enum_begins_ = true;
    }
  }

  void see_mark(std::string_view mark) {
    if (mark == "(" || mark == "[") ++brackets_;
    if ((mark == ")" || mark == "]") && brackets_ > 0) --brackets_;
    if (mark == "{") return open();
    if (mark == "}") return close();
    if (!outside()) return;
    if (mark == "=") in_value_ = true;
    if (mark == "," || mark == ";") in_value_ = false;
    if (mark != ";") return;
    head_ = {};
    enum_begins_ = false;
  }

  void open() {
    if (braces_++ > 0) return;
    in_enum_ = enum_begins_;
    enum_begins_ = false;
    if (head_.text.empty() || in_value_ || brackets_ > 0) return;
    inside_ = &source_.functions[head_.text];
    inside_->line = head_.line;
    source_.declared.push_back(head_);
  }

  void close() {
    if (braces_ == 0) source_.balanced = false;
    else if (--braces_ > 0) return;
    inside_ = nullptr;
    in_enum_ = false;
    head_ = {};
  }

  const std::vector<Token>& tokens_;
  SourceText& source_;
  std::size_t at_ = 0;
  SourceFunction* inside_ = nullptr;
  Token head_;
  int braces_ = 0, brackets_ = 0;   // brackets: ( and [
  bool in_value_ = false, in_enum_ = false, enum_begins_ = false;
};

bool begins_with(std::string_view name, const std::string& prefix) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b)); };
  return name.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), name.begin(), same);
}

}  // namespace

SourceText scan_source(std::string_view text) {
  Lexed lexed = lex(text);
  SourceText source;
  source.tokens = std::move(lexed.tokens);
  source.macros = macros_of(lexed.directives);
  Scanner(source.tokens, source).scan();
  for (const Token& token : source.tokens) source.words.insert(token.text);
  for (const auto& words : lexed.directives)
    for (const Token& token : words) source.words.insert(token.text);
  return source;
}

std::optional<NamedLine> find_recursion(const SourceText& source) {
  for (const auto& [name, function] : source.functions) {
    std::set<std::string_view> reached;
    for (std::vector<std::string_view> open(function.calls.begin(), function.calls.end()); !open.empty();) {
      const std::string_view called = open.back();
      open.pop_back();
      const auto found = source.functions.find(called);
      if (found == source.functions.end() || !reached.insert(called).second) continue;
      open.insert(open.end(), found->second.calls.begin(), found->second.calls.end());
    }
    if (reached.count(name)) return NamedLine{std::string(name), function.line};
  }
  return std::nullopt;
}

std::optional<NamedLine> find_foreign_name(const SourceText& source, const std::string& prefix) {
  if (!source.balanced) return std::nullopt;
  std::vector<Token> names = source.macros;
  names.insert(names.end(), source.declared.begin(), source.declared.end());
  std::stable_sort(names.begin(), names.end(), [](const Token& a, const Token& b) { return a.line < b.line; });
  for (const Token& name : names)
    if (!begins_with(name.text, prefix)) return NamedLine{std::string(name.text), name.line};
  return std::nullopt;
}

}  // namespace nicol
