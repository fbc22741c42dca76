// See canvas.hpp.
#include "host/window/canvas.hpp"

#include <epoxy/gl.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <chrono>

namespace nicol::window {
namespace {

double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ImguiContext::ImguiContext(Surface& surface) : surface_(surface), last_seconds_(now_seconds()) {
  surface_.make_current();
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.MousePos = {-1, -1};
  set_style();
  if (ImGui_ImplOpenGL3_Init("#version 330 core")) return;
  ImGui::DestroyContext(context_);
  throw WindowError("no window: OpenGL 3.3 is not to be had; libgl1 and libgl1-mesa-dri (Debian's names) give it");
}

ImguiContext::~ImguiContext() {
  surface_.make_current();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void ImguiContext::begin_frame() {
  ImGuiIO& io = ImGui::GetIO();
  const double scale = surface_.content_scale(), seconds = now_seconds();
  if (scale != font_scale_) {
    font_scale_ = scale;
    fonts_ = load_fonts(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  io.DisplaySize = vec(surface_.logical_width(), surface_.logical_height());
  io.DisplayFramebufferScale = vec(scale, scale);
  io.DeltaTime = static_cast<float>(std::clamp(seconds - last_seconds_, 1e-4, 0.5));
  last_seconds_ = seconds;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Canvas::draw_picture(const Ui& ui, int pane, int height) {
  const double scale = surface_.content_scale();
  const preview::Developed& developed = session_.developed(pane);
  PictureTexture& texture = textures_[static_cast<std::size_t>(pane)];
  texture.take(developed, session_.developed_version(pane));
  texture.draw(shader_, to_pixels(ui.layout.picture[static_cast<std::size_t>(pane)], scale),
               to_pixels(visible_pane(ui, pane), scale), height, session_.display_factor(pane));
}

void Canvas::draw_to(unsigned framebuffer, const Ui& ui) {
  int width = 0, height = 0;
  surface_.framebuffer_size(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  const ImVec4 grey = ImGui::ColorConvertU32ToFloat4(colours::surroundings);
  glClearColor(grey.x, grey.y, grey.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  for (int pane = 0; pane < 2; ++pane) draw_picture(ui, pane, height);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Canvas::draw(const Ui& ui) {
  draw_to(surface_.framebuffer(), ui);
  surface_.swap();
}

Screenshot Canvas::screenshot(const Ui& ui) {
  Screenshot shot;
  surface_.framebuffer_size(shot.width, shot.height);
  GLuint framebuffer = 0, colour = 0;
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(1, &colour);
  glBindRenderbuffer(GL_RENDERBUFFER, colour);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, shot.width, shot.height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
  draw_to(framebuffer, ui);
  const std::size_t row = std::size_t{3} * shot.width;
  shot.rgb.resize(row * shot.height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  // OpenGL's rows begin at the bottom.
  for (int y = 0; y < shot.height; ++y)
    glReadPixels(0, shot.height - 1 - y, shot.width, 1, GL_RGB, GL_UNSIGNED_BYTE, shot.rgb.data() + row * y);
  glBindFramebuffer(GL_FRAMEBUFFER, surface_.framebuffer());
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteRenderbuffers(1, &colour);
  return shot;
}

}  // namespace nicol::window
