// A picture of a pane on the graphics card, drawn with its exposure as sRGB.
#pragma once
#include <cstdint>

#include "host/preview/layout.hpp"
#include "host/preview/view.hpp"

namespace nicol::window {

// Framebuffer pixels from the left, from the top.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};
PixelRect to_pixels(const preview::Rect& logical, double content_scale);

// Needs a current OpenGL 3.3 context from its making to its end. Throws WindowError where the shaders do not build.
class PictureShader {
 public:
  PictureShader();
  ~PictureShader();
  PictureShader(const PictureShader&) = delete;
  PictureShader& operator=(const PictureShader&) = delete;
  unsigned program() const { return program_; }
  unsigned quad() const { return quad_; }

 private:
  unsigned program_ = 0, quad_ = 0;
};

class PictureTexture {
 public:
  PictureTexture();
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  // Uploads it, unless that version is there already. Linear sRGB, rows from the top; an empty one draws nothing.
  void take(const preview::Developed& developed, std::uint64_t version);

  // Into the framebuffer that is bound, of `height` rows: shows srgb(factor * rgb) (IEC 61966-2-1), cut at `clip`.
  // Pixels stay squares when magnified, and are averaged in linear light when there are more than fit.
  void draw(const PictureShader& shader, const PixelRect& place, const PixelRect& clip, int height, double factor);

 private:
  unsigned texture_ = 0;
  int width_ = 0, height_ = 0;
  bool taken_ = false, has_mipmaps_ = false;
  std::uint64_t version_ = 0;
};

}  // namespace nicol::window
