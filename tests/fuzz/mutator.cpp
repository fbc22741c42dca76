#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace nicol::fuzz {
namespace {

using Tokens = std::vector<std::string>;  // each with the blanks before it

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

Tokens tokens_of(const std::string& text) {
  Tokens tokens;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end]))) ++end;
    if (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) || text[end] == '.')) {
      while (end < text.size() && (is_word(text[end]) || text[end] == '.' ||
                                   ((text[end] == '-' || text[end] == '+') && std::tolower(text[end - 1]) == 'e')))
        ++end;
    } else if (end < text.size() && is_word(text[end])) {
      while (end < text.size() && is_word(text[end])) ++end;
    } else if (end < text.size() && text[end] == '"') {
      end = std::min(text.find('"', end + 1), text.size() - 1) + 1;
    } else if (end < text.size()) {
      ++end;
    }
    tokens.push_back(text.substr(at, end - at));
    at = end;
  }
  return tokens;
}

char first_of(const std::string& token) {
  for (char c : token)
    if (!std::isspace(static_cast<unsigned char>(c))) return c;
  return ' ';
}

bool is_number(const std::string& token) {
  const char c = first_of(token);
  return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
}

bool is_name(const std::string& token) { return is_word(first_of(token)) && !is_number(token); }

// A place of a token that `fits`, from a random one on; tokens.size() if there is none.
template <class Fits>
std::size_t any(const Tokens& tokens, Random& random, Fits fits) {
  const std::size_t from = below(random, tokens.size());
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (fits(tokens[(from + i) % tokens.size()])) return (from + i) % tokens.size();
  return tokens.size();
}

// A bracket with all up to the one that closes it, and the word before it.
std::pair<std::size_t, std::size_t> group(const Tokens& tokens, Random& random) {
  std::size_t begin = any(tokens, random, [](const std::string& t) { return std::strchr("{[(<", first_of(t)) != nullptr; });
  if (begin == tokens.size()) return {begin, begin};
  std::size_t end = begin;
  for (int depth = 0; end < tokens.size();) {
    const char c = first_of(tokens[end++]);
    depth += c == '{' || c == '[' || c == '(' || c == '<';
    depth -= c == '}' || c == ']' || c == ')' || c == '>';
    if (depth <= 0) break;
  }
  if (begin > 0 && is_name(tokens[begin - 1])) --begin;
  return {begin, end};
}

std::string number(const std::string& old, Random& random) {
  static const char* const odd[] = {
      "0", "1", "-1", "2", "3", "0.5", "1e-9", "1e9", "1e-17", "1e17", "1e-300", "1e300", "1.7e308", "4.9e-324", "1e999",
      "2147483647", "2147483648", "-2147483649", "4294967296", "9223372036854775808", "1e19", "0.1", "45", "90", "180", "360",
      "589.3", "1e-7", "255", "256", "1000000"};
  if (below(random, 4) == 0) return odd[below(random, std::size(odd))];
  const double value = std::strtod(old.c_str(), nullptr);
  const double changes[] = {-value, value * 2, value / 2, value + 1, value - 1, value * (1 + 1e-9), value + 1e-12, value * 1e6,
                            value * 1e-6, static_cast<double>(static_cast<std::int64_t>(std::clamp(value, -1e9, 1e9)))};
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", changes[below(random, std::size(changes))]);
  return text;
}

void change(Tokens& tokens, const Tokens& other, const Tokens& words, Random& random) {
  const auto place = [&](std::size_t i) { return tokens.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t at = below(random, tokens.size());
  const auto insert_group = [&](const Tokens& from) {
    const auto [begin, end] = group(from, random);
    const Tokens copied(from.begin() + static_cast<std::ptrdiff_t>(begin), from.begin() + static_cast<std::ptrdiff_t>(end));
    tokens.insert(place(at), copied.begin(), copied.end());
  };
  switch (below(random, 14)) {
    case 0:
    case 1:
    case 2:
    case 10:
    case 11:
      if (const std::size_t i = any(tokens, random, is_number); i < tokens.size()) tokens[i] = " " + number(tokens[i], random);
      break;
    case 12:
    case 13:
      // equal numbers make planes that coincide
      if (const std::size_t i = any(tokens, random, is_number); i < tokens.size())
        tokens[i] = " " + tokens[any(tokens, random, is_number)];
      break;
    case 3:
      if (const std::size_t i = any(tokens, random, is_name); i < tokens.size() && !words.empty())
        tokens[i] = " " + words[below(random, words.size())];
      break;
    case 4: tokens.erase(place(at), place(std::min(tokens.size(), at + 1 + below(random, 6)))); break;
    case 5:
      if (const auto [begin, end] = group(tokens, random); end > begin) tokens.erase(place(begin), place(end));
      break;
    case 6: insert_group(tokens); break;
    case 7: insert_group(other); break;
    case 8: {
      static const char* const ends[] = {"", " 1", " { }", " <1, 2, 3>", ", 1", " on"};
      if (!words.empty())
        tokens.insert(place(at), " " + words[below(random, words.size())] + ends[below(random, std::size(ends))]);
      break;
    }
    default:
      if (!tokens.empty()) std::swap(tokens[at], tokens[below(random, tokens.size())]);
      break;
  }
}

std::size_t put(const std::string& text, std::uint8_t* out, std::size_t most) {
  const std::size_t size = std::min(text.size(), most);
  std::memcpy(out, text.data(), size);
  return size;
}

std::string text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

}  // namespace

std::string mutated(const std::string& text, const std::string& other, const std::vector<std::string>& words,
                    Random& random) {
  Tokens tokens = tokens_of(text);
  const Tokens others = tokens_of(other);
  for (std::size_t i = 1 + below(random, 1 + below(random, 4)); i > 0; --i) change(tokens, others, words, random);
  std::string out;
  for (const std::string& token : tokens) out += token;
  return out;
}

std::size_t mutate_input(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed,
                         const std::vector<std::string>& words) {
  Random random(seed);
  if (below(random, 5) == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string text = text_of(data, size);
  return put(mutated(text, text, words, random), data, most);
}

std::size_t cross_over(const std::uint8_t* one, std::size_t one_size, const std::uint8_t* two, std::size_t two_size,
                       std::uint8_t* out, std::size_t most, unsigned seed, const std::vector<std::string>& words) {
  Random random(seed);
  return put(mutated(text_of(one, one_size), text_of(two, two_size), words, random), out, most);
}

}  // namespace nicol::fuzz
