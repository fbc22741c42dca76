// What the panes show: see panels.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/window/panels.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

using preview::Quantity;

void quantity_combo(Ui& ui, const char* name, preview::View& view) {
  label(name);
  const std::string id = std::string("##") + name;
  const bool open = ImGui::BeginCombo(id.c_str(), quantity_label(view.quantity).c_str(), ImGuiComboFlags_HeightLargest);
  ui.mark(name);
  if (!open) return;
  for (const Quantity quantity : preview::all_quantities()) {
    if (ImGui::Selectable(quantity_label(quantity).c_str(), quantity == view.quantity)) view.quantity = quantity;
    ui.mark(fmt::format("{}: {}", name, preview::name_of(quantity)));
  }
  ImGui::EndCombo();
}

void wavelength(Ui& ui) {
  const std::vector<double>& lambda_nm = ui.session.status(0).lambda_nm;
  auto& scrubbed = ui.session.controls.scrubbed;
  bool one = scrubbed.has_value();
  ImGui::BeginDisabled(lambda_nm.empty());
  if (ImGui::Checkbox("one wavelength", &one)) {
    if (one) scrubbed = lambda_nm.size() / 2;
    else scrubbed.reset();
  }
  ui.mark("one wavelength");
  ImGui::EndDisabled();
  ImGui::BeginDisabled(lambda_nm.size() < 2);
  label("wavelength");
  const int last = std::max(0, static_cast<int>(lambda_nm.size()) - 1);
  int index = std::min(last, static_cast<int>(scrubbed.value_or(lambda_nm.size() / 2)));
  const double at_nm = lambda_nm.empty() ? 0 : lambda_nm[static_cast<std::size_t>(index)];
  const std::string shown = lambda_nm.empty() ? "-" : fmt::format("{:.6g} nm", at_nm);
  if (ImGui::SliderInt("##wavelength", &index, 0, last, shown.c_str(), ImGuiSliderFlags_NoInput))
    scrubbed = static_cast<std::size_t>(index);
  ui.mark("wavelength");
  ImGui::EndDisabled();
}

void exposure(Ui& ui) {
  label("exposure");
  float stops = static_cast<float>(ui.session.controls.exposure_stops);
  if (ImGui::SliderFloat("##exposure", &stops, -10, 10, "%+.2f stops"))
    ui.session.controls.exposure_stops = std::round(20 * stops) / 20;
  ui.mark("exposure");
}

void difference_figures(Ui& ui) {
  const preview::Difference* difference = ui.session.difference();
  if (!difference) {
    ImGui::TextDisabled("only where two renders are compared");
    return;
  }
  if (!difference->comparable) {
    ImGui::TextDisabled("not comparable yet");
    return;
  }
  ImGui::TextUnformatted(fmt::format("RMS {} %   colours: dE2000 up to {}", short_number(100 * difference->rms),
                                     short_number(difference->delta_e_largest)).c_str());
  ImGui::TextUnformatted(fmt::format("largest {} % at pixel {}, {}", short_number(100 * difference->largest),
                                     difference->x, difference->y).c_str());
  if (ImGui::IsItemClicked()) ui.session.controls.pinned = std::array<int, 2>{difference->x, difference->y};
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("click: pins that pixel");
  ui.mark("largest difference");
}

void difference(Ui& ui) {
  preview::Controls& controls = ui.session.controls;
  ImGui::Checkbox("difference", &controls.show_difference);
  ui.mark("difference");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("the right pane shows |left - right|");
  ImGui::SameLine(160);
  ImGui::Checkbox("wipe", &controls.wipe);
  ui.mark("wipe");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("both panes fill the window; the divider cuts");
  if (!controls.show_difference) return;
  label("amplified");
  float factor = static_cast<float>(controls.amplification);
  if (ImGui::SliderFloat("##amplification", &factor, 1, 10000, "%.3g times", ImGuiSliderFlags_Logarithmic))
    controls.amplification = factor;
  ui.mark("amplification");
  difference_figures(ui);
}

}  // namespace

void view_tab(Ui& ui) {
  preview::Controls& controls = ui.session.controls;
  quantity_combo(ui, "left pane", controls.view[0]);
  quantity_combo(ui, "right pane", controls.view[1]);
  wavelength(ui);
  exposure(ui);
  difference(ui);
}

}  // namespace nicol::window
