// UTF-8, forgiving: a byte that fits nowhere is a character of its own.
#include "text.hpp"

#include <charconv>
#include <cmath>

namespace nicol::sdl {
namespace {

std::size_t length_at(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t length = lead < 0xC2 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 1;
  for (std::size_t i = 1; i < length; ++i) {
    if (at + i >= text.size() || (static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return 1;
  }
  return length;
}

}  // namespace

std::vector<std::size_t> character_starts(std::string_view text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); i += length_at(text, i)) starts.push_back(i);
  starts.push_back(text.size());
  return starts;
}

std::uint32_t code_point(std::string_view c) {
  if (c.empty()) return 0;
  const std::size_t length = length_at(c, 0);
  const auto lead = static_cast<unsigned char>(c[0]);
  if (length == 1) return lead;
  std::uint32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(c[i]) & 0x3Fu);
  return code;
}

std::string number_text(double value) {
  if (std::isnan(value)) return "(1e999-1e999)";
  if (std::isinf(value)) return value < 0 ? "-1e999" : "1e999";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18 & 7));
    tail(12);
    tail(6);
    tail(0);
  }
}

}  // namespace nicol::sdl
