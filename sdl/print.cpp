// Writes a tree as scene text that reads back as the same tree.
#include "text.hpp"
#include "tree.hpp"

namespace nicol::sdl {
namespace {

// Words that would begin a colour if a number stood next to them.
bool is_channel(const Item& item) {
  const std::string* word = item.word();
  return word && (*word == "red" || *word == "green" || *word == "blue" ||
                  *word == "srgb");
}

class Printer {
 public:
  void items(const std::vector<Item>& items) {
    const Item* before = nullptr;
    for (const Item& item : items) {
      // Without the comma `1 -1` would be 0, and `rgb 1 filter 2` one colour.
      const bool value_before = before && !before->word() && !before->block();
      if ((value_before && !item.block()) || (before && is_channel(*before))) out += ',';
      const bool same_line = before && !item.word() && !item.block() && !before->block();
      if (same_line) out += ' ';
      else newline();
      one(item);
      before = &item;
    }
  }
  std::string out;

 private:
  void newline() {
    if (!out.empty()) out += '\n';
    out.append(static_cast<std::size_t>(depth_) * 2, ' ');
  }

  void one(const Item& item) {
    if (const auto* w = item.word()) out += *w;
    else if (const auto* n = item.number()) number(*n);
    else if (const auto* v = item.vector()) vector(*v);
    else if (const auto* s = item.string()) string(*s);
    else if (const Block* b = item.block()) block(*b);
  }

  void number(double value) { out += number_text(value); }

  void vector(const Vector& v) {
    if (v.colour) out += "rgbft ";
    out += '<';
    for (int i = 0; i < v.size; ++i) {
      if (i > 0) out += ',';
      number(v.v[static_cast<std::size_t>(i)]);
    }
    out += '>';
  }

  void string(const std::string& text) {
    out += '"';
    for (char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      if (c == '\0') out += "\\0";
      else out += c;
    }
    out += '"';
  }

  void block(const Block& b) {
    const bool list = b.name == "[" || b.name == "<";
    out += b.name;
    if (!list) out += " {";
    ++depth_;
    items(b.items);
    --depth_;
    newline();
    out += b.name == "[" ? ']' : b.name == "<" ? '>' : '}';
  }

  int depth_ = 0;
};

}  // namespace

std::string print(const Document& document) {
  Printer printer;
  printer.items(document.items);
  if (!printer.out.empty()) printer.out += '\n';
  return printer.out;
}

}  // namespace nicol::sdl
