// The founding paper's scenes: nothing to complain of, and what can be checked without a picture
// holds.
#include "bound.hpp"
#include "host/bind/affine.hpp"
#include "host/optics/colour.hpp"

namespace nicol {

namespace {

const char* const figures[] = {"fig5_inactive", "fig5_active",  "fig6_large",  "fig6_small",
                               "fig7_camera1",  "fig7_camera2", "fig8_corner", "fig9_camera1",
                               "fig9_camera2",  "colours"};

Bound bind_figure(const std::string& name) {
  Bound b;
  sdl::parse_file(std::string(SCENES_FOLDER "/founding/") + name + ".pov", test_options(),
                  *b.parsed);
  BindOptions wanted;
  wanted.width = wanted.height = 400;
  b.scene = bind(b.parsed->document, wanted, b.parsed->diagnostics);
  CHECK_MESSAGE(b.parsed->diagnostics.all().empty(), name, "\n", b.text());
  return b;
}

std::array<double, 3> malus_xyz(const Scene& s, const Expectation& e) {
  Samples radiance = s.emissions.at(0).radiance;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double turned_deg = s.media.at(e.medium).rotation_deg_per_mm[i] * e.length_mm;
    radiance[i] *= std::pow(std::cos(turned_deg * 3.14159265358979323846 / 180), 2);
  }
  return Observer(s.lambda_nm, s.weight_nm).xyz(radiance.data());
}

}  // namespace

TEST_CASE("every founding scene binds without a word") {
  for (const char* name : figures) {
    const Bound b = bind_figure(name);
    INFO(name);
    CHECK(b.scene.objects.size() == 2);
    CHECK(b.scene.polarizers.size() == 2);
    CHECK_FALSE(b.scene.expectations.empty());
    const std::string figure = std::string(name).substr(0, 4);
    const std::size_t count = figure == "fig7" || figure == "fig8" ? 1 : figure == "colo" ? 81 : 21;
    CHECK(b.scene.lambda_nm.size() == count);
  }
}

TEST_CASE("both polarizers pass the same plane, and the cube stands on the light") {
  const Bound b = bind_figure("fig5_active");
  check_near(b.scene.polarizers[0].transmission_axis, {0, 0, -1});
  check_near(b.scene.polarizers[1].transmission_axis, {0, 0, -1});
  const Object& cube = b.scene.objects.at(1);
  check_near(transform_point(cube.transforms, {0, -8, 0}), {0, 0, 0});
  check_near(transform_point(cube.transforms, {0, 8, 0}), {0, 16, 0});
  CHECK(b.scene.camera.location.x == 0);
  CHECK(b.scene.camera.location.z == 0);
}

TEST_CASE("the paper's colours before Fresnel losses") {
  for (const char* name : {"fig5_active", "fig6_large", "fig6_small", "colours"}) {
    const Bound b = bind_figure(name);
    int checked = 0;
    for (const Expectation& e : b.scene.expectations) {
      if (e.quantity != Expectation::Quantity::malus_xyz) continue;
      ++checked;
      const auto xyz = malus_xyz(b.scene, e);
      INFO(name, ": ", xyz[0], " ", xyz[1], " ", xyz[2]);
      for (int i = 0; i < 3; ++i)
        CHECK(std::abs(xyz[i] - e.value[i]) <= e.tolerance * (e.relative ? e.value[i] : 1));
    }
    CHECK(checked == (std::string(name) == "colours" ? 2 : 1));
  }
}

TEST_CASE("27008 degrees along the edge at 580 nm") {
  const Bound b = bind_figure("fig7_camera1");
  CHECK(b.scene.media.at(1).rotation_deg_per_mm[0] * 16 == doctest::Approx(27008.17).epsilon(5e-7));
}

}  // namespace nicol
