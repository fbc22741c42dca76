// PNG of 8 bit per channel in sRGB. Colours outside the gamut are clipped: clipped_pixels() counts
// them.
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>

#include "host/optics/colour.hpp"
#include "host/output/atomic_file.hpp"
#include "host/output/sinks.hpp"

namespace nicol {
namespace {

using Notes = std::vector<std::pair<std::string, std::string>>;

std::vector<png_byte> encode(const std::vector<float>& rgb) {
  std::vector<png_byte> pixels(rgb.size());
  std::transform(rgb.begin(), rgb.end(), pixels.begin(), [](float value) {
    const double linear = std::isnan(value) ? 0 : static_cast<double>(value);
    return static_cast<png_byte>(std::lround(255 * srgb_encode(linear)));
  });
  return pixels;
}

// A keyword of PNG: 1 to 79 printable characters without outer or double spaces.
std::string keyword(const std::string& key) {
  std::string word;
  for (const char c : key) {
    const bool printable = c > ' ' && c <= '~';
    if (printable)
      word += c;
    else if (!word.empty() && word.back() != '_')
      word += '_';
  }
  return word.empty() ? "note" : word.substr(0, 79);
}

std::vector<png_text> text_chunks(const Notes& keywords_and_values) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : keywords_and_values) {
    const bool ascii =
        std::all_of(value.begin(), value.end(), [](char c) { return (c & 0x80) == 0; });
    png_text chunk{};
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    (ascii ? chunk.text_length : chunk.itxt_length) = value.size();
    chunk.lang = const_cast<char*>("");
    chunk.lang_key = const_cast<char*>("");
    chunks.push_back(chunk);
  }
  return chunks;
}

struct Encoding {
  std::vector<char> bytes;
  std::string problem;
};

Encoding& encoding_of(png_voidp pointer) { return *static_cast<Encoding*>(pointer); }

void on_error(png_structp png, png_const_charp message) {
  encoding_of(png_get_error_ptr(png)).problem = message;
  png_longjmp(png, 1);
}

void on_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto& encoded = encoding_of(png_get_io_ptr(png)).bytes;
  encoded.insert(encoded.end(), bytes, bytes + count);
}

// Between setjmp and the end nothing with a destructor comes into being.
void fill(png_structp png, png_infop info, const Frame& frame, const std::vector<png_byte>& pixels,
          const std::vector<png_text>& texts) {
  if (setjmp(png_jmpbuf(png))) return;
  const auto width = static_cast<png_uint_32>(frame.width),
             height = static_cast<png_uint_32>(frame.height);
  png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 3);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, info);
  for (png_uint_32 y = 0; y < height; ++y)
    png_write_row(png, pixels.data() + std::size_t{3} * width * y);
  png_write_end(png, info);
}

Encoding encode_png(const Frame& frame) {
  const auto pixels = encode(linear_rgb(frame));
  Notes notes = notes_of(frame);
  for (auto& note : notes) note.first = keyword(note.first);
  const auto texts = text_chunks(notes);
  Encoding encoding;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoding, on_error, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (info) {
    png_set_write_fn(png, &encoding, on_bytes, nullptr);
    fill(png, info, frame, pixels, texts);
  } else {
    encoding.problem = "libpng could not start";
  }
  png_destroy_write_struct(&png, &info);
  return encoding;
}

class PngSink : public FrameSink {
 public:
  explicit PngSink(std::string path) : path_(std::move(path)) {}

  void write(const Frame& frame) override {
    check_frame(frame, path_);
    const Encoding encoding = encode_png(frame);
    if (!encoding.problem.empty()) cannot_write(path_, encoding.problem);
    AtomicFile file(path_);
    file.write(encoding.bytes.data(), encoding.bytes.size());
    file.commit();
  }

 private:
  std::string path_;
};

}  // namespace

std::unique_ptr<FrameSink> make_png_sink(const std::string& path) {
  return std::make_unique<PngSink>(path);
}

}  // namespace nicol
