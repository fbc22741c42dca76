// See ui.hpp.
#include "host/window/ui.hpp"

namespace nicol::window {

void Ui::mark(const std::string& name) const {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  widgets.emplace_back(name, preview::Rect{low.x, low.y, high.x - low.x, high.y - low.y});
}

preview::Rect visible_pane(const Ui& ui, int pane) {
  preview::Rect place = ui.layout.pane[static_cast<std::size_t>(pane)];
  if (!ui.session.controls.wipe) return place;
  const double middle = ui.layout.divider.x + ui.layout.divider.width / 2, end = place.x + place.width;
  if (pane == 1) place.x = middle;
  place.width = (pane == 1 ? end : middle) - place.x;
  return place;
}

bool begin_fixed(const char* name, const preview::Rect& place) {
  ImGui::SetNextWindowPos(corner(place));
  ImGui::SetNextWindowSize(vec(place.width, place.height));
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void label(const char* text) {
  constexpr float label_width = 92;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(label_width);
  ImGui::SetNextItemWidth(-1);
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string part = text;
  while (!part.empty() && ImGui::CalcTextSize((part + "...").c_str()).x > width) {
    while (part.size() > 1 && (static_cast<unsigned char>(part.back()) & 0xC0) == 0x80) part.pop_back();
    part.pop_back();
  }
  return part + "...";
}

}  // namespace nicol::window
