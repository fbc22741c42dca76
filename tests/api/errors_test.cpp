// What callers get wrong becomes a status: NULL, numbers outside enumerations, sizes of structs, folders, exceptions.
#include <doctest/doctest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

#include "scenes.hpp"

using namespace api_test;

namespace {

template <class Struct>
Struct sized_struct() {
  Struct made{};
  made.struct_size = sizeof made;
  return made;
}

struct Loaded {
  explicit Loaded(int width = 40, int height = 30) {
    REQUIRE(nicol_context_create(nullptr, &context) == NICOL_OK);
    auto options = sized_struct<nicol_scene_options>();
    options.width = width;
    options.height = height;
    REQUIRE(nicol_scene_load_text(context, "cube.pov", cube, std::string(cube).size(), &options, &scene) == NICOL_OK);
  }
  ~Loaded() {
    nicol_scene_release(scene);
    nicol_context_release(context);
  }
  nicol_context* context = nullptr;
  nicol_scene* scene = nullptr;
};

bool told(const std::string& part) { return std::string(nicol_last_error()).find(part) != std::string::npos; }

}  // namespace

TEST_CASE("NULL is refused wherever it makes no sense") {
  const Loaded with;
  nicol_scene* scene = nullptr;
  nicol_picture* picture = nullptr;
  const float* values = nullptr;
  std::int32_t number = 0;
  const auto refused = [](nicol_status status) { return status == NICOL_ERROR_ARGUMENT && told("NULL"); };
  CHECK(refused(nicol_device_count(nullptr)));
  CHECK(refused(nicol_device_get(0, nullptr)));
  CHECK(refused(nicol_context_create(nullptr, nullptr)));
  CHECK(refused(nicol_context_device(nullptr, nullptr)));
  CHECK(refused(nicol_scene_load_file(nullptr, "a.pov", nullptr, &scene)));
  CHECK(refused(nicol_scene_load_file(with.context, nullptr, nullptr, &scene)));
  CHECK(refused(nicol_scene_load_file(with.context, "a.pov", nullptr, nullptr)));
  CHECK(refused(nicol_scene_load_text(with.context, "a.pov", nullptr, 3, nullptr, &scene)));
  CHECK(refused(nicol_scene_diagnostic(nullptr, 0, nullptr)));
  CHECK(refused(nicol_scene_feature(with.scene, 0, nullptr)));
  CHECK(refused(nicol_scene_explanation(with.scene, nullptr)));
  CHECK(refused(nicol_scene_size(with.scene, nullptr, &number)));
  CHECK(refused(nicol_scene_wavelengths(nullptr, nullptr, nullptr)));
  CHECK(refused(nicol_render(nullptr, nullptr, &picture)));
  CHECK(refused(nicol_render(with.scene, nullptr, nullptr)));
  CHECK(nicol_merge(with.context, nullptr, 1, nullptr, &picture) == NICOL_ERROR_ARGUMENT);
  CHECK(refused(nicol_picture_stokes(nullptr, &values)));
  CHECK(refused(nicol_picture_plane(nullptr, 0, &values)));
  CHECK(refused(nicol_picture_write(nullptr, "a.exr")));
  CHECK(refused(nicol_include_set_text(nullptr, "a", 1)));
  CHECK(nicol_scene_diagnostic_count(nullptr) == 0);
  CHECK(nicol_picture_note_count(nullptr) == 0);
  CHECK(nicol_scene_is_whole(nullptr) == 0);
  nicol_scene_release(nullptr);
  nicol_picture_release(nullptr);
  nicol_context_release(nullptr);
  CHECK(nicol_scene_retain(nullptr) == nullptr);
}

TEST_CASE("numbers that make no sense are refused, with words") {
  const Loaded with;
  nicol_picture* picture = nullptr;
  const auto render = [&](auto set) {
    auto options = sized_struct<nicol_render_options>();
    set(options);
    return nicol_render(with.scene, &options, &picture);
  };
  CHECK(render([](auto& o) { o.precision = 5; }) == NICOL_ERROR_ARGUMENT);
  CHECK(told("precision 5"));
  CHECK(render([](auto& o) { o.lanes = 3; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.generic = 2; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.part = 3, o.part_count = 2; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.first_row = 29, o.row_count = 2; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.first_wavelength_nm = 700, o.last_wavelength_nm = 800; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.resume = 1; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.row_count = 3, o.want_error_bound = 1; }) == NICOL_ERROR_ARGUMENT);
  CHECK(render([](auto& o) { o.part = 1, o.part_count = 2, o.want_error_budget = 1; }) == NICOL_ERROR_ARGUMENT);
  CHECK(told("want_error_budget does not go with a part"));
  CHECK(picture == nullptr);
  nicol_scene* scene = nullptr;
  const auto load = [&](auto set) {
    auto options = sized_struct<nicol_scene_options>();
    set(options);
    return nicol_scene_load_text(with.context, "t.pov", "", 0, &options, &scene);
  };
  const char* name = "a=b";
  const double nan = std::numeric_limits<double>::quiet_NaN(), twice[] = {500, 500};
  CHECK(load([](auto& o) { o.width = -1; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([](auto& o) { o.error = 2; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([](auto& o) { o.polarization = 9; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([&](auto& o) { o.declare_count = 1, o.declare_names = &name, o.declare_values = &nan; }) == NICOL_ERROR_ARGUMENT);
  const char* no_name = "x; box{}";
  const double one = 1;
  CHECK(load([&](auto& o) { o.declare_count = 1, o.declare_names = &no_name, o.declare_values = &one; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([&](auto& o) { o.clock = nan; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([&](auto& o) { o.initial_frame = 9, o.final_frame = 3; }) == NICOL_ERROR_ARGUMENT);
  CHECK(load([](auto& o) { o.frame_number = 5, o.final_frame = 3; }) == NICOL_ERROR_ARGUMENT);
  CHECK(told("frame_number 5"));
  CHECK(load([](auto& o) { o.frame_number = 1, o.initial_frame = 2, o.final_frame = 3; }) == NICOL_ERROR_ARGUMENT);
  const char* word = "box";
  CHECK(load([&](auto& o) { o.declare_count = 1, o.declare_names = &word, o.declare_values = &one; }) == NICOL_ERROR_ARGUMENT);
  CHECK(told("'box' is a word of the language"));
  for (const double nm : {-3.0, 0.0, 1e9, nan}) {
    CHECK(load([&](auto& o) { o.wavelength_count = 1, o.wavelengths_nm = &nm; }) == NICOL_ERROR_ARGUMENT);
    CHECK(told("wavelengths_nm"));
  }
  CHECK(load([&](auto& o) { o.wavelength_count = 2, o.wavelengths_nm = twice; }) == NICOL_ERROR_ARGUMENT);
  CHECK(scene == nullptr);
  REQUIRE(nicol_render(with.scene, nullptr, &picture) == NICOL_OK);
  const float* values = nullptr;
  CHECK(nicol_picture_plane(picture, 99, &values) == NICOL_ERROR_ARGUMENT);
  CHECK(nicol_picture_plane(picture, NICOL_PLANE_ERROR_TOTAL, &values) == NICOL_ERROR_UNAVAILABLE);
  nicol_picture_release(picture);
}

TEST_CASE("structs of an older and of a newer header") {
  const Loaded with;
  auto options = sized_struct<nicol_scene_options>();
  options.width = options.height = 8;
  options.samples = -1;
  options.polarization = 77;
  options.struct_size = offsetof(nicol_scene_options, samples);
  nicol_scene* scene = nullptr;
  CHECK(nicol_scene_load_text(with.context, "cube.pov", cube, std::string(cube).size(), &options, &scene) == NICOL_OK);
  std::int32_t width = 0, height = 0;
  CHECK(nicol_scene_size(scene, &width, &height) == NICOL_OK);
  CHECK(width == 8);
  struct Newer {
    nicol_render_options known;
    std::int64_t unknown;
  } newer{};
  newer.known.struct_size = sizeof newer;
  nicol_picture* picture = nullptr;
  newer.unknown = 1;
  CHECK(nicol_render(scene, &newer.known, &picture) == NICOL_ERROR_ARGUMENT);
  CHECK(told("does not know"));
  newer.unknown = 0;
  CHECK(nicol_render(scene, &newer.known, &picture) == NICOL_OK);
  nicol_picture* none = nullptr;
  for (const std::uint32_t never_set : {0u, 0x7fffffffu}) {
    newer.known.struct_size = never_set;
    CHECK(nicol_render(scene, &newer.known, &none) == NICOL_ERROR_ARGUMENT);
    auto device = sized_struct<nicol_device_info>();
    device.struct_size = never_set;
    CHECK(nicol_device_get(0, &device) == NICOL_ERROR_ARGUMENT);
  }
  auto report = sized_struct<nicol_report>();
  report.segments = 77;
  report.struct_size = offsetof(nicol_report, segments);
  CHECK(nicol_picture_report(picture, &report) == NICOL_OK);
  CHECK(report.lanes > 0);
  CHECK(report.segments == 77);
  nicol_picture_release(picture);
  nicol_scene_release(scene);
}

TEST_CASE("a picture that cannot be written says where") {
  const Loaded with;
  nicol_picture* picture = nullptr;
  REQUIRE(nicol_render(with.scene, nullptr, &picture) == NICOL_OK);
  for (const char* path : {"/proc/self/picture.exr", "/nowhere/picture.png", "picture.txt"}) {
    CHECK(nicol_picture_write(picture, path) == NICOL_ERROR_OUTPUT);
    CHECK_MESSAGE(told(path), nicol_last_error());
  }
  CHECK(nicol_picture_write_error_map(picture, "map.exr") == NICOL_ERROR_UNAVAILABLE);
  nicol_picture_release(picture);
}

TEST_CASE("an exception from a callback is a status, and its words are kept") {
  const Loaded with;
  auto options = sized_struct<nicol_render_options>();
  options.tile = [](void*, const nicol_tile*) -> int { throw std::runtime_error("thrown by the tile"); };
  nicol_picture* picture = nullptr;
  CHECK(nicol_render(with.scene, &options, &picture) == NICOL_ERROR_CALLBACK);
  CHECK(told("thrown by the tile"));
  nicol_picture_release(picture);
  picture = nullptr;
  auto scene_options = sized_struct<nicol_scene_options>();
  scene_options.include = [](void*, const char*, nicol_include*) -> int { throw 7; };
  nicol_scene* scene = nullptr;
  const std::string text = "#include \"a.inc\"";
  CHECK(nicol_scene_load_text(with.context, "t.pov", text.c_str(), text.size(), &scene_options, &scene) == NICOL_ERROR_CALLBACK);
  CHECK(scene == nullptr);
}

TEST_CASE("a callback may read, but not render") {
  Loaded with;
  struct Seen {
    nicol_scene* scene;
    nicol_status render;
    std::size_t features;
  } seen{with.scene, NICOL_OK, 0};
  auto options = sized_struct<nicol_render_options>();
  options.user = &seen;
  options.tile = [](void* user, const nicol_tile*) {
    auto* s = static_cast<Seen*>(user);
    nicol_picture* inner = nullptr;
    s->render = nicol_render(s->scene, nullptr, &inner);
    s->features = nicol_scene_feature_count(s->scene);
    return 0;
  };
  nicol_picture* picture = nullptr;
  CHECK(nicol_render(with.scene, &options, &picture) == NICOL_OK);
  CHECK(seen.render == NICOL_ERROR_ARGUMENT);
  CHECK(seen.features > 0);
  nicol_picture_release(picture);
}
