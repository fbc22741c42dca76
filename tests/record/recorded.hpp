// A scene taken through parser, bind, solids and features, to record pixels of.
#pragma once
#include <string>
#include <vector>

#include "host/features.hpp"
#include "host/record/path_record.hpp"

namespace nicol::test {

struct Loaded {
  Scene scene;
  Geometry geometry;
  Features features;

  // At the point (u, v) of a square picture, 0..1 from the left and from the top.
  PathRecord at(double u, double v, int size = 400, std::size_t wavelength = 0) const {
    const int x = static_cast<int>(u * size), y = static_cast<int>(v * size);
    return record_paths(scene, geometry, features.mask, size, size, x, y, wavelength);
  }
};

// Throws with the diagnostics if it does not load. `lambda_nm` empty: the scene's own.
Loaded load_gallery(const std::string& file, const std::vector<double>& lambda_nm = {});  // of scenes/
Loaded load_text(const std::string& text);

bool has_effect(const PathRecord& record, const std::string& name);

// Ascending; 0 is the surroundings, cells of solids are numbered from 1.
std::vector<int> cells_met(const PathRecord& record);

}  // namespace nicol::test
