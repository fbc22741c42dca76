// Speed, as ratios from one run: lanes against scalar against native C++, what each feature costs, what tiling
// and kernel builds cost. Every variant runs in turn, several rounds; medians of CPU time per lane-segment.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>

#include "host/engine/loaded_scene.hpp"
#include "host/pack.hpp"
#include "kernels/abi.h"
#include "tests/bench/native.hpp"
#include "tests/bench/sampling.hpp"

namespace nicol::bench {
namespace {

using engine::LoadedScene;

struct Settings {
  std::string scene = NICOL_SOURCE_DIR "/scenes/founding/fig5_active.pov";
  int size = 256;
  int rounds = 7;
  std::string program;      // this one
  bool cold_build = false;  // only that
  bool only_media = false;
  bool only_sampling = false;
  bool features = true;   // --no-features leaves the long table out
};

double clock_seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

// One way to render the scene: returns the lane-segments traced.
struct Variant {
  std::string name;
  std::function<double()> run;
  std::vector<double> cpu_ns, wall_s;   // CPU ns per segment, wall seconds, per round
  double segments = 0;
};

// In turn, so that the machine's moods fall on all alike. The first round warms up.
void run_in_turn(std::vector<Variant>& variants, int rounds) {
  for (int round = 0; round <= rounds; ++round) {
    for (Variant& v : variants) {
      const double wall = clock_seconds(CLOCK_MONOTONIC), cpu = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
      v.segments = v.run();
      const double cpu_s = clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
      if (round == 0) continue;
      v.wall_s.push_back(clock_seconds(CLOCK_MONOTONIC) - wall);
      v.cpu_ns.push_back(cpu_s * 1e9 / v.segments);
    }
  }
}

// Ratio to another variant, round by round, so that slow and fast minutes cancel.
double ratio(const Variant& a, const Variant& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.cpu_ns.size(); ++i) ratios.push_back(a.cpu_ns[i] / b.cpu_ns[i]);
  return median(ratios);
}

std::uint64_t segments_on_device(Device& device, const LoadedScene& loaded, std::uint32_t features, const Settings& settings,
                                 RenderOptions options) {
  const PackedScene packed = pack(loaded.scene, loaded.geometry, features, settings.size, settings.size,
                                  lanes_on(device, options.kernel));
  RenderReport report;
  render(device, packed, loaded.scene.lambda_nm, loaded.scene.weight_nm, options, report);
  return report.segments;
}

Variant device_variant(std::string name, Device& device, const LoadedScene& loaded, std::uint32_t features,
                       const Settings& settings, RenderOptions options) {
  return {std::move(name),
          [&device, &loaded, features, &settings, options] {
            return static_cast<double>(segments_on_device(device, loaded, features, settings, options));
          },
          {}, {}, 0};
}

void bench_lanes(Device& device, const LoadedScene& loaded, const Settings& settings) {
  const std::uint32_t mask = loaded.features.mask;
  RenderOptions lanes, scalar, generic, fp64;
  scalar.kernel.lanes = 1;
  generic.kernel.generic = true;
  std::vector<Variant> variants;
  variants.push_back(device_variant("OpenCL, lanes", device, loaded, mask, settings, lanes));
  variants.push_back(device_variant("OpenCL, one lane", device, loaded, mask, settings, scalar));
  variants.push_back(device_variant("OpenCL, lanes, generic build", device, loaded, mask, settings, generic));
  if (info(device).has_fp64) {
    fp64.kernel.real_double = true;
    variants.push_back(device_variant("OpenCL, lanes, double", device, loaded, mask, settings, fp64));
  }
  if (mask == NICOL_BENCH_FEATURES) {
    const auto native = [&](int count, NativeResult (*run)(const PackedScene&)) {
      return [&loaded, &settings, count, run] {
        return static_cast<double>(
            run(pack(loaded.scene, loaded.geometry, loaded.features.mask, settings.size, settings.size, count)).segments);
      };
    };
    variants.push_back({"native C++, lanes", native(native_lanes, render_native_lanes), {}, {}, 0});
    variants.push_back({"native C++, one lane", native(1, render_native_scalar), {}, {}, 0});
  } else {
    fmt::print("(no native comparison: it is compiled for the features 0x{:x}, the scene has 0x{:x})\n", NICOL_BENCH_FEATURES, mask);
  }
  run_in_turn(variants, settings.rounds);
  fmt::print("\n{:<32}{:>14}{:>16}{:>12}\n", "variant", "Msegments", "ns/seg (CPU)", "speed");
  for (const Variant& v : variants)
    fmt::print("{:<32}{:>14.2f}{:>16.2f}{:>11.2f}x\n", v.name, v.segments * 1e-6, median(v.cpu_ns), ratio(variants[0], v));
  fmt::print("lanes / one lane: {:.2f}x", ratio(variants[1], variants[0]));
  if (variants.size() >= 6) fmt::print("   of native lanes: {:.2f}", ratio(variants[4], variants[0]));
  fmt::print("\n");
}

// Each feature that the scene does not call for, compiled in all the same.
void bench_features(Device& device, const LoadedScene& loaded, const Settings& settings) {
  const std::uint32_t mask = loaded.features.mask;
  std::vector<Variant> variants;
  variants.push_back(device_variant("(as called for)", device, loaded, mask, settings, {}));
  std::uint32_t bit = 1;
  for (const FeatureReason& row : loaded.features.rows) {
    const bool layout = row.name == "lanes_over_pixels" || row.name == "orthographic";
    if (!row.on && !layout) variants.push_back(device_variant("+ " + row.name, device, loaded, mask | bit, settings, {}));
    bit <<= 1;
  }
  run_in_turn(variants, settings.rounds);
  fmt::print("\n{:<32}{:>16}{:>12}\n", "feature on though not needed", "ns/seg (CPU)", "cost");
  for (const Variant& v : variants)
    fmt::print("{:<32}{:>16.2f}{:>+11.1f}%\n", v.name, median(v.cpu_ns), 100 * (ratio(v, variants[0]) - 1));
}

// The same cube of each class of medium; what a segment costs against glass, and how many more there are.
int bench_media(Device& device, const Settings& settings) {
  struct Kind {
    const char* name;
    int number;
    bool coherent;
  };
  const Kind kinds[] = {{"glass", 0, true}, {"uniaxial, incoherent", 1, false}, {"uniaxial", 1, true}, {"uniaxial that absorbs", 4, true},
                        {"biaxial", 2, true}, {"active uniaxial", 3, true}};
  std::vector<std::unique_ptr<LoadedScene>> scenes;
  std::vector<Variant> variants;
  for (const Kind& kind : kinds) {
    engine::SceneOptions options;
    options.width = options.height = settings.size;
    options.declares = {fmt::format("Kind={}", kind.number), fmt::format("Coherent={}", kind.coherent ? 1 : 0)};
    scenes.push_back(engine::load_scene(NICOL_SOURCE_DIR "/tests/bench/media.pov", options));
    if (!scenes.back()) return 1;
    variants.push_back(device_variant(kind.name, device, *scenes.back(), scenes.back()->features.mask, settings, {}));
  }
  run_in_turn(variants, settings.rounds);
  fmt::print("\n{:<32}{:>14}{:>16}{:>12}\n", "medium of a cube", "Msegments", "ns/seg (CPU)", "cost");
  for (const Variant& v : variants)
    fmt::print("{:<32}{:>14.2f}{:>16.2f}{:>11.2f}x\n", v.name, v.segments * 1e-6, median(v.cpu_ns), ratio(v, variants[0]));
  return 0;
}

// On a picture large enough for tens of tiles.
void bench_tiles(Device& device, const LoadedScene& loaded, Settings settings) {
  settings.size *= 3;
  RenderOptions tiled, whole;
  whole.tile_seconds = 1e6;
  std::vector<Variant> variants;
  variants.push_back(device_variant("one launch", device, loaded, loaded.features.mask, settings, whole));
  variants.push_back(device_variant("tiles", device, loaded, loaded.features.mask, settings, tiled));
  run_in_turn(variants, settings.rounds);
  std::vector<double> wall;
  for (std::size_t i = 0; i < variants[0].wall_s.size(); ++i) wall.push_back(variants[1].wall_s[i] / variants[0].wall_s[i]);
  fmt::print("\n{0}x{0} in tiles against one launch: {1:+.1f} % CPU, {2:+.1f} % wall\n", settings.size, 100 * (ratio(variants[1], variants[0]) - 1),
             100 * (median(wall) - 1));
}

// Where nothing is cached: asked of a process that starts with empty cache folders (this one has used the driver's).
void bench_cold_build(const LoadedScene& loaded) {
  KernelOptions cold;
  cold.binary_cache = false;
  fmt::print("kernel build: {:.2f} s with nothing cached\n",
             prepare_kernel(*open_device(""), loaded.features.contents(), cold).seconds);
}

void bench_builds(const LoadedScene& loaded, const Settings& settings) {
  std::fflush(stdout);
  const std::string cold = fmt::format(
      "f=$(mktemp -d) && POCL_CACHE_DIR=$f \"$0\" --cold-build --scene \"$1\"; rm -rf \"$f\"");
  setenv("NICOL_BENCH_SHELL", cold.c_str(), 1);
  if (std::system(fmt::format("sh -c \"$NICOL_BENCH_SHELL\" '{}' '{}'", settings.program, settings.scene).c_str()) != 0)
    fmt::print("(the cold build could not be measured)\n");
  prepare_kernel(*open_device(""), loaded.features.contents(), {});
  const BuildReport warm = prepare_kernel(*open_device(""), loaded.features.contents(), {});
  fmt::print("kernel load: {:.3f} s {}\n", warm.seconds, warm.cached ? "from the binary cache" : "(not cached)");
}

int run(const Settings& settings) {
  engine::SceneOptions options;
  options.width = options.height = settings.size;
  const auto loaded = engine::load_scene(settings.scene, options);
  if (!loaded) return 1;
  if (settings.cold_build) {
    bench_cold_build(*loaded);
    return 0;
  }
  const auto device = open_device("");
  fmt::print("{}: {}x{}, {} wavelengths, features 0x{:x}, on {}\n", settings.scene, settings.size, settings.size,
             loaded->scene.lambda_nm.size(), loaded->features.mask, info(*device).name);
  if (settings.only_media) return bench_media(*device, settings);
  bench_lanes(*device, *loaded, settings);
  if (bench_media(*device, settings) != 0) return 1;
  if (settings.features) bench_features(*device, *loaded, settings);
  bench_tiles(*device, *loaded, settings);
  bench_builds(*loaded, settings);
  return 0;
}

}  // namespace
}  // namespace nicol::bench

// nicol_bench [--scene FILE] [--size PIXELS] [--rounds N] [--no-features] [--media]
int main(int argc, char** argv) {
  nicol::bench::Settings settings;
  settings.program = argv[0];
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--cold-build") {
      settings.cold_build = true;
      continue;
    }
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--sampling") {
      settings.only_sampling = true;
      continue;
    }
    if (word == "--media") {
      settings.only_media = true;
      continue;
    }
    if (word == "--no-features") {
      settings.features = false;
      continue;
    }
    if (word == "--scene") settings.scene = value;
    else if (word == "--size") settings.size = std::max(16, std::atoi(value));
    else if (word == "--rounds") settings.rounds = std::max(1, std::atoi(value));
    else {
      fmt::print(stderr, "nicol_bench: unknown option {}\n", word);
      return 1;
    }
    ++i;
  }
  try {
    if (settings.only_sampling) return nicol::bench::compare_sampling(settings.scene, settings.size, settings.rounds);
    return nicol::bench::run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "nicol_bench: {}\n", error.what());
    return 1;
  }
}
