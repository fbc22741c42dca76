// String built-ins: chr concat datetime str strlwr strupr substr vstr, and escapes.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "parser.hpp"
#include "text.hpp"

namespace nicol::sdl {
namespace {

constexpr char escapes[] = "a\ab\bf\fn\nr\rt\tv\v\\\\''\"\"";

bool read_hex4(const std::string& s, std::size_t at, std::uint32_t& code) {
  code = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    const char c = i < s.size() ? s[i] : ' ';
    std::uint32_t digit = 0;
    if (c >= '0' && c <= '9') digit = static_cast<std::uint32_t>(c - '0');
    else if (c >= 'a' && c <= 'f') digit = static_cast<std::uint32_t>(c - 'a' + 10);
    else if (c >= 'A' && c <= 'F') digit = static_cast<std::uint32_t>(c - 'A' + 10);
    else return false;
    code = code * 16 + digit;
  }
  return true;
}

}  // namespace

std::string Parser::unescaped(const Token& literal) const {
  const std::string& raw = literal.text->text;
  std::string out;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '\\' || i + 1 == raw.size()) {
      out += raw[i];
      continue;
    }
    ++i;
    std::uint32_t code = 0;
    bool known = false;
    for (std::size_t k = 0; k + 1 < sizeof escapes && !known; k += 2) {
      known = raw[i] == escapes[k];
      if (known) out += escapes[k + 1];
    }
    if (raw[i] == '0') {
      out += '\0';
    } else if (raw[i] == 'u' && read_hex4(raw, i + 1, code)) {
      append_utf8(out, code);
      i += 4;
    } else if (!known) {
      throw Failure{literal.where, "Illegal escape sequence in string."};
    }
  }
  return out;
}

namespace {

char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
char raised(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// Days since 2000-01-01 as text; strftime's letters.
std::string date_text(double days, const std::string& format) {
  constexpr double epoch_2000_s = 946684800;
  const auto seconds = static_cast<std::time_t>(epoch_2000_s + days * 86400);
  std::tm parts{};
  if (!gmtime_r(&seconds, &parts)) return "";
  char text[512];
  return std::string(text, std::strftime(text, sizeof text, format.c_str(), &parts));
}

}  // namespace

TextPtr Parser::string_call(const Token& name) {
  expect('(');
  Group group(*this);
  std::string out;
  switch (static_cast<Keyword>(name.index)) {
    case Keyword::k_chr: {
      const double code = number();
      if (!(code >= 0 && code < 65536)) {
        throw Failure{name.where, "Value " + number_text(code) + " cannot be used in chr(...)."};
      }
      append_utf8(out, static_cast<std::uint32_t>(code));
      break;
    }
    case Keyword::k_concat: out = concat_call(); break;
    case Keyword::k_datetime: {
      const double days = number();
      const std::string format = accept(',') ? string_value()->text : "%Y-%m-%d %H:%M:%SZ";
      if (!(std::fabs(days) < 1e6)) throw Failure{name.where, "Domain error."};
      out = date_text(days, format);
      break;
    }
    case Keyword::k_str: {
      const double value = number();
      accept(',');
      const double width = number();
      accept(',');
      out = formatted(name.where, value, width, number());
      break;
    }
    case Keyword::k_strlwr: case Keyword::k_strupr:
      out = string_value()->text;
      for (char& c : out) c = name.is(Keyword::k_strlwr) ? lowered(c) : raised(c);
      break;
    case Keyword::k_substr: out = substr_call(name.where); break;
    default: out = vector_text(name.where); break;
  }
  group.close(')');
  return make_text(std::move(out));
}

std::string Parser::concat_call() {
  std::string out;
  do {
    const TextPtr part = string_value();
    if (out.size() + part->text.size() > options_.limits.items) throw LimitReached{"Out of memory."};
    out += part->text;
    accept(',');
  } while (!peek().is(')'));
  return out;
}

std::string Parser::substr_call(Location where) {
  const TextPtr text = string_value();
  accept(',');
  const double from = number();
  accept(',');
  const double count = number();
  const auto starts = character_starts(text->text);
  const auto length = static_cast<double>(starts.size() - 1);
  if (!(from >= 1 && count >= 0 && std::trunc(from) - 1 + std::trunc(count) <= length)) {
    throw Failure{where, "Illegal parameters in substr."};
  }
  const auto first = static_cast<std::size_t>(from) - 1;
  const std::size_t end = starts[first + static_cast<std::size_t>(count)];
  return text->text.substr(starts[first], end - starts[first]);
}

// As C's "%*.*f"; width < 0 pads with zeros, precision < 0 means 6 digits.
std::string Parser::formatted(Location where, double value, double width, double precision) {
  constexpr double most = 1000;
  if (!(std::fabs(width) <= most && std::fabs(precision) <= most)) {
    throw Failure{where, "Invalid formatting code in format string, or resulting string too long."};
  }
  char text[2048];
  const int w = static_cast<int>(std::fabs(width)), p = static_cast<int>(precision);
  const char* format = width < 0 ? "%0*.*f" : "%*.*f";
  const int length = std::snprintf(text, sizeof text, format, w, p < 0 ? 6 : p, value);
  return std::string(text, static_cast<std::size_t>(length));
}

// `vstr(dimensions, vector, separator, width, precision)`
std::string Parser::vector_text(Location where) {
  const double wanted = number();
  accept(',');
  const Numbers vector = promoted(sum(), 5);
  accept(',');
  const TextPtr separator = string_value();
  accept(',');
  const double width = number();
  accept(',');
  const double precision = number();
  const int count = wanted < 2 || wanted != wanted ? 2 : wanted > 5 ? 5 : static_cast<int>(wanted);
  std::string out;
  for (int i = 0; i < count; ++i) {
    if (i > 0) out += separator->text;
    out += formatted(where, vector.v[static_cast<std::size_t>(i)], width, precision);
  }
  return out;
}

}  // namespace nicol::sdl
