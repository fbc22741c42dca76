#include "tests/opencl/stand_in.hpp"

#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "host/opencl/gather.hpp"
#include "kernels/abi.h"

namespace nicol {

const char* const stand_in_trace = R"(
#include "abi.h"
#include "portable.h"
__kernel __attribute__((reqd_work_group_size(LOCAL_SIZE, 1, 1)))
void trace(__global const int* ints, __global const scalar* reals, __global const scalar* tables,
           __global const scalar* samples, __global const int* pixels, __global scalar* out, __global uint* counters,
           int listed, int first_item, int item_count, int sample_begin, int sample_end) {
  int g = (int)get_global_id(0);
  if (g >= item_count) return;
  int item = first_item + g;
  struct { int features; } scene_on_stack = { ints[HEADER_FEATURES] }, *scene = &scene_on_stack;
  int over_pixels = has(lanes_over_pixels, scene);
  int parts = over_pixels ? ints[HEADER_LAMBDA_COUNT] : ints[HEADER_LAMBDA_STRIDE] / LANES;
  for (int c = 0; c < OUT_COMPONENTS; ++c)
    for (int lane = 0; lane < LANES; ++lane) {
      int pixel = over_pixels ? item / parts * LANES + lane : item / parts;
      if (listed > 0) pixel = pixels[min(pixel, listed - 1)];
      int w = over_pixels ? item % parts : item % parts * LANES + lane;
      scalar sum = 0;
      for (int s = sample_begin; s < sample_end; ++s)
        sum += tables[w] * (scalar)(pixel + 1) + (scalar)c + (scalar)0.1 * samples[2 * s] +
               (scalar)0.01 * samples[2 * s + 1];
      scalar half_sum = (scalar)0.5 * sum;
      for (int turn = 0; turn < (int)reals[0]; ++turn) sum = (scalar)0.5 * sum + half_sum;
      out[(g * OUT_COMPONENTS + c) * LANES + lane] = sum;
    }
  atomic_add(counters + COUNT_SEGMENTS, (uint)(LANES * (sample_end - sample_begin)));
  if (item == 0 && sample_begin == 0) atomic_inc(counters + COUNT_NAN);
}
)";

KernelFolder::KernelFolder() : KernelFolder(std::map<std::string, std::string>{{"trace.cl", stand_in_trace}}) {}

KernelFolder::KernelFolder(const std::map<std::string, std::string>& files) {
  char folder[] = "/tmp/nicol kernels XXXXXX";
  path_ = mkdtemp(folder);
  for (const auto& [name, text] : files) write(name, text);
  setenv("NICOL_KERNEL_DIR", path_.c_str(), 1);
}

KernelFolder::~KernelFolder() {
  unsetenv("NICOL_KERNEL_DIR");
  std::filesystem::remove_all(path_);
}

void KernelFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ + "/" + name) << text;
}

Environment::Environment(const char* name, const std::string& value) : name_(name) {
  const char* before = getenv(name);
  had_ = before != nullptr;
  if (had_) before_ = before;
  setenv(name, value.c_str(), 1);
}

Environment::~Environment() {
  if (had_)
    setenv(name_.c_str(), before_.c_str(), 1);
  else
    unsetenv(name_.c_str());
}

PackedScene stand_in_scene(int width, int height, int channels, int lanes, bool over_pixels) {
  PackedScene scene;
  scene.width = width;
  scene.height = height;
  scene.channels = channels;
  scene.stride = (channels + lanes - 1) / lanes * lanes;
  scene.features = over_pixels ? lanes_over_pixels_bit() : 0u;
  scene.ints.assign(HEADER_SIZE, 0);
  scene.ints[HEADER_FEATURES] = static_cast<std::int32_t>(scene.features);
  scene.ints[HEADER_LAMBDA_COUNT] = channels;
  scene.ints[HEADER_LAMBDA_STRIDE] = scene.stride;
  scene.reals = {0};
  for (int w = 0; w < scene.stride; ++w) scene.tables.push_back(1 + w / 8.0);
  return scene;
}

std::vector<double> wavelengths(int count) {
  std::vector<double> lambda_nm;
  for (int w = 0; w < count; ++w) lambda_nm.push_back(400 + 10 * w);
  return lambda_nm;
}

double stand_in_value(int component, int pixel, int wavelength,
                      const std::vector<std::array<double, 2>>& samples) {
  double sum = 0;
  for (const auto& [x, y] : samples) sum += (1 + wavelength / 8.0) * (pixel + 1) + component + 0.1 * x + 0.01 * y;
  return sum / static_cast<double>(samples.size());
}

}  // namespace nicol
