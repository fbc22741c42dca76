// The notes of a PNG: its text chunks before the pixels.
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>

#include "host/output/exr_source.hpp"
#include "host/output/picture_note.hpp"

namespace nicol {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

void on_error(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void on_warning(png_structp, png_const_charp) {}

// False if it is no PNG. Between setjmp and the end nothing with a destructor comes into being.
bool read_info(png_structp png, png_infop info, std::FILE* file) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_init_io(png, file);
  png_read_info(png, info);
  return true;
}

// What every whole PNG ends in.
bool has_end(std::FILE* file) {
  static constexpr char end[] = "\0\0\0\0IEND\xae\x42\x60\x82";
  char last[sizeof end - 1];
  return std::fseek(file, -static_cast<long>(sizeof last), SEEK_END) == 0 && std::fread(last, sizeof last, 1, file) == 1 &&
         std::memcmp(last, end, sizeof last) == 0;
}

}  // namespace

PngNotes read_png_notes(const std::string& path) {
  errno = 0;
  const File file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) cannot_read(path, std::strerror(errno));
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool readable = info && read_info(png, info, file.get());
  PngNotes read;
  if (readable) {
    read.width = static_cast<int>(png_get_image_width(png, info));
    read.height = static_cast<int>(png_get_image_height(png, info));
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i)
      if (texts[i].text) read.notes[texts[i].key] = texts[i].text;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (!readable || !has_end(file.get())) cannot_read(path, "it is no whole PNG");
  return read;
}

}  // namespace nicol
