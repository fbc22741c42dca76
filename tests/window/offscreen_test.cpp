// Drawn without a display: what stands in the framebuffer is what the numbers say.
#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <cmath>
#include <thread>

#include "host/optics/colour.hpp"
#include "host/window/picture_texture.hpp"
#include "host/window/surface.hpp"

using namespace nicol;
using namespace nicol::window;

namespace {

constexpr int width = 40, height = 30;

struct Pixels {
  std::vector<unsigned char> rgb;
  const unsigned char* at(int x, int y) const { return rgb.data() + 3 * ((height - 1 - y) * width + x); }
};

// Black, and the picture at its place.
Pixels drawn(const preview::Developed& developed, const PixelRect& place, const PixelRect& clip, double factor) {
  const auto surface = open_offscreen(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, surface->framebuffer());
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const PictureShader shader;
  PictureTexture texture;
  texture.take(developed, 1);
  texture.draw(shader, place, clip, height, factor);
  Pixels pixels;
  pixels.rgb.resize(std::size_t{3} * width * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.rgb.data());
  CHECK(glGetError() == GL_NO_ERROR);
  return pixels;
}

constexpr PixelRect everywhere{0, 0, width, height};

}  // namespace

TEST_CASE("levels are those of IEC 61966-2-1, with the factor, and clipped") {
  preview::Developed developed;
  developed.width = width;
  developed.height = height;
  for (int i = 0; i < width * height; ++i)
    for (const double part : {1.0, 0.1, -0.3}) developed.rgb.push_back(static_cast<float>(part * i / 1000.0));
  const double factor = 1.7;
  const Pixels pixels = drawn(developed, everywhere, everywhere, factor);
  double worst = 0;
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < 3; ++c) {
      const double wanted = 255 * srgb_encode(factor * developed.rgb[static_cast<std::size_t>(3 * i + c)]);
      worst = std::max(worst, std::abs(pixels.at(i % width, i / width)[c] - wanted));
    }
  CHECK(worst < 0.51);   // half a step, and float
}

TEST_CASE("magnified pixels stay squares, and nothing is drawn outside of the clip") {
  const preview::Developed developed{2, 1, {1, 0, 0, 0, 1, 0}, true};
  const Pixels pixels = drawn(developed, {10, 5, 20, 10}, {10, 5, 15, 10}, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = x >= 10 && x < 25 && y >= 5 && y < 15;
      CHECK(pixels.at(x, y)[0] == (inside && x < 20 ? 255 : 0));
      CHECK(pixels.at(x, y)[1] == (inside && x >= 20 ? 255 : 0));
    }
}

TEST_CASE("a picture too large is averaged in linear light") {
  preview::Developed developed;
  developed.width = 4 * width;
  developed.height = 4 * height;
  for (int y = 0; y < developed.height; ++y)
    for (int x = 0; x < developed.width; ++x) developed.rgb.insert(developed.rgb.end(), 3, (x + y) % 2 ? 1.0F : 0.0F);
  const Pixels pixels = drawn(developed, everywhere, everywhere, 1);
  CHECK(std::abs(pixels.at(20, 15)[1] - 255 * srgb_encode(0.5)) < 1);
}

TEST_CASE("places that touch in the window touch in the framebuffer, at any scale") {
  for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
    const PixelRect left = to_pixels({0, 0, 33.3, 10}, scale), right = to_pixels({33.3, 0, 20, 10}, scale);
    CHECK(left.x + left.width == right.x);
  }
}

TEST_CASE("waiting ends by a wake from another thread, and one before the wait is not lost") {
  const auto surface = open_offscreen(8, 8);
  surface->wake();
  surface->wait(std::nullopt);   // where a wake is lost, for ever: the test's limit ends it
  std::thread other([&] { surface->wake(); });
  surface->wait(std::nullopt);
  other.join();
  surface->wait(0.01);
  CHECK_FALSE(surface->has_events());
}

TEST_CASE("a surface without a display has the size that it is given") {
  const auto surface = open_offscreen(80, 60, 2);
  CHECK(surface->logical_width() == 40);
  surface->resize(100, 50);
  CHECK(surface->logical_height() == 25);
  CHECK(surface->next_event()->kind == Event::Kind::resize);
}
