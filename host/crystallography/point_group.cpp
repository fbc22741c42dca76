// Groups from generators: see point_group.hpp. Generators are written as International Tables writes
// general positions, "-y,x-y,z".
#include "host/crystallography/point_group.hpp"

#include <algorithm>

namespace nicol::crystallography {

namespace {

struct Row {
  const char* symbol;
  System system;
  const char* generators;    // separated by ';'
  const char* other_names;   // full symbols and old ones, separated by blanks
  const char* rhombohedral;  // generators on rhombohedral axes, or null
};

constexpr System tri = System::triclinic, mono = System::monoclinic, ortho = System::orthorhombic,
                 tetra = System::tetragonal, trig = System::trigonal, hexa = System::hexagonal,
                 cub = System::cubic;

const Row rows[] = {
    {"1", tri, "", "", nullptr},
    {"-1", tri, "-x,-y,-z", "", nullptr},
    {"2", mono, "-x,y,-z", "121", nullptr},
    {"m", mono, "x,-y,z", "1m1", nullptr},
    {"2/m", mono, "-x,y,-z;-x,-y,-z", "12/m1", nullptr},
    {"222", ortho, "-x,-y,z;-x,y,-z", "", nullptr},
    {"mm2", ortho, "-x,-y,z;x,-y,z", "", nullptr},
    {"mmm", ortho, "-x,-y,z;-x,y,-z;-x,-y,-z", "2/m2/m2/m", nullptr},
    {"4", tetra, "-y,x,z", "", nullptr},
    {"-4", tetra, "y,-x,-z", "", nullptr},
    {"4/m", tetra, "-y,x,z;-x,-y,-z", "", nullptr},
    {"422", tetra, "-y,x,z;-x,y,-z", "42", nullptr},
    {"4mm", tetra, "-y,x,z;x,-y,z", "", nullptr},
    {"-42m", tetra, "y,-x,-z;-x,y,-z", "", nullptr},
    {"4/mmm", tetra, "-y,x,z;-x,y,-z;-x,-y,-z", "4/m2/m2/m", nullptr},
    {"3", trig, "-y,x-y,z", "", "z,x,y"},
    {"-3", trig, "-y,x-y,z;-x,-y,-z", "", "z,x,y;-x,-y,-z"},
    {"32", trig, "-y,x-y,z;y,x,-z", "321", "z,x,y;-y,-x,-z"},
    {"3m", trig, "-y,x-y,z;-y,-x,z", "3m1", "z,x,y;y,x,z"},
    {"-3m", trig, "-y,x-y,z;y,x,-z;-x,-y,-z", "-3m1 -32/m -32/m1", "z,x,y;-y,-x,-z;-x,-y,-z"},
    {"6", hexa, "x-y,x,z", "", nullptr},
    {"-6", hexa, "-x+y,-x,-z", "", nullptr},
    {"6/m", hexa, "x-y,x,z;-x,-y,-z", "", nullptr},
    {"622", hexa, "x-y,x,z;y,x,-z", "62", nullptr},
    {"6mm", hexa, "x-y,x,z;-y,-x,z", "", nullptr},
    {"-6m2", hexa, "-x+y,-x,-z;-y,-x,z", "", nullptr},
    {"6/mmm", hexa, "x-y,x,z;y,x,-z;-x,-y,-z", "6/m2/m2/m", nullptr},
    {"23", cub, "-x,-y,z;-x,y,-z;z,x,y", "", nullptr},
    {"m-3", cub, "-x,-y,z;-x,y,-z;z,x,y;-x,-y,-z", "m3 2/m-3 2/m3", nullptr},
    {"432", cub, "-y,x,z;z,x,y", "43", nullptr},
    {"-43m", cub, "y,-x,-z;z,x,y", "", nullptr},
    {"m-3m", cub, "-y,x,z;z,x,y;-x,-y,-z", "m3m 4/m-32/m 4/m32/m", nullptr},
    // other settings
    {"112", mono, "-x,-y,z", "", nullptr},
    {"11m", mono, "x,y,-z", "", nullptr},
    {"112/m", mono, "-x,-y,z;-x,-y,-z", "", nullptr},
    {"2mm", ortho, "x,-y,-z;x,-y,z", "", nullptr},
    {"m2m", ortho, "-x,y,-z;-x,y,z", "", nullptr},
    {"-4m2", tetra, "y,-x,-z;x,-y,z", "", nullptr},
    {"312", trig, "-y,x-y,z;-y,-x,-z", "", nullptr},
    {"31m", trig, "-y,x-y,z;y,x,z", "", nullptr},
    {"-31m", trig, "-y,x-y,z;-y,-x,-z;-x,-y,-z", "-312/m", nullptr},
    {"-62m", hexa, "-x+y,-x,-z;y,x,-z", "", nullptr},
};

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  std::string part;
  for (char c : text) {
    if (c != at) {
      part += c;
    } else if (!part.empty()) {
      parts.push_back(std::move(part));
      part.clear();
    }
  }
  if (!part.empty()) parts.push_back(part);
  return parts;
}

// "-x+y,-x,-z"
Operation operation(std::string_view triplet) {
  Operation op{};
  int row = 0, sign = 1;
  for (char c : triplet) {
    if (c == ',') ++row;
    if (c == '-') sign = -1;
    if (c < 'x' || c > 'z') continue;
    op[row][c - 'x'] = sign;
    sign = 1;
  }
  return op;
}

Operation product(const Operation& a, const Operation& b) {
  Operation c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

int determinant(const Operation& r) {
  return r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
         r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
         r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
}

// Every product of generators, until nothing new comes.
std::vector<Operation> closure(const char* generators) {
  std::vector<Operation> all{operation("x,y,z")}, given;
  for (const std::string& triplet : split(generators, ';')) given.push_back(operation(triplet));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const Operation& g : given) {
      const Operation next = product(g, all[i]);
      if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    }
  }
  return all;
}

struct SystemName {
  System system;
  const char* name;
  const char* holohedry;
};
const SystemName system_table[] = {{tri, "triclinic", "-1"},       {mono, "monoclinic", "2/m"},
                                   {ortho, "orthorhombic", "mmm"}, {tetra, "tetragonal", "4/mmm"},
                                   {trig, "trigonal", "-3m"},      {hexa, "hexagonal", "6/mmm"},
                                   {cub, "cubic", "m-3m"}};

}  // namespace

bool PointGroup::has_hands() const {
  return std::all_of(operations.begin(), operations.end(),
                     [](const Operation& r) { return determinant(r) > 0; });
}

std::optional<PointGroup> find_point_group(std::string_view symbol, bool rhombohedral) {
  std::string wanted;
  for (char c : symbol)
    if (c != ' ') wanted += c;
  for (const Row& row : rows) {
    const auto others = split(row.other_names, ' ');
    if (wanted != row.symbol && std::find(others.begin(), others.end(), wanted) == others.end())
      continue;
    const char* generators = rhombohedral ? row.rhombohedral : row.generators;
    if (!generators) return std::nullopt;
    return PointGroup{row.symbol, row.system, closure(generators)};
  }
  return std::nullopt;
}

std::vector<std::string> point_group_symbols() {
  std::vector<std::string> symbols;
  for (const Row& row : rows) symbols.push_back(row.symbol);
  for (const Row& row : rows)
    for (std::string& other : split(row.other_names, ' ')) symbols.push_back(std::move(other));
  return symbols;
}

const char* holohedry(System system) {
  return system_table[static_cast<std::size_t>(system)].holohedry;
}

const char* name(System system) { return system_table[static_cast<std::size_t>(system)].name; }

std::optional<System> find_system(std::string_view name) {
  if (name == "isometric") return System::cubic;
  for (const SystemName& row : system_table)
    if (name == row.name) return row.system;
  return std::nullopt;
}

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const SystemName& row : system_table) names.push_back(row.name);
  return names;
}

std::vector<Miller> form(const PointGroup& group, Miller face) {
  std::vector<Miller> faces;
  for (const Operation& r : group.operations) {
    const Miller m{face.h * r[0][0] + face.k * r[1][0] + face.l * r[2][0],
                   face.h * r[0][1] + face.k * r[1][1] + face.l * r[2][1],
                   face.h * r[0][2] + face.k * r[1][2] + face.l * r[2][2]};
    if (std::find(faces.begin(), faces.end(), m) == faces.end()) faces.push_back(m);
  }
  return faces;
}

}  // namespace nicol::crystallography
