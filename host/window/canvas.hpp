// What a frame is drawn with: ImGui's context on a surface, the pictures' textures.
#pragma once
#include <imgui.h>

#include <array>

#include "host/preview/session.hpp"
#include "host/window/picture_texture.hpp"
#include "host/window/ui.hpp"
#include "host/window/window.hpp"

namespace nicol::window {

// ImGui on the surface's OpenGL. Throws WindowError.
class ImguiContext {
 public:
  explicit ImguiContext(Surface& surface);
  ~ImguiContext();
  ImguiContext(const ImguiContext&) = delete;
  ImguiContext& operator=(const ImguiContext&) = delete;

  void begin_frame();                    // by the surface's size, scale and the time that has passed
  const Fonts& fonts() const { return fonts_; }

 private:
  Surface& surface_;
  ImGuiContext* context_ = nullptr;
  Fonts fonts_;
  double font_scale_ = 0, last_seconds_ = 0;
};

// Draws pictures, and over them what ImGui::Render() has left.
class Canvas {
 public:
  Canvas(preview::Session& session, Surface& surface) : session_(session), surface_(surface) {}
  void draw(const Ui& ui);
  Screenshot screenshot(const Ui& ui);

 private:
  void draw_to(unsigned framebuffer, const Ui& ui);
  void draw_picture(const Ui& ui, int pane, int height);

  preview::Session& session_;
  Surface& surface_;
  PictureShader shader_;
  std::array<PictureTexture, 2> textures_;
};

}  // namespace nicol::window
