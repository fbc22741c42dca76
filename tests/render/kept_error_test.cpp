// `render --error`: the settings that are picked keep the error against a picture converged in everything.
#include <doctest/doctest.h>

#include <string>

#include "host/accuracy/picture_error.hpp"
#include "host/engine/kept_error.hpp"
#include "host/features.hpp"
#include "tests/render/pictures.hpp"

using namespace nicol;

namespace {

constexpr int size = 32;

engine::PictureOptions command_for(const std::string& scene) {
  engine::PictureOptions command;
  command.scene = NICOL_TEST_FOLDER "/../../scenes/" + scene;
  command.options.width = command.options.height = size;
  return command;
}

Frame draw(const engine::LoadedScene& loaded, Device& device, bool real_double, int samples, RenderReport& report) {
  RenderOptions options;
  options.kernel.real_double = real_double;
  options.samples = samples;
  options.sample_error = loaded.scene.settings.sample_error;
  const Features features = decide_features(loaded.scene, loaded.geometry);
  Frame frame = render(device, pack(loaded.scene, loaded.geometry, features.mask, size, size, lanes_on(device, options.kernel)),
                       loaded.scene.lambda_nm, loaded.scene.weight_nm, options, report);
  frame.exposure = loaded.scene.settings.exposure;
  return frame;
}

// Double, fine steps of wavelength, deep, many samples.
Frame converged(const std::string& scene, const std::string& wavelengths, Device& device) {
  engine::PictureOptions command = command_for(scene);
  command.options.wavelengths = wavelengths;
  const auto loaded = engine::load_scene(command.scene, command.options);
  REQUIRE(loaded);
  loaded->scene.settings.adc_bailout = 1e-7;
  loaded->scene.settings.max_trace_level = 256;
  RenderReport report;
  return draw(*loaded, device, true, 191, report);
}

}  // namespace

TEST_CASE("an error that is asked for is kept against the converged picture") {
  struct Case {
    const char* scene;
    const char* fine;  // wavelengths of the reference
  };
  const auto device = open_device("");
  for (const Case& c : {Case{"founding/fig5_active.pov", "380:780:2.5"}, Case{"founding/fig7_camera2.pov", ""}}) {
    CAPTURE(c.scene);
    const Frame reference = converged(c.scene, c.fine, *device);
    for (const double error : {0.05, 0.01}) {
      engine::PictureOptions command = command_for(c.scene);
      auto loaded = engine::load_scene(command.scene, command.options);
      REQUIRE(loaded);
      const std::atomic<bool> cancel{false};
      const auto chosen = engine::choose_settings(loaded, command, *device, error, cancel);
      CHECK(chosen.reachable);
      CHECK(!chosen.real_double);
      RenderReport report;
      const Frame frame = draw(*loaded, *device, chosen.real_double, 1, report);
      const PictureError off = picture_error(frame, reference);
      MESSAGE(std::string(c.scene) << ", asked " << error << ": Stokes " << off.stokes_rms << ", XYZ " << off.xyz_rms << " with "
                                   << chosen.text);
      CHECK(off.rms() <= error);
      CHECK(off.rms() > error / 100);  // not by doing everything
    }
  }
}

TEST_CASE("what float cannot keep moves to double") {
  const auto device = open_device("");
  if (!info(*device).has_fp64) return;
  engine::PictureOptions command = command_for("founding/fig7_camera2.pov");
  auto loaded = engine::load_scene(command.scene, command.options);
  REQUIRE(loaded);
  const std::atomic<bool> cancel{false};
  const auto chosen = engine::choose_settings(loaded, command, *device, 1e-5, cancel);
  CHECK(chosen.real_double);
}
