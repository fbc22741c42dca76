// What of a picture a run renders: all, a share that is dealt out, a window, some of the wavelengths, or what these have in common.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/engine/loaded_scene.hpp"
#include "host/output/part.hpp"
#include "host/pack.hpp"

namespace nicol::engine {

struct PictureShare {
  std::vector<std::int32_t> pixels;  // row * width + column, ascending; empty: all
  WavelengthRange wavelengths;       // count 0: all
  std::string name;                  // "share 2/3, 450..550 nm"; "": the whole picture
  bool window_only = false;          // nothing but a window: a picture to look at
  bool whole() const { return name.empty(); }
};

// Of the command's options. Windows and ranges of wavelengths that leave nothing out are none; share 1/1 is a share all the same, so that it
// can be merged whatever n is. UsageError where they make no sense, or come with what needs a whole picture (the error targets of the
// command, an error map, a .png of a dealt share or of some wavelengths).
PictureShare choose_share(const PictureOptions& command, const std::vector<std::string>& outputs, const Scene& scene);

// UsageError where a picture of this share cannot be written there.
void check_output(const PictureShare& share, const std::string& path);

// What has to be rendered for a share. Waves are followed heaviest first, by what lanes hold together, and sums are formed in that order: their last bits
// depend on all lanes. So lanes hold what they hold in the whole picture, and what is not wanted of that is left out afterwards.
PictureShare whole_lanes(const PictureShare& share, const PackedScene& whole, std::size_t wavelengths, int lanes);

// POV-Ray 3.7 documentation, "Partial Output Options"; fractions are rounded as POV-Ray 3.7.0.10 does: the first
// is floor(f n) + 1, the last floor(f n), counted from 1. UsageError where nothing is left.
PixelRange pixel_range(std::optional<double> start, std::optional<double> end, int count, const std::string& what);

// "2/3" as {2, 3}, "450..550" as {450, 550}. UsageError otherwise.
std::array<int, 2> parse_share(const std::string& text);
std::array<double, 2> parse_wavelength_part(const std::string& text);

// What all parts of this picture must have in common.
WholePicture whole_picture(const LoadedScene& loaded, const PictureOptions& command);

}  // namespace nicol::engine
