// The camera moved by hand, and what can be saved: see panels.hpp.
#include <fmt/format.h>

#include <cmath>

#include "host/window/panels.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

constexpr double deg_per_rad = 57.29577951308232;

bool button(Ui& ui, const char* name, float width = -1) {
  const bool pressed = ImGui::Button(name, {width, 0});
  ui.mark(name);
  return pressed;
}

void figure(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(92);
  ImGui::TextUnformatted(value.c_str());
}

}  // namespace

void copy_camera(preview::Session& session, Surface& surface) {
  const std::string text = session.camera_sdl();
  if (text.empty()) return session.tell("no camera yet: nothing copied");
  surface.set_clipboard(text);
  session.tell("camera copied as text of the scene language");
}

void camera_tab(Ui& ui) {
  const preview::Navigation& n = ui.session.controls.navigation;
  figure("orbit", fmt::format("{:+.1f} deg, {:+.1f} deg", deg_per_rad * n.yaw_rad, deg_per_rad * n.pitch_rad));
  figure("pan", fmt::format("{:+.3f}, {:+.3f}", n.pan_right, n.pan_up));
  figure("zoom", fmt::format("{} times", short_number(std::exp2(n.zoom))));
  ImGui::Spacing();
  if (button(ui, "reset all")) ui.session.reset();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("camera, polarizers, effects, exposure, views as at the start");
  if (button(ui, "reset camera")) ui.session.controls.navigation = {};
  if (button(ui, "copy camera")) copy_camera(ui.session, ui.surface);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("camera { ... } for the scene file, to the clipboard (ctrl+c)");
  if (button(ui, "save camera")) ui.session.save_camera();
  ImGui::Spacing();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("Drag: orbit. Shift + drag, middle or right button: pan. Wheel: zoom towards the mouse.");
  ImGui::PopTextWrapPos();
}

void save_tab(Ui& ui) {
  const bool two = ui.session.two_renders();
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  ImGui::TextDisabled("Picture as shown (PNG)");
  if (button(ui, "left picture", half)) ui.session.save_picture(0);
  ImGui::SameLine();
  if (button(ui, "right picture", half)) ui.session.save_picture(1);
  ImGui::Spacing();
  ImGui::TextDisabled("Stokes spectra (EXR)");
  if (button(ui, "left spectra", two ? half : -1)) ui.session.save_spectra(0);
  if (two) {
    ImGui::SameLine();
    if (button(ui, "right spectra", half)) ui.session.save_spectra(1);
  }
  ImGui::Spacing();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("Saved is what has been traced so far, beside the scene. Where it went is told below.");
  ImGui::PopTextWrapPos();
}

}  // namespace nicol::window
