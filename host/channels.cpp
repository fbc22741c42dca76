#include "host/channels.hpp"

#include <algorithm>
#include <cmath>

namespace nicol {
namespace {

bool constant(const Samples& values) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
}

bool transport_is_colourless(const Scene& scene) {
  for (const Medium& medium : scene.media) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!constant(medium.n[axis])) return false;
      // a constant extinction coefficient still absorbs by wavelength
      if (std::any_of(medium.k[axis].begin(), medium.k[axis].end(), [](double k) { return k != 0; })) return false;
    }
    // so does the retardance between two waves that add as amplitudes
    const bool crystal = (medium.symmetry != Medium::Symmetry::isotropic || medium.circular_waves) && scene.settings.polarization;
    if (crystal && (scene.settings.coherence || medium.is_active() || medium.circular_waves || medium.frame.size() > 1)) return false;
    if (!constant(medium.rotation_deg_per_mm)) return false;
  }
  if (std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return !o.face_surfaces.empty(); })) return false;
  return std::all_of(scene.polarizers.begin(), scene.polarizers.end(), [](const Polarizer& p) {
    return p.kind != Polarizer::Kind::fragment &&
           (p.kind != Polarizer::Kind::calcite || (constant(p.n_o) && constant(p.n_e)));
  });
}

// The factor by which `values` is `shape`, or NaN.
double ratio_to(const Samples& values, const Samples& shape) {
  double largest = 0, ratio = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (std::fabs(shape[i]) > largest) {
      largest = std::fabs(shape[i]);
      ratio = values[i] / shape[i];
    }
  }
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (std::fabs(values[i] - ratio * shape[i]) > 1e-14 * largest * std::fabs(ratio)) return NAN;
  }
  return ratio;
}

}  // namespace

Channels choose_channels(const Scene& scene) {
  Channels out;
  const std::size_t wavelengths = scene.lambda_nm.size();
  out.count = static_cast<int>(wavelengths);
  if (wavelengths < 2 || !transport_is_colourless(scene)) return out;

  std::vector<const Samples*> sources;
  for (const Emission& emission : scene.emissions) sources.push_back(&emission.radiance);
  sources.push_back(&scene.sky);
  std::vector<const Samples*> shapes;
  std::vector<std::vector<std::pair<std::size_t, double>>> parts;
  for (const Samples* source : sources) {
    parts.emplace_back();
    if (std::all_of(source->begin(), source->end(), [](double v) { return v == 0; })) continue;
    std::size_t found = 0;
    double ratio = NAN;
    for (; found < shapes.size(); ++found) {
      ratio = ratio_to(*source, *shapes[found]);
      if (!std::isnan(ratio)) break;
    }
    if (found == shapes.size()) {
      shapes.push_back(source);
      ratio = 1;
    }
    parts.back().push_back({found, ratio});
  }
  if (shapes.empty() || shapes.size() >= wavelengths) return out;

  out.shared = true;
  out.count = static_cast<int>(shapes.size());
  for (const Samples* shape : shapes) out.mixing.insert(out.mixing.end(), shape->begin(), shape->end());
  for (const auto& part : parts) {
    std::vector<double> shares(shapes.size(), 0.0);
    for (const auto& [channel, ratio] : part) shares[channel] = ratio;
    out.emission.push_back(std::move(shares));
  }
  out.sky = out.emission.back();
  out.emission.pop_back();
  return out;
}

double brightest_radiance(const Scene& scene) {
  double most = 0;
  for (const double v : scene.sky) most = std::max(most, v);
  for (const Emission& emission : scene.emissions)
    for (const double v : emission.radiance) most = std::max(most, v);
  return most;
}

}  // namespace nicol
