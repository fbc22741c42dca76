#include "tests/hard/bench.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "host/bind/bind.hpp"
#include "host/features.hpp"
#include "host/pack.hpp"
#include "sdl/parse.hpp"

namespace nicol::hard {
namespace {

enum : std::uint32_t {
#define FEATURE(name, bit, meaning) name = 1u << bit,
#include "kernels/features.def"
#undef FEATURE
};

// Sets of effects whose kernels the scenes share, smallest first. An effect too many changes nothing; what says
// how lanes are filled is the scene's own.
constexpr std::uint32_t isotropic =
    polarization | full_jones | absorption | rotation | ideal_polarizer | luminous_sheets |
                                    polarizing_sheets | luminous_faces | light_contacts | discs | solid_contacts |
                                    many_solids | nested_solids | orthographic;
constexpr std::uint32_t crystals = isotropic | birefringence | general_waves | gyration | pleochroism | coherent_waves |
                                   camera_in_crystal;

std::uint32_t shared_mask(std::uint32_t mask) {
  const std::uint32_t layout = mask & lanes_over_pixels;
  for (const std::uint32_t set : {isotropic, crystals})
    if (!(mask & ~(set | layout))) return set | layout;
  return mask;
}

Device& device() {
  static const std::shared_ptr<Device> one = open_device("");
  return *one;
}

void aim(Scene& scene, const Look& look, int width, int height) {
  const Vec3 d = test::unit(look.along);
  const Vec3 wanted = std::fabs(test::dot(test::unit(look.right), d)) < 0.999 ? look.right : Vec3{d.z, d.x, d.y};
  const Vec3 right = test::unit(test::plus(wanted, test::scaled(-test::dot(wanted, d), d)));
  scene.camera.orthographic = true;
  scene.camera.location = look.from;
  scene.camera.direction = d;
  scene.camera.right = test::scaled(width * look.pixel_mm, right);
  scene.camera.up = test::scaled(height * look.pixel_mm, test::cross(right, d));
}

std::vector<Seen> native_picture(const Kernels& kernels, const PackedScene& packed, test::Counters& counters) {
  std::vector<Seen> out;
  for (const auto& pixel : kernels.render(packed, counters)) {
    Seen seen;
    for (int i = 0; i < 4; ++i) seen.s[i] = pixel[i];
    seen.cut_off = pixel[4];
    out.push_back(seen);
  }
  return out;
}

std::vector<Seen> device_picture(const Way& way, const PackedScene& packed, const Scene& scene, double tile_seconds,
    RenderReport& report) {
  RenderOptions options;
  options.kernel.real_double = way.real_double;
  options.kernel.lanes = way.lanes;
  options.kernel.generic = !way.specialised;
  options.tile_seconds = tile_seconds;
  const Frame frame = render(device(), packed, scene.lambda_nm, scene.weight_nm, options, report);
  std::vector<Seen> out(frame.plane() * scene.lambda_nm.size());
  for (std::size_t pixel = 0; pixel < frame.plane(); ++pixel)
    for (std::size_t w = 0; w < scene.lambda_nm.size(); ++w) {
      Seen& seen = out[pixel * scene.lambda_nm.size() + w];
      for (int i = 0; i < 4; ++i) seen.s[i] = static_cast<double>(frame.component(i, w)[pixel]);
      seen.cut_off = static_cast<double>(frame.cut_off[pixel]);
    }
  return out;
}

}  // namespace

Stage stage_of(const std::string& text, const std::vector<double>& lambda_nm, const Vec3& camera) {
  sdl::Result parsed;
  const std::string around = "global_settings { mm_per_unit 1 }\ncamera { location -1000*z }\n";
  sdl::parse_text("hard.pov", around + text, {}, parsed);
  BindOptions options;
  options.lambda_nm = lambda_nm;
  options.width = options.height = 1;
  Stage stage;
  stage.scene = bind(parsed.document, options, parsed.diagnostics);
  stage.scene.camera.location = camera;
  stage.scene.settings.max_trace_level = 1000000;
  stage.scene.settings.adc_bailout = 1e-18;
  if (!parsed.diagnostics.failed()) stage.geometry = build_geometry(stage.scene, parsed.diagnostics);
  if (parsed.diagnostics.failed()) throw std::runtime_error(parsed.diagnostics.text());
  return stage;
}

Stage stage_of(TestScene scene) {
  scene.packed(1);
  return {scene.scene, scene.geometry};
}

const Kernels& Way::native() const {
  if (real_double) return lanes == 8 ? test::double8 : test::double1;
  return lanes == 8 ? test::float8 : test::float1;
}

std::vector<Way> all_ways() {
  std::vector<Way> out;
  for (const bool real_double : {false, true})
    for (const int lanes : {1, 8})
      for (const bool specialised : {false, true}) out.push_back({real_double, lanes, specialised});
  return out;
}

std::vector<Seen> Bench::look(const Stage& stage, const Look& look) { return this->look(stage, look, 1, 1); }

std::vector<Seen> Bench::look(const Stage& stage, const Look& look, int width, int height) {
  Scene scene = stage.scene;
  aim(scene, look, width, height);
  const std::uint32_t mask = shared_mask(decide_features(scene, stage.geometry).mask | orthographic);
  const PackedScene packed = pack(scene, stage.geometry, mask, width, height, way_.lanes);
  test::Counters counters;
  if (!way_.specialised) {
    const auto out = native_picture(way_.native(), packed, counters);
    hold("counters", "no number fails, R + T = 1, no stack is full", 0,
        counters.nan + counters.energy + counters.stack);
    return out;
  }
  RenderReport report;
  const auto out = device_picture(way_, packed, scene, tile_seconds, report);
  hold("counters", "no number fails, R + T = 1, no stack is full", 0,
       static_cast<double>(report.nan_count + report.energy_count + report.stack_count));
  return out;
}

void Bench::hold(const std::string& quantity, const std::string& reason, double bound, double error) {
  table_.hold(way_.column(), name_, quantity, reason, bound, error);
}

void Bench::hold_seen(const std::string& quantity, const std::string& reason, double bound, double seen,
    double expected,
                      double size) {
  const double storage = way_.specialised ? size * 0x1p-24 : 0;
  const double off = std::fabs(seen - expected);
  hold(quantity, reason, bound, off <= storage ? 0 : off - storage);
}

}  // namespace nicol::hard
