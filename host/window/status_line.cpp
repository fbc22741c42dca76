// The line at the bottom, and the help over everything: see panels.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/window/panels.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

void key_row(const Ui& ui, const std::string& key, const std::string& help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(ui.fonts.mono);
  ImGui::TextUnformatted(key.c_str());
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", help.c_str());
}

struct Gesture {
  const char* what;
  const char* help;
};
constexpr std::array<Gesture, 10> gestures = {{
    {"1 to 9", "leaves out an effect of that number, or takes it back"},
    {"shift + 1 to 9", "the same in the right pane only"},
    {"drag", "orbits around the middle of the solids"},
    {"shift + drag", "pans; so do the middle and the right button"},
    {"wheel", "zooms towards the mouse"},
    {"click", "pins the pixel: its values stay; once more lets go"},
    {"divider", "drag: shares the window between the panes, or cuts"},
    {"ctrl + click", "on a slider: type the value"},
    {"ctrl+c", "copies the camera as text of the scene language"},
    {"escape, q", "closes the help, then the window"}}};

void keys_table(Ui& ui, const char* name, std::size_t first, std::size_t end) {
  if (!ImGui::BeginTable(name, 2)) return;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 112);
  ImGui::TableSetupColumn("help");
  const auto& actions = preview::actions();
  for (std::size_t i = first; i < end; ++i) {
    if (i < actions.size()) key_row(ui, actions[i].key, actions[i].help);
    else key_row(ui, gestures[i - actions.size()].what, gestures[i - actions.size()].help);
  }
  ImGui::EndTable();
}

// Beside each other; whole under the mouse. The device once, where both have the same.
void pane_statuses(const Ui& ui, float width) {
  const int panes = ui.session.two_renders() ? 2 : 1;
  const float share = width / static_cast<float>(panes);
  const preview::PaneStatus &left = ui.session.status(0), &right = ui.session.status(1);
  const bool same_device = left.device == right.device && left.real == right.real;
  for (int pane = 0; pane < panes; ++pane) {
    if (pane == 1) ImGui::SameLine(8 + share);
    const std::string text = status_text(ui.session.status(pane), pane == 0 || !same_device);
    ImGui::TextDisabled("%s", shortened(text, share - 12).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
  }
}

}  // namespace

void status_line(Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 3});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  if (begin_fixed("status", ui.layout.status)) {
    const float width = static_cast<float>(ui.layout.status.width) - 16;
    const std::string notice = ui.session.notice();
    if (!notice.empty()) {
      ImGui::TextUnformatted(shortened(notice, width).c_str());
    } else {
      pane_statuses(ui, width);
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void help_overlay(Ui& ui) {
  if (!ui.session.controls.show_help) return;
  const double across = ui.surface.logical_width(), down = ui.surface.logical_height();
  const double width = std::min(across - 40, 940.0), height = std::min(down - 40, 620.0);
  const preview::Rect place{(across - width) / 2, (down - height) / 2, width, height};
  ImGui::SetNextWindowPos(corner(place));
  ImGui::SetNextWindowSize(vec(place.width, place.height));
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("Keys and mouse", &ui.session.controls.show_help,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  const std::size_t all = preview::actions().size() + gestures.size(), half = (all + 1) / 2;
  if (ImGui::BeginTable("halves", 2)) {
    ImGui::TableNextColumn();
    keys_table(ui, "first keys", 0, half);
    ImGui::TableNextColumn();
    keys_table(ui, "further keys", half, all);
    ImGui::EndTable();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace nicol::window
