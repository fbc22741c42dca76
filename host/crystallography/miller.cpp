// Indices of faces: see miller.hpp. Test: point_group_test.cpp.
#include "host/crystallography/miller.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace nicol::crystallography {

Miller reduced(Miller m) {
  const int divisor = std::gcd(std::gcd(m.h, m.k), m.l);
  return divisor ? Miller{m.h / divisor, m.k / divisor, m.l / divisor} : m;
}

std::optional<Miller> face_of_indices(const std::vector<double>& indices, std::string& why) {
  if (indices.size() != 3 && indices.size() != 4) {
    why = "a face has three indices (h, k, l) or four (h, k, i, l)";
    return std::nullopt;
  }
  for (double index : indices) {
    if (index == std::floor(index) && std::abs(index) <= largest_index) continue;
    why = "indices of a face are whole numbers up to " + std::to_string(largest_index);
    return std::nullopt;
  }
  const auto whole = [&](std::size_t i) { return static_cast<int>(indices[i]); };
  if (indices.size() == 4 && whole(0) + whole(1) + whole(2) != 0) {
    why = "Miller-Bravais indices (h k i l) need h + k + i = 0; here i must be " +
          std::to_string(-whole(0) - whole(1));
    return std::nullopt;
  }
  const Miller face{whole(0), whole(1), whole(indices.size() - 1)};
  if (face == Miller{}) {
    why = "a face with all indices zero is none";
    return std::nullopt;
  }
  return reduced(face);
}

std::optional<std::vector<double>> parse_indices(std::string_view text) {
  const bool spaced = text.find_first_of(" ,\t") != std::string_view::npos;
  std::vector<double> indices;
  std::size_t at = 0;
  while (at < text.size()) {
    if (std::isspace(static_cast<unsigned char>(text[at])) || text[at] == ',') {
      ++at;
      continue;
    }
    const bool negative = text[at] == '-';
    if (negative) ++at;
    double index = 0;
    std::size_t digits = 0;
    for (; at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])); ++at) {
      index = 10 * index + (text[at] - '0');
      ++digits;
      if (!spaced) {
        ++at;
        break;
      }
    }
    if (digits == 0 || digits > 4) return std::nullopt;
    indices.push_back(negative ? 0 - index : index);
  }
  return indices;
}

std::string to_text(Miller m) {
  return "(" + std::to_string(m.h) + " " + std::to_string(m.k) + " " + std::to_string(m.l) + ")";
}

}  // namespace nicol::crystallography
