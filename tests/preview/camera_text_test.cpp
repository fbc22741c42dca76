// The camera as text: read again it is the same camera, for every scene of the collection and for every kind.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "bound_scene.hpp"
#include "host/preview/navigation.hpp"
#include "host/vec.hpp"

namespace nicol::preview {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void check_vector(Vec3 is, Vec3 wanted, double size) {
  INFO("<", is.x, ",", is.y, ",", is.z, "> against <", wanted.x, ",", wanted.y, ",", wanted.z, ">");
  CHECK(length(is - wanted) <= 1e-12 * size);
}

// The last camera of a scene counts.
void check_read_again(const Scene& wanted, const std::string& scene_text, const std::string& name) {
  const std::string text = camera_text(wanted);
  INFO(name, "\n", text);
  const Scene is = read(scene_text + "\n" + text, name).scene;
  const Camera &a = is.camera, &b = wanted.camera;
  CHECK(a.orthographic == b.orthographic);
  check_vector(a.location, b.location, length(b.location));
  check_vector(a.direction, b.direction, length(b.direction));
  check_vector(a.right, b.right, length(b.right));
  check_vector(a.up, b.up, length(b.up));
  REQUIRE(a.polarizer.has_value() == b.polarizer.has_value());
  if (!a.polarizer) return;
  const Polarizer& p = is.polarizers[static_cast<std::size_t>(*a.polarizer)];
  const Polarizer& q = wanted.polarizers[static_cast<std::size_t>(*b.polarizer)];
  CHECK(p.kind == q.kind);
  CHECK(p.n_o == q.n_o);
  CHECK(p.n_e == q.n_e);
  check_vector(p.transmission_axis, q.transmission_axis, 1);
  check_vector(p.normal, q.normal, 1);
}

Navigation some_navigation() {
  Navigation n;
  n.yaw_rad = 0.7;
  n.pitch_rad = -0.4;
  n.pan_right = 0.11;
  n.pan_up = -0.07;
  n.zoom = 0.6;
  return n;
}

}  // namespace

TEST_CASE("camera text: every scene's camera, as it is and moved") {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SCENES_FOLDER)) {
    if (entry.path().extension() != ".pov") continue;
    ++count;
    const std::string text = text_of(entry.path());
    const Loaded loaded = read(text, entry.path().string());
    check_read_again(loaded.scene, text, entry.path().string());
    Geometry geometry;  // the solids only say where the pivot is
    geometry.cells.emplace_back();
    check_read_again(navigate(loaded.scene, geometry, some_navigation(), Analyzer::as_scene, 0.3, 0), text,
                     entry.path().string());
  }
  CHECK(count >= 30);
}

TEST_CASE("camera text: parallel, mirrored, with any polarizer, in any unit") {
  for (const char* unit : {"1", "10", "25.4"})
    for (const char* kind : {"", "orthographic ", "right -x ", "orthographic right -1.2*x up 0.9*y "})
      for (const char* polarizer :
           {"", "polarizer { ideal angle 20 } ", "polarizer { ideal angle 70 projection absorption } ",
            "polarizer { calcite angle 110 } "}) {
        const std::string text = std::string("global_settings { mm_per_unit ") + unit + " } background { rgb 1 }";
        const std::string camera = "camera { location <3, 5, -8> look_at <0.1, 0.2, 0.3> angle 33 " + std::string(kind) +
                                   polarizer + " rotate <0, 0, 11> }";
        const Loaded loaded = load(text + camera);
        check_read_again(loaded.scene, text, "test.pov");
        Geometry geometry = loaded.geometry;
        check_read_again(navigate(loaded.scene, geometry, some_navigation(), Analyzer::added, 0.2, 0), text, "test.pov");
      }
}

TEST_CASE("camera text: it tells that a calcite polarizer has indices of its own") {
  const std::string camera =
      "global_settings { mm_per_unit 1 } background { rgb 1 } camera { location -z polarizer { calcite angle 0 ";
  CHECK(camera_text(read(camera + "} }").scene).find("index_o") == std::string::npos);
  CHECK(camera_text(read(camera + "index_o { constant 1.6 } } }").scene).find("index_o") != std::string::npos);
}

}  // namespace nicol::preview
