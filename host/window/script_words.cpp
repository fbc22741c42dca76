#include "host/window/script_words.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "host/window/script.hpp"

namespace nicol::window {

Words split(const std::string& line) {
  Words words;
  std::istringstream in(line);
  for (std::string word; in >> std::ws && in.peek() != '#' && in.peek() != std::istream::traits_type::eof();) {
    if (in.peek() == '"') {
      in.get();
      std::getline(in, word, '"');
    } else {
      in >> word;
    }
    words.push_back(word);
  }
  return words;
}

double number(const std::string& word) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(word, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end == 0 || end != word.size() || !std::isfinite(value)) throw ScriptError("'" + word + "' is not a number");
  return value;
}

const std::string& word_at(const Words& words, std::size_t i) {
  if (i >= words.size()) throw ScriptError("'" + words.front() + "' lacks a word");
  return words[i];
}

static preview::Button button_named(const std::string& name) {
  if (name == "left") return preview::Button::left;
  if (name == "middle") return preview::Button::middle;
  if (name == "right") return preview::Button::right;
  throw ScriptError("a button is left, middle or right, not '" + name + "'");
}

preview::Button button_at(const Words& words, std::size_t i) {
  return i < words.size() ? button_named(words[i]) : preview::Button::left;
}

void replace_in(const std::string& path, const std::string& old, const std::string& text) {
  std::ifstream in(path, std::ios::binary);
  std::string all{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw ScriptError("cannot read " + path);
  const std::size_t at = all.find(old);
  if (old.empty() || at == std::string::npos) throw ScriptError("'" + old + "' does not stand in " + path);
  all.replace(at, old.size(), text);
  std::ofstream out(path, std::ios::binary);
  out << all;
  if (!out.flush()) throw ScriptError("cannot write " + path);
}

}  // namespace nicol::window
