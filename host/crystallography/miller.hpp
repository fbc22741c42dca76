// Indices of faces and edges. A face (hkl) cuts the axes at a/h, b/k, c/l; an edge or zone [uvw] runs
// along u a + v b + w c. Hexagonal axes know four indices (hkil) with i = -(h + k) (Bravais 1866).
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nicol::crystallography {

constexpr int largest_index = 1000;

struct Miller {
  int h = 0, k = 0, l = 0;
};

inline bool operator==(Miller a, Miller b) { return a.h == b.h && a.k == b.k && a.l == b.l; }
inline Miller operator-(Miller a) { return {-a.h, -a.k, -a.l}; }

// Without a common divisor: (202) is the face (101).
Miller reduced(Miller m);

// Three or four whole numbers. If they name no face, `why` says so.
std::optional<Miller> face_of_indices(const std::vector<double>& indices, std::string& why);

// "10-11": one digit each, "-" before the digit; "12 3 4": separated by blanks or commas.
// Nothing if this is no list of indices.
std::optional<std::vector<double>> parse_indices(std::string_view text);

std::string to_text(Miller m);  // "(1 0 -1)"

}  // namespace nicol::crystallography
