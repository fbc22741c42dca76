// The words of a script's line.
#pragma once
#include <string>
#include <vector>

#include "host/preview/input.hpp"

namespace nicol::window {

using Words = std::vector<std::string>;

// "Quoted text" is one word; # and what follows is none.
Words split(const std::string& line);

// All throw ScriptError (script.hpp).
const std::string& word_at(const Words& words, std::size_t i);
double number(const std::string& word);
preview::Button button_at(const Words& words, std::size_t i);   // left, if there is no such word

// The first place of `old` in a text file becomes `text`.
void replace_in(const std::string& path, const std::string& old, const std::string& text);

}  // namespace nicol::window
