// See recursion.hpp.
#include "host/fragments/recursion.hpp"

#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace nicol {
namespace {

struct Token {
  std::string_view text;   // a name or a mark
  int line = 0;
  bool is_name() const { return std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_'; }
};

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

std::vector<Token> tokens_of(std::string_view text) {
  const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  std::vector<Token> tokens;
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t size = passed_over(text, at);
    if (size > 0) {
      for (std::size_t i = at; i < at + size; ++i) line += text[i] == '\n';
    } else {
      size = 1;
      while (in_name(text[at]) && at + size < text.size() && in_name(text[at + size])) ++size;
      if (!std::isspace(static_cast<unsigned char>(text[at]))) tokens.push_back({text.substr(at, size), line});
      line += text[at] == '\n';
    }
    at += size;
  }
  return tokens;
}

struct Function {
  int line = 0;
  std::set<std::string_view> calls;
};

// A name before parentheses outside of all braces, with a body behind them, is a definition; such names inside are what it calls.
std::map<std::string_view, Function> functions_of(const std::vector<Token>& tokens) {
  std::map<std::string_view, Function> functions;
  Function* inside = nullptr;
  Token head;
  int braces = 0, parentheses = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    const bool called = tokens[i].is_name() && i + 1 < tokens.size() && tokens[i + 1].text == "(";
    if (text == "(") ++parentheses;
    if (text == ")") --parentheses;
    if (called && braces == 0 && parentheses == 0) head = tokens[i];
    if (called && inside) inside->calls.insert(text);
    if (text == ";" && braces == 0) head = {};
    if (text == "{" && braces++ == 0 && !head.text.empty()) (inside = &functions[head.text])->line = head.line;
    if (text != "}" || braces == 0 || --braces > 0) continue;
    inside = nullptr;
    head = {};
  }
  return functions;
}

}  // namespace

std::optional<Recursion> find_recursion(const std::string& text) {
  const std::vector<Token> tokens = tokens_of(text);
  const auto functions = functions_of(tokens);
  for (const auto& [name, function] : functions) {
    std::set<std::string_view> reached;
    for (std::vector<std::string_view> open(function.calls.begin(), function.calls.end()); !open.empty();) {
      const std::string_view called = open.back();
      open.pop_back();
      const auto found = functions.find(called);
      if (found == functions.end() || !reached.insert(called).second) continue;
      open.insert(open.end(), found->second.calls.begin(), found->second.calls.end());
    }
    if (reached.count(name)) return Recursion{std::string(name), function.line};
  }
  return std::nullopt;
}

}  // namespace nicol
