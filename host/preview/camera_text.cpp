// The camera as text of the scene language. Millimetres become units and z is negated, as host/bind/units.hpp has it.
// `location direction right up` are all of a camera; `angle` and `look_at` would change them when read.
// Test: tests/preview/camera_text_test.cpp.
#include <fmt/format.h>

#include <cmath>

#include "host/optics/media.hpp"
#include "host/preview/navigation.hpp"
#include "host/vec.hpp"

namespace nicol::preview {
namespace {

// Left-handed; adding 0 makes -0 a 0.
std::string vector_text(Vec3 v) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", v.x + 0, v.y + 0, 0 - v.z); }

bool is_sampled_from(const Samples& samples, const IndexFormula& formula, const std::vector<double>& lambda_nm) {
  for (std::size_t i = 0; i < samples.size() && i < lambda_nm.size(); ++i)
    if (samples[i] != refractive_index(formula, lambda_nm[i])) return false;
  return true;
}

std::string polarizer_text(const Polarizer& polarizer, const std::vector<double>& lambda_nm) {
  const std::string axis = "axis " + vector_text(polarizer.transmission_axis);
  if (polarizer.kind == Polarizer::Kind::ideal) return "  polarizer { ideal " + axis + " }\n";
  if (polarizer.kind == Polarizer::Kind::ideal_absorbing)
    return "  polarizer { ideal " + axis + " projection absorption }\n";
  const bool usual = is_sampled_from(polarizer.n_o, calcite_ordinary(), lambda_nm) &&
                     is_sampled_from(polarizer.n_e, calcite_extraordinary(), lambda_nm);
  return std::string(usual ? "" : "  // The scene gives its polarizer an index_o or index_e of its own: add them.\n") +
         "  polarizer { calcite " + axis + " }\n";
}

}  // namespace

std::string camera_text(const Scene& scene) {
  const Camera& camera = scene.camera;
  const double units_per_mm = 1 / scene.settings.mm_per_unit;
  std::string text = "camera {\n";
  if (camera.orthographic) text += "  orthographic\n";
  text += "  location " + vector_text(camera.location * units_per_mm) + "\n";
  text += "  direction " + vector_text(camera.direction * units_per_mm) + "\n";
  text += "  right " + vector_text(camera.right * units_per_mm) + "\n";
  text += "  up " + vector_text(camera.up * units_per_mm) + "\n";
  if (camera.polarizer)
    text += polarizer_text(scene.polarizers[static_cast<std::size_t>(*camera.polarizer)], scene.lambda_nm);
  return text + "}\n";
}

}  // namespace nicol::preview
