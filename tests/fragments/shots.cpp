#include "tests/fragments/shots.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace nicol::test {

Read read(const std::string& text, const std::string& wavelengths, int size) {
  engine::SceneOptions options;
  options.width = options.height = size;
  options.wavelengths = wavelengths;
  options.text = std::make_shared<const std::string>(text);
  options.library_paths = {NICOL_TEST_FOLDER "/plugins", NICOL_SCRATCH_FOLDER};
  engine::ReadScene made = engine::read_scene("scene.pov", options);
  Read result;
  result.errors = made.loaded->parsed.diagnostics.text();
  if (made.whole) result.loaded = std::move(made.loaded);
  return result;
}

Frame shoot(const std::string& text, bool real_double, const std::string& wavelengths, int size, int lanes) {
  const Read scene = read(text, wavelengths, size);
  if (!scene.loaded) throw std::runtime_error(scene.errors);
  const auto device = open_device("");
  RenderOptions options;
  options.kernel.real_double = real_double;
  options.kernel.lanes = lanes;
  const engine::LoadedScene& loaded = *scene.loaded;
  const PackedScene packed =
      pack(loaded.scene, loaded.geometry, loaded.features.mask, size, size, lanes_on(*device, options.kernel));
  RenderReport report;
  return render(*device, packed, loaded.scene.lambda_nm, loaded.scene.weight_nm, options, report);
}

std::string refusal(const std::string& text, bool real_double) {
  try {
    shoot(text, real_double);
  } catch (const FragmentError& error) {
    return error.what();
  }
  return "";
}

double difference(const Frame& a, const Frame& b) {
  if (a.stokes.size() != b.stokes.size()) return INFINITY;
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < a.stokes.size(); ++i) {
    if (std::isnan(a.stokes[i]) || std::isnan(b.stokes[i])) return INFINITY;
    largest = std::max({largest, std::fabs(double(a.stokes[i])), std::fabs(double(b.stokes[i]))});
    apart = std::max(apart, std::fabs(double(a.stokes[i]) - double(b.stokes[i])));
  }
  return largest > 0 ? apart / largest : INFINITY;
}

double centre(const Frame& frame, std::size_t w, int component) {
  return frame.component(component, w)[static_cast<std::size_t>(frame.height / 2) * frame.width + frame.width / 2];
}

std::string new_folder(const std::string& name) {
  const std::string folder = std::string(NICOL_SCRATCH_FOLDER) + "/" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

void write(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

}  // namespace nicol::test
