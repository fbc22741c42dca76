// A scene text built to exact solids.
#pragma once
#include <cmath>

#include "bound.hpp"
#include "host/solids/solids.hpp"

namespace nicol {

struct Built {
  Bound bound;
  Geometry geometry;

  std::size_t cells() const { return geometry.cells.size() - 1; }  // without the surroundings
  const Cell& cell(std::size_t i) const { return geometry.cells.at(i + 1); }
  const Medium& medium(std::size_t i) const { return bound.scene.media.at(cell(i).medium); }

  double volume(std::size_t i) const {
    double six_volumes = 0;
    for (int f = cell(i).first_face; f < cell(i).first_face + cell(i).face_count; ++f) {
      const auto& c = geometry.faces[f].corners;
      for (std::size_t k = 1; k + 1 < c.size(); ++k) six_volumes += dot(c[0], cross(c[k], c[k + 1]));
    }
    return six_volumes / 6;
  }
  double smallest_area(std::size_t i) const {
    double smallest = 1e300;
    for (int f = cell(i).first_face; f < cell(i).first_face + cell(i).face_count; ++f) {
      const auto& c = geometry.faces[f].corners;
      Vec3 twice{};
      for (std::size_t k = 1; k + 1 < c.size(); ++k)
        twice = twice + cross(c[k] - c[0], c[k + 1] - c[0]);
      smallest = std::min(smallest, length(twice) / 2);
    }
    return smallest;
  }
  // Patches of a kind on all cells.
  int patches(Patch::Behind behind) const {
    int count = 0;
    for (const Patch& p : geometry.patches) count += p.behind == behind;
    return count;
  }
};

inline Built build_text(const std::string& text) {
  Built built{bind_text("global_settings { mm_per_unit 1 }" + lit + text), {}};
  auto& diagnostics = built.bound.parsed->diagnostics;
  if (!diagnostics.failed()) built.geometry = build_geometry(built.bound.scene, diagnostics);
  CHECK_MESSAGE(!diagnostics.failed(), built.bound.text());
  if (built.geometry.cells.empty()) built.geometry.cells.resize(1);
  return built;
}

}  // namespace nicol
