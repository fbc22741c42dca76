// compare_exr A B: exit code 0 where two EXR files have the same channels with the same bits in every pixel; else 1, and a line for
// each channel that differs.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <vector>

namespace {

std::map<std::string, std::vector<float>> channels(const char* path) {
  Imf::InputFile file(path);
  const auto window = file.header().dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::map<std::string, std::vector<float>> found;
  Imf::FrameBuffer pixels;
  for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c) {
    std::vector<float>& values = found[c.name()];
    values.resize(static_cast<std::size_t>(width) * height);
    pixels.insert(c.name(), Imf::Slice::Make(Imf::FLOAT, values.data(), window));
  }
  file.setFrameBuffer(pixels);
  file.readPixels(window.min.y, window.max.y);
  return found;
}

bool differs(const std::string& name, const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0 && count++ == 0) first = i;
  if (a.size() != b.size()) std::printf("%s: %zu and %zu pixels\n", name.c_str(), a.size(), b.size());
  else if (count > 0)
    std::printf("%s: %zu of %zu pixels differ, first %zu: %.9g and %.9g\n", name.c_str(), count, a.size(), first,
                static_cast<double>(a[first]), static_cast<double>(b[first]));
  return count > 0 || a.size() != b.size();
}

int compare(const char* one, const char* two) {
  const auto a = channels(one), b = channels(two);
  bool different = a.empty();
  for (const auto& [name, values] : a) {
    const auto other = b.find(name);
    if (other == b.end()) std::printf("%s: only in %s\n", name.c_str(), one);
    different |= other == b.end() || differs(name, values, other->second);
  }
  for (const auto& [name, values] : b)
    if (a.count(name) == 0) {
      std::printf("%s: only in %s\n", name.c_str(), two);
      different = true;
    }
  return different ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return argc == 3 ? compare(argv[1], argv[2]) : 2;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 2;
  }
}
