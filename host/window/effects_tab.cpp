// Effects left out, to see what each is worth: see panels.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "host/window/panels.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

constexpr std::size_t most_rows = 8;   // before they scroll

// What a sample costs beside the same with all effects.
void cost(const char* name, const preview::PaneStatus& status) {
  if (status.pass_seconds <= 0) return;
  std::string text = fmt::format("{}: {} s per sample", name, short_number(status.pass_seconds));
  if (status.all_effects_pass_seconds > 0)
    text += fmt::format(", {:.0f} % of all effects'", 100 * status.pass_seconds / status.all_effects_pass_seconds);
  ImGui::TextDisabled("%s", text.c_str());
}

// A checkbox: on when the effect is not left out.
void effect_box(Ui& ui, const std::string& name, const std::string& shown, bool on, int number, bool right_only) {
  if (ImGui::Checkbox(shown.c_str(), &on)) ui.session.turn_effect(number, right_only);
  ui.mark(name);
}

void effect_row(Ui& ui, const Effect& effect, int number) {
  const preview::Controls& controls = ui.session.controls;
  const bool out = controls.without.count(effect.name) > 0, out_right = controls.without_right.count(effect.name) > 0;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  if (number < 10) ImGui::TextDisabled("%d", number);
  ImGui::TableNextColumn();
  effect_box(ui, effect.name, effect.name, !out, number, false);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("left out: %s", effect.without.c_str());
  ImGui::TableNextColumn();
  effect_box(ui, effect.name + " right", "##" + effect.name, !out && !out_right, number, true);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("in the right pane only; left out: %s", effect.without.c_str());
}

}  // namespace

void effects_tab(Ui& ui) {
  const preview::PaneStatus& status = ui.session.status(0);
  if (status.effects.empty()) {
    ImGui::TextDisabled("The scene has no effect to leave out.");
    return;
  }
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  const float row = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const std::size_t shown = std::min(status.effects.size(), most_rows);
  const float rows = ImGui::GetTextLineHeight() + 8 + row * static_cast<float>(shown);
  if (ImGui::BeginTable("effects", 3, flags, {0, rows})) {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 24);
    ImGui::TableSetupColumn("both panes", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("right", ImGuiTableColumnFlags_WidthFixed, 40);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < status.effects.size(); ++i) effect_row(ui, status.effects[i], static_cast<int>(i) + 1);
    ImGui::EndTable();
  }
  cost("left", status);
  if (ui.session.two_renders()) cost("right", ui.session.status(1));
}

}  // namespace nicol::window
