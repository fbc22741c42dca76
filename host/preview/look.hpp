// A scene as it is looked at: effects left out, camera moved, polarizers turned; and what the device gets of that.
#pragma once
#include <memory>
#include <set>
#include <string>

#include "host/opencl/render.hpp"
#include "host/pack.hpp"
#include "host/preview/navigation.hpp"

namespace nicol::preview {

struct Look {
  Navigation navigation;
  Analyzer analyzer = Analyzer::as_scene;
  double analyzer_rad = 0, polarizer_rad = 0;
  std::set<std::string> without;   // effects that the scene does not have are passed over
  int width = 640, height = 480;
  bool operator==(const Look& o) const;
  bool operator!=(const Look& o) const { return !(*this == o); }
};

struct Prepared {
  Scene scene;
  Geometry geometry;
  std::uint32_t features = 0;
  PackedScene packed;
  int width = 0, height = 0;
};

std::shared_ptr<const Prepared> prepare(const Scene& scene, const Geometry& geometry, const Look& look, int lanes);

}  // namespace nicol::preview
