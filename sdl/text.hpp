// Strings as sequences of characters: UTF-8 where it is valid, else bytes.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nicol::sdl {

// Where each character starts, and the end.
std::vector<std::size_t> character_starts(std::string_view text);
std::uint32_t code_point(std::string_view character);
// The shortest digits that read back exactly; infinite and undefined numbers as expressions.
std::string number_text(double value);
void append_utf8(std::string& text, std::uint32_t code);

}  // namespace nicol::sdl
