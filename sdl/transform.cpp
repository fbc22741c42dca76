// A `transform { }` block as a matrix, for functions made of one.
#include <cmath>

#include "function.hpp"

namespace nicol::sdl {
namespace {

Matrix rotation(std::size_t axis, double angle_deg) {
  Matrix m = identity_matrix();
  const double c = std::cos(angle_deg * radians_per_degree);
  const double s = std::sin(angle_deg * radians_per_degree);
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  m[a][a] = c;
  m[a][b] = s;
  m[b][a] = -s;
  m[b][b] = c;
  return m;
}

// By cofactors; false where it is singular.
bool invert(const Matrix& m, Matrix& out) {
  const auto minor2 = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double det = m[0][0] * minor2(0, 0) + m[0][1] * minor2(0, 1) + m[0][2] * minor2(0, 2);
  if (det == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[j][i] = minor2(i, j) / det;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    out[3][j] = -(m[3][0] * out[0][j] + m[3][1] * out[1][j] + m[3][2] * out[2][j]);
  }
  return true;
}

// What follows a word, as three numbers.
bool triple(const Item& item, std::array<double, 3>& v) {
  if (const double* n = item.number()) {
    v = {*n, *n, *n};
    return true;
  }
  const Vector* given = item.vector();
  if (!given || given->size > 5) return false;
  for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<int>(i) < given->size ? given->v[i] : 0;
  return true;
}

bool one(const std::string& word, const Item& item, Matrix& m) {
  if (word == "matrix") {
    const Vector* v = item.vector();
    if (!v || v->size != 12) return false;
    for (std::size_t i = 0; i < 12; ++i) m[i / 3][i % 3] = v->v[i];
    return true;
  }
  std::array<double, 3> v{};
  if (!triple(item, v)) return false;
  m = identity_matrix();
  if (word == "rotate") {
    m = product(product(rotation(0, v[0]), rotation(1, v[1])), rotation(2, v[2]));
    return true;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (word == "translate") m[3][i] = v[i];
    else if (word == "scale") m[i][i] = v[i] == 0 ? 1 : v[i];
    else return false;
  }
  return true;
}

}  // namespace

Matrix identity_matrix() {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) m[i][i] = 1;
  return m;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix m{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[i][j] = i == 3 ? b[3][j] : 0;
      for (std::size_t k = 0; k < 3; ++k) m[i][j] += a[i][k] * b[k][j];
    }
  }
  return m;
}

bool matrix_of(const Block& block, Matrix& out) {
  out = identity_matrix();
  bool inverse = false;
  for (std::size_t i = 0; i < block.items.size(); ++i) {
    const Item& item = block.items[i];
    Matrix step{};
    if (const Block* nested = item.block()) {
      if (!matrix_of(*nested, step)) return false;
    } else if (!item.word()) {
      return false;
    } else if (*item.word() == "inverse") {
      inverse = !inverse;
      continue;
    } else if (*item.word() == "transform") {
      continue;  // the block that follows is the transform
    } else if (++i == block.items.size() || !one(*item.word(), block.items[i], step)) {
      return false;
    }
    out = product(out, step);
  }
  const Matrix straight = out;
  return !inverse || invert(straight, out);
}

}  // namespace nicol::sdl
