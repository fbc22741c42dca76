// Scene texts read for a test: what they print, what they say, what an expression is.
#pragma once
#include <doctest/doctest.h>

#include <string>

#include "sdl/parse.hpp"

namespace sdl_test {

using namespace nicol::sdl;

struct Parsed {
  explicit Parsed(std::string text, Options options = {}) {
    options.debug = [this](const std::string& part) { debug += part; };
    parse_text("t.pov", std::move(text), options, result);
  }
  // The messages' first lines, one a line, without the place.
  std::string messages() const {
    std::string out;
    for (const Diagnostic& d : result.diagnostics.all()) {
      out += std::to_string(d.where.line) + ": " + d.message.substr(0, d.message.find('\n')) + '\n';
    }
    return out;
  }
  Result result;
  std::string debug;
};

// What #debug prints; an error in the text is told in its place.
inline std::string printed(const std::string& text) {
  Parsed parsed(text);
  return parsed.result.diagnostics.failed() ? parsed.messages() : parsed.debug;
}

// The messages of a text, in short.
inline std::string said(const std::string& text) { return Parsed(text).messages(); }

// The tree of a text, printed; or what went wrong.
inline std::string tree(const std::string& text) {
  Parsed parsed(text);
  return parsed.result.diagnostics.failed() ? parsed.messages() : print(parsed.result.document);
}

inline std::string tree_of(const std::string& a, const std::string& b) {
  Parsed p(a), q(b);
  if (p.result.diagnostics.failed()) return p.messages();
  return equal(p.result.document, q.result.document) ? "same" : print(p.result.document);
}

// A float expression's value with 6 digits, after the declarations given.
inline std::string value(const std::string& expression, const std::string& before = "") {
  return printed(before + "\n#declare Result = " + expression + ";\n#debug str(Result,1,6)");
}

inline std::string vector(const std::string& expression, const std::string& before = "",
                          int size = 3) {
  return printed(before + "\n#declare Result = " + expression + ";\n#debug vstr(" +
                 std::to_string(size) + ",Result,\",\",1,4)");
}

}  // namespace sdl_test
