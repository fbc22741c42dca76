// Which picture a file holds, by what its header says that it belongs to.
#pragma once
#include <map>
#include <string>

#include "host/output/part.hpp"

namespace nicol {

// Size and notes of a PNG. Throws InputError.
struct PngNotes {
  int width = 0, height = 0;
  std::map<std::string, std::string> notes;
};
PngNotes read_png_notes(const std::string& path);

// "" if the file holds this picture, or this part of it ("": all), whatever device made it; else why that is not so: "the samples
// differ (4, 16)". Only .exr and .png can tell.
std::string why_another(const std::string& path, const WholePicture& wanted, const std::string& part);

}  // namespace nicol
