// PNG as libpng reads it back, and the colours that it cannot show.
#include <doctest/doctest.h>
#include <png.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "host/optics/colour.hpp"
#include "tests/output/pattern.hpp"

using namespace nicol;

namespace {

struct Picture {
  png_uint_32 width = 0, height = 0;
  int depth = 0, colour_type = 0, intent = -1;
  std::vector<std::string> texts;  // "key=value"
  std::vector<png_byte> pixels;
};

Picture read_png(const std::string& path) {
  Picture picture;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  REQUIRE(file);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  picture.width = png_get_image_width(png, info);
  picture.height = png_get_image_height(png, info);
  picture.depth = png_get_bit_depth(png, info);
  picture.colour_type = png_get_color_type(png, info);
  png_get_sRGB(png, info, &picture.intent);
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(png, info, &texts, &count);
  for (int i = 0; i < count; ++i)
    picture.texts.push_back(std::string(texts[i].key) + "=" + texts[i].text);
  png_bytepp rows = png_get_rows(png, info);
  for (png_uint_32 y = 0; y < picture.height; ++y)
    picture.pixels.insert(picture.pixels.end(), rows[y], rows[y] + 3 * picture.width);
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(file);
  return picture;
}

}  // namespace

TEST_CASE("a PNG shows the colours of the picture, rows from the top") {
  const TemporaryFolder folder;
  const std::vector<float> rgb{1, 0, 0, /**/ 0,    1,    0,    /**/ 0, 0, 1,  //
                               0, 0, 0, /**/ 0.5f, 0.5f, 0.5f, /**/ 1, 1, 1};
  make_sink(folder.file("a.png"))->write(colour_frame(3, 2, rgb));
  const Picture picture = read_png(folder.file("a.png"));
  CHECK(picture.width == 3);
  CHECK(picture.height == 2);
  CHECK(picture.depth == 8);
  CHECK(picture.colour_type == PNG_COLOR_TYPE_RGB);
  CHECK(picture.intent == PNG_sRGB_INTENT_PERCEPTUAL);
  const std::vector<int> wanted{255, 0, 0, 0,   255, 0,   0,   0,   255,
                                0,   0, 0, 188, 188, 188, 255, 255, 255};
  REQUIRE(picture.pixels.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CAPTURE(i);
    CHECK(std::abs(picture.pixels[i] - wanted[i]) <= 1);
  }
}

TEST_CASE("a PNG says how it was made") {
  const TemporaryFolder folder;
  Frame frame = colour_frame(1, 2, std::vector<float>(6, 0.5f));
  frame.row_done = {0, 1};
  frame.how.emplace_back("error  budget ", "cut off 0.1 %");
  make_sink(folder.file("a.Png"))->write(frame);
  const std::vector<std::string> wanted{"scene=scenes/a b.pov",
                                        "device=Prozessor f\xC3\xBCr Versuche", "settings=width 7",
                                        "error_budget_=cut off 0.1 %", "partial=1 of 2 rows"};
  CHECK(read_png(folder.file("a.Png")).texts == wanted);
}

TEST_CASE("colours that a PNG cannot show are counted, not hidden") {
  const std::vector<float> rgb{1, 1, 1, 0, 0, 0, 1.1f, 0.5f, 0.5f, 0.5f, 0.5f, 1.2f};
  CHECK(clipped_pixels(colour_frame(4, 1, rgb)) == 2);
  CHECK(clipped_pixels(colour_frame(2, 1, {0.2f, 0.2f, 0.2f, 1, 0.9f, 0.8f})) == 0);
  Frame line =
      colour_frame(1, 1, {0, 0, 0});  // a spectral colour lies outside the triangle of sRGB
  line.component(0, 28)[0] = 1e-3f;
  CHECK(clipped_pixels(line) == 1);
  Frame broken = colour_frame(1, 1, {0.5f, 0.5f, 0.5f});
  broken.component(0, 40)[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(clipped_pixels(broken) == 1);
  const TemporaryFolder folder;
  make_sink(folder.file("a.png"))->write(broken);  // is written all the same
  CHECK(read_png(folder.file("a.png")).pixels == std::vector<png_byte>{0, 0, 0});
}
