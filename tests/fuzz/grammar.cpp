#include "tests/fuzz/grammar.hpp"

#include <cstdio>

namespace nicol::fuzz {
namespace {

class Maker {
 public:
  Maker(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool done() const { return at_ >= size_; }
  unsigned below(unsigned n) { return byte() % n; }

  std::string scene() {
    std::string text =
        "#version unofficial 3.7;\nglobal_settings { mm_per_unit 1 wavelengths { 500, 600 } }\n"
        "camera { location <0.3, 0.2, -9> right x look_at 0 }\nbackground { spectrum { e } }\n";
    for (int i = 0; i < 4 && (i == 0 || !done()); ++i) text += below(4) == 0 ? sheet() : solid(2, true);
    return text;
  }

 private:
  unsigned byte() { return done() ? 0 : data_[at_++]; }

  std::string number() {
    static const char* const common[] = {"0", "1", "-1", "0.5", "-0.5", "2", "-2", "0.1", "1/3", "0.25", "3", "1e-3", "1e-9",
                                         "0.30000000000000004", "-0.7", "7", "1e-15", "100", "1e6"};
    const unsigned choice = byte();
    if (choice < 220) return common[choice % (choice < 180 ? 12 : std::size(common))];
    char text[32];
    std::snprintf(text, sizeof text, "%g", (static_cast<int>(byte()) * 256 + static_cast<int>(byte()) - 32768) / 4096.0);
    return text;
  }
  std::string positive() { return "(0.05 + abs(" + number() + "))"; }
  std::string vector() { return "<" + number() + ", " + number() + ", " + number() + ">"; }
  std::string direction() { return "(" + vector() + " + <1e-4, 0, 2e-4>)"; }

  std::string transforms() {
    std::string text;
    static const char* const angles[] = {"0", "90", "45", "30", "180", "1e-7", "12.3", "60"};
    for (unsigned i = below(3); i > 0; --i) switch (below(4)) {
        case 0: text += " translate " + vector(); break;
        case 1: text += std::string(" rotate ") + angles[below(8)] + "*" + "xyz"[below(3)]; break;
        case 2: text += " scale <" + positive() + ", " + positive() + ", " + positive() + ">"; break;
        default: text += " scale <-1, 1, 1>"; break;
      }
    return text;
  }

  std::string end(bool outermost) {
    if (!outermost) return transforms() + " }\n";
    std::string text = transforms() + (below(5) == 0 ? " optical_contact" : "");
    return text + " interior { ior " + (below(3) == 0 ? "1.33" : "1.5") + " } }\n";
  }

  std::string solid(int depth, bool outermost) {
    switch (below(depth > 0 ? 7 : 4)) {
      case 0: {
        const std::string corner = vector();
        return "box { " + corner + ", " + corner + " + <" + positive() + ", " + positive() + ", " + positive() + ">" +
               end(outermost);
      }
      case 1: return prism() + end(outermost);
      case 2: return facets() + end(outermost);
      case 3: return "box { <-1, -1, -1>, <1, 1, 1>" + end(outermost);
      default: break;
    }
    static const char* const operations[] = {"difference", "intersection", "merge"};
    std::string text = std::string(operations[below(3)]) + " { " + solid(depth - 1, false);
    for (unsigned i = 1 + below(2); i > 0; --i)
      text += below(3) == 0 ? "plane { " + direction() + ", " + number() + end(false) : solid(depth - 1, false);
    return text + end(outermost);
  }

  std::string prism() {
    const unsigned points = 3 + below(4);
    std::string first, list;
    for (unsigned i = 0; i < points; ++i) {
      const std::string point = "<" + number() + ", " + number() + ">";
      if (i == 0) first = point;
      list += point + ", ";
    }
    return "prism { linear_sweep 0, " + positive() + ", " + std::to_string(points + 1) + ", " + list + first;
  }

  std::string facets() {
    std::string text = "crystal {";
    for (unsigned i = 4 + below(6); i > 0; --i) text += " facet " + direction() + ", " + positive();
    return text + " facet <1, 1, 1>, 3 facet <-1, -1, 1>, 3 facet <1, -1, -1>, 3 facet <-1, 1, -1>, 3";
  }

  std::string sheet() {
    const char* const does = below(2) == 0 ? " luminous { spectrum { e } }" : " polarizer { ideal angle 30 }";
    if (below(2) == 0) return "disc { " + vector() + ", " + direction() + ", " + positive() + transforms() + does + " }\n";
    const unsigned points = 3 + below(3);
    std::string first, list;
    for (unsigned i = 0; i < points; ++i) {
      const std::string point = "<" + number() + ", " + number() + ", 0>";
      if (i == 0) first = point;
      list += point + ", ";
    }
    return "polygon { " + std::to_string(points + 1) + ", " + list + first + transforms() + does + " }\n";
  }

  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

}  // namespace

std::string scene_of_bytes(const std::uint8_t* data, std::size_t size) { return Maker(data, size).scene(); }

}  // namespace nicol::fuzz
