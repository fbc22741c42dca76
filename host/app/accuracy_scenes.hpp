// A loaded scene at other settings: other wavelengths bind its text anew, the rest changes its data.
#pragma once
#include <map>
#include <vector>

#include "host/accuracy/knobs.hpp"
#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

// The scene's own setting.
AccuracySetting base_setting(const Scene& scene, bool real_double);

struct AccuracyScene {
  Scene scene;
  const Geometry* geometry = nullptr;  // the AccuracyScenes'
  Features features;
};

class AccuracyScenes {
 public:
  AccuracyScenes(const LoadedScene& loaded, const SceneOptions& options) : loaded_(loaded), options_(options) {}
  const Scene& base() const { return loaded_.scene; }
  // Throws UsageError where the text does not bind at these wavelengths.
  AccuracyScene at(const AccuracySetting& setting);

 private:
  struct Bound {
    Scene scene;
    Geometry geometry;
  };
  const Bound& bound_at(const std::vector<double>& lambda_nm);

  const LoadedScene& loaded_;
  SceneOptions options_;
  std::map<std::vector<double>, Bound> bound_;
};

}  // namespace nicol::app
