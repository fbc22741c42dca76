// The analyzer and the scene's polarizers turned by hand: see panels.hpp.
#include <cmath>

#include "host/window/panels.hpp"

namespace nicol::window {
namespace {

using preview::Analyzer;

double within_half_turn(double angle_deg) { return std::remainder(angle_deg, 360.0); }

// A slider and buttons for small and large steps.
void angle(Ui& ui, const char* name, double& angle_deg) {
  label(name);
  float shown = static_cast<float>(within_half_turn(angle_deg));
  const std::string id = std::string("##") + name;
  if (ImGui::SliderFloat(id.c_str(), &shown, -180, 180, "%.1f deg")) angle_deg = std::round(10 * shown) / 10;
  ui.mark(name);
  ImGui::SetCursorPosX(92);
  ImGui::PushID(name);
  for (const int step : {-15, -1, 1, 15}) {
    const std::string text = (step > 0 ? "+" : "") + std::to_string(step);
    if (ImGui::Button(text.c_str(), {38, 0})) angle_deg = within_half_turn(angle_deg + step);
    ui.mark(std::string(name) + " " + text);
    ImGui::SameLine(0, 4);
  }
  if (ImGui::Button("0", {28, 0})) angle_deg = 0;
  ui.mark(std::string(name) + " 0");
  ImGui::PopID();
}

void analyzer_kind(Ui& ui) {
  struct Choice {
    const char* name;
    const char* help;
    Analyzer analyzer;
  };
  Analyzer& chosen = ui.session.controls.analyzer;
  for (const Choice& choice :
       {Choice{"as scene", "the camera's polarizer as the scene has it", Analyzer::as_scene},
        Choice{"none", "the camera's polarizer taken away", Analyzer::none},
        Choice{"added", "an ideal one, where the camera has none", Analyzer::added}}) {
    if (ImGui::RadioButton(choice.name, chosen == choice.analyzer)) chosen = choice.analyzer;
    ui.mark(std::string("analyzer ") + choice.name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", choice.help);
    ImGui::SameLine(0, 10);
  }
  ImGui::NewLine();
}

}  // namespace

void polarizers_tab(Ui& ui) {
  preview::Controls& controls = ui.session.controls;
  ImGui::TextDisabled("Analyzer: the camera's polarizer");
  analyzer_kind(ui);
  ImGui::BeginDisabled(controls.analyzer == Analyzer::none);
  angle(ui, "analyzer", controls.analyzer_deg);
  ImGui::EndDisabled();
  ImGui::Checkbox("right pane: before the analyzer", &controls.before_analyzer);
  ui.mark("before analyzer");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("one scene: the right pane is a render of the light that arrives at the analyzer");
  ImGui::Separator();
  ImGui::TextDisabled("All other polarizers of the scene");
  angle(ui, "polarizer", controls.polarizer_deg);
  ImGui::Separator();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("Counter-clockwise, from where the scene has them: the analyzer as the picture shows it, a "
                      "polarizer as seen from the side that its normal points to.");
  ImGui::PopTextWrapPos();
}

}  // namespace nicol::window
