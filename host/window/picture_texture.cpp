// See picture_texture.hpp.
#include "host/window/picture_texture.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/window/surface.hpp"

namespace nicol::window {
namespace {

constexpr const char* vertex_source = R"(#version 330 core
out vec2 at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  at = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)";

// The transfer curve of IEC 61966-2-1.
constexpr const char* fragment_source = R"(#version 330 core
uniform sampler2D picture;
uniform float factor;
in vec2 at;
out vec4 shown;
void main() {
  vec3 linear = clamp(factor * texture(picture, at).rgb, 0.0, 1.0);
  vec3 toe = 12.92 * linear;
  vec3 curve = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  shown = vec4(mix(curve, toe, vec3(lessThanEqual(linear, vec3(0.0031308)))), 1.0);
}
)";

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint built = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &built);
  if (built) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw WindowError("the window's shader does not build: " + log);
}

}  // namespace

PixelRect to_pixels(const preview::Rect& logical, double content_scale) {
  const auto round = [&](double v) { return static_cast<int>(std::lround(v * content_scale)); };
  const int left = round(logical.x), top = round(logical.y);
  return {left, top, round(logical.x + logical.width) - left, round(logical.y + logical.height) - top};
}

PictureShader::PictureShader() {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint linked = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (!linked) throw WindowError("the window's shaders do not link");
  glGenVertexArrays(1, &quad_);
}

PictureShader::~PictureShader() {
  glDeleteProgram(program_);
  glDeleteVertexArrays(1, &quad_);
}

PictureTexture::PictureTexture() { glGenTextures(1, &texture_); }
PictureTexture::~PictureTexture() { glDeleteTextures(1, &texture_); }

void PictureTexture::take(const preview::Developed& developed, std::uint64_t version) {
  if (taken_ && version_ == version) return;
  taken_ = true;
  version_ = version;
  has_mipmaps_ = false;
  const bool whole = developed.rgb.size() == std::size_t{3} * developed.width * developed.height;
  width_ = whole && developed.height > 0 ? developed.width : 0;
  height_ = developed.height;
  if (width_ <= 0) return;
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width_, height_, 0, GL_RGB, GL_FLOAT, developed.rgb.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void PictureTexture::draw(const PictureShader& shader, const PixelRect& wanted, const PixelRect& clip, int height,
                          double factor) {
  // Rounding of the layout must not resample a picture that fits.
  PixelRect place = wanted;
  if (std::abs(place.width - width_) <= 1 && std::abs(place.height - height_) <= 1) {
    place.width = width_;
    place.height = height_;
  }
  if (width_ <= 0 || place.width <= 0 || place.height <= 0 || clip.width <= 0 || clip.height <= 0) return;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  const bool minified = place.width < width_ || place.height < height_;
  if (minified && !has_mipmaps_) {
    glGenerateMipmap(GL_TEXTURE_2D);
    has_mipmaps_ = true;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minified ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  // Its place is the whole viewport; the scissors cut it to the pane.
  glViewport(place.x, height - place.y - place.height, place.width, place.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(clip.x, height - clip.y - clip.height, clip.width, clip.height);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glUseProgram(shader.program());
  glUniform1f(glGetUniformLocation(shader.program(), "factor"), static_cast<float>(factor));
  glUniform1i(glGetUniformLocation(shader.program(), "picture"), 0);
  glBindVertexArray(shader.quad());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace nicol::window
