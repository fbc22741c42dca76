// GemCad's text format: see gem.hpp. A label follows the tooth it names or the last one; instructions
// after "G" are for people.
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "host/crystallography/gem.hpp"

namespace nicol::crystallography {

namespace {

constexpr std::size_t most_facets = 10'000;

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(value)) return std::nullopt;
  return value;
}

class Reader {
 public:
  GemCut read(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::string line;
    while (std::getline(lines, line)) {
      ++line_;
      read_line(line);
    }
    if (!has_gear_) fail("no gear: a line 'g 96 0.0' is needed");
    if (cut_.tiers.empty()) fail("no facets: lines 'a angle distance tooth ...' are needed");
    for (const GemTier& tier : cut_.tiers)
      if (tier.teeth.empty() && tier.angle_deg != 0) fail("a facet without a tooth of the gear");
    return std::move(cut_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw GemCadError{line_, message}; }

  void read_line(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) return;
    if (number(word) || (in_tier_ && (word == "n" || word == "G"))) {
      if (!in_tier_) fail("a number outside a facet");
      std::istringstream again(line);
      return read_teeth(again);
    }
    in_tier_ = false;
    // "g96 0.0" is "g 96 0.0".
    if (word.size() > 1 && (word[0] == 'g' || word[0] == 'a') && number(word.substr(1))) {
      words = std::istringstream(line.substr(line.find(word) + 1));
      word = word.substr(0, 1);
    }
    if (word == "g") read_gear(words);
    else if (word == "I") cut_.refractive_index = next_number(words, "the refractive index");
    else if (word == "a") read_tier(words);
    else if (word == "H" && cut_.title.empty()) std::getline(words >> std::ws, cut_.title);
  }

  double next_number(std::istringstream& words, const std::string& what) const {
    std::string word;
    words >> word;
    const auto value = number(word);
    if (!value) fail("expected " + what + ", '" + word + "' found instead");
    return *value;
  }

  void read_gear(std::istringstream& words) {
    cut_.gear = next_number(words, "the teeth of the gear");
    if (!(cut_.gear >= 1)) fail("a gear has at least one tooth");
    std::string word;
    if (words >> word) cut_.gear_angle_deg = number(word).value_or(0);
    has_gear_ = true;
  }

  void read_tier(std::istringstream& words) {
    GemTier tier;
    tier.angle_deg = next_number(words, "the angle of a facet");
    tier.distance = next_number(words, "the distance of a facet");
    if (std::abs(tier.angle_deg) > 90) fail("a facet's angle lies between -90 and 90");
    cut_.tiers.push_back(tier);
    in_tier_ = true;
    read_teeth(words);
  }

  void read_teeth(std::istringstream& words) {
    GemTier& tier = cut_.tiers.back();
    std::string word;
    while (words >> word) {
      if (word == "G") return;
      if (word == "n") {
        words >> word;
        if (tier.name.empty()) tier.name = word;
      } else if (const auto tooth = number(word)) {
        tier.teeth.push_back(*tooth);
        if (++facets_ > most_facets) fail("more than " + std::to_string(most_facets) + " facets");
      } else {
        fail("expected a tooth of the gear, '" + word + "' found instead");
      }
    }
  }

  GemCut cut_;
  int line_ = 0;
  bool has_gear_ = false, in_tier_ = false;
  std::size_t facets_ = 0;
};

}  // namespace

std::variant<GemCut, GemCadError> read_gemcad(std::string_view text) {
  if (text.find('\0') != std::string_view::npos)
    return GemCadError{1, "this is a binary file: GemCad saves text as .asc"};
  try {
    return Reader().read(text);
  } catch (const GemCadError& error) {
    return error;
  }
}

}  // namespace nicol::crystallography
