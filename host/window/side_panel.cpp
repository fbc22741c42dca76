// The panel at the right: see panels.hpp.
#include <algorithm>

#include "host/window/panels.hpp"

namespace nicol::window {
namespace {

constexpr float least_pixel_height = 220;

struct Tab {
  const char* name;
  void (*content)(Ui&);
};

void tab_bar(Ui& ui) {
  if (!ImGui::BeginTabBar("tabs")) return;
  for (const Tab& tab : {Tab{"View", view_tab}, Tab{"Polarizers", polarizers_tab}, Tab{"Effects", effects_tab},
                         Tab{"Camera", camera_tab}, Tab{"Save", save_tab}}) {
    const bool open = ImGui::BeginTabItem(tab.name);
    ui.mark(tab.name);
    if (!open) continue;
    tab.content(ui);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

}  // namespace

void side_panel(Ui& ui) {
  if (ui.layout.panel.width <= 0) return;
  if (begin_fixed("panel", ui.layout.panel)) {
    // One above the other: the tab as high as it was in the last frame, but where that leaves too little for the pixel.
    const float height = static_cast<float>(ui.layout.panel.height);
    float& needed = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("tab height"), 240);
    ImGui::BeginChild("tab", {0, std::min(needed, std::max(height / 3, height - least_pixel_height))});
    tab_bar(ui);
    needed = ImGui::GetCursorPosY();
    ImGui::EndChild();
    ImGui::Separator();
    ImGui::BeginChild("pixel");
    pixel_panel(ui);
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace nicol::window
