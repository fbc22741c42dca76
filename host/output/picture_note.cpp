// See picture_note.hpp.
#include "host/output/picture_note.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "host/output/exr_source.hpp"
#include "host/output/frame.hpp"

namespace nicol {
namespace {

struct Header {
  int width = 0, height = 0;
  bool whole = true;  // no pixels are missing
  std::map<std::string, std::string> notes;
};

Header read_header(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  if (suffix == ".png") {
    PngNotes png = read_png_notes(path);
    return {png.width, png.height, true, std::move(png.notes)};
  }
  if (suffix != ".exr") throw InputError("only .exr and .png tell which picture they hold");
  const ExrSource source(path);
  return {source.width(), source.height(), source.whole(), source.notes()};
}

std::string named(const std::string& part) { return part.empty() ? "the whole picture" : part; }

}  // namespace

std::string why_another(const std::string& path, const WholePicture& wanted, const std::string& part) {
  try {
    const Header header = read_header(path);
    if (header.notes.count("whole.size") == 0) return "it does not say which picture it is";
    const WholePicture there = read_whole_note(path, header.notes);
    const std::string differs = difference(there, wanted);
    if (!differs.empty()) return differs;
    if (!header.whole || header.notes.count("partial") != 0 || header.width != there.width || header.height != there.height) return "its pixels are not all there";
    const auto found = header.notes.find("part");
    const std::string there_part = found == header.notes.end() ? "" : found->second;
    return there_part == part ? "" : fmt::format("it is {}, not {}", named(there_part), named(part));
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace nicol
