// A picture whose every value tells where it belongs, and a folder that goes away.
#pragma once
#include <filesystem>
#include <string>

#include "host/output/frame.hpp"

namespace nicol {

// stokes = 64 s + 8 i + x/16 + y/256, cut_off = x + y/8: exact in float. Wavelengths 400, 580,
// 633.2 nm.
Frame pattern_frame(int width, int height);
float pattern_value(int s, std::size_t i, int x, int y);

// A picture of one colour of light per pixel: linear sRGB from (left to right, top to bottom)
// `rgb`.
Frame colour_frame(int width, int height, const std::vector<float>& rgb);

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  int entries() const;

 private:
  std::filesystem::path path_;
};

std::string contents(const std::string& path);

}  // namespace nicol
