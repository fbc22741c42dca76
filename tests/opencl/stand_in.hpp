// A kernel in place of the tracer: same entry point, answers that a test can work out.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/render.hpp"

namespace nicol {

// Kernel files in a temporary folder that NICOL_KERNEL_DIR names, for the life of the object.
class KernelFolder {
 public:
  KernelFolder();   // trace.cl is the stand-in
  explicit KernelFolder(const std::map<std::string, std::string>& files);
  KernelFolder(const KernelFolder&) = delete;
  ~KernelFolder();
  void write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

// Sets an environment variable for the life of the object.
class Environment {
 public:
  Environment(const char* name, const std::string& value);
  ~Environment();

 private:
  std::string name_, before_;
  bool had_ = false;
};

// A cache that holds nothing yet.
class OwnCache {
 public:
  OwnCache() : folder_(cache_folder() + "/side"), environment_("XDG_CACHE_HOME", folder_) {}
  OwnCache(const OwnCache&) = delete;
  ~OwnCache() { std::filesystem::remove_all(folder_); }

 private:
  std::string folder_;
  Environment environment_;
};

// Component c of pixel p, wavelength w at sample (x, y): table[w] * (p + 1) + c + 0.1 x + 0.01 y.
// Each value takes `reals[0]` turns of a loop.
extern const char* const stand_in_trace;

// channels wavelengths, table row 1 + w / 8; stride for these lanes.
PackedScene stand_in_scene(int width, int height, int channels, int lanes, bool over_pixels = false);

std::vector<double> wavelengths(int count);

// What the device has to give, worked out here in double.
double stand_in_value(int component, int pixel, int wavelength, const std::vector<std::array<double, 2>>& samples);

}  // namespace nicol
