// All that is known of the pixel under the mouse, or of the pinned one: see panels.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/window/panels.hpp"
#include "host/window/spectrum_plot.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

using preview::PixelInfo;
using Both = std::array<const PixelInfo*, 2>;   // of the left and the right pane; null: nothing there

constexpr double deg_per_rad = 57.29577951308232;

std::string triple(const std::array<double, 3>& v) {
  return fmt::format("{} {} {}", short_number(v[0]), short_number(v[1]), short_number(v[2]));
}

// A row of the table: a name, and the text for each pane.
template <class Text>
void row(const Fonts& fonts, const char* name, const Both& both, int columns, Text&& text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  ImGui::PushFont(fonts.mono);
  for (int i = 0; i < columns; ++i) {
    ImGui::TableNextColumn();
    const PixelInfo* info = both[static_cast<std::size_t>(i)];
    ImGui::TextUnformatted(info ? std::string(text(*info)).c_str() : "-");
  }
  ImGui::PopFont();
}

// Three numbers: one row for one pane, three for two.
template <class Values>
void rows_of_three(const Fonts& fonts, const char* name, const char* letters, const Both& both, int columns, Values&& values) {
  if (columns == 1) return row(fonts, name, both, 1, [&](const PixelInfo& i) { return triple(values(i)); });
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string one = fmt::format("{} {}", name, letters[c]);
    row(fonts, one.c_str(), both, columns, [&](const PixelInfo& i) { return short_number(values(i)[c]); });
  }
}

std::string handedness(const PixelInfo& info) {
  const double chi_deg = deg_per_rad * info.ellipse.ellipticity_rad;
  if (std::abs(chi_deg) < 0.05) return "";
  return chi_deg > 0 ? " right" : " left";
}

std::string hex(const std::array<int, 3>& srgb) { return fmt::format("#{:02x}{:02x}{:02x}", srgb[0], srgb[1], srgb[2]); }

void figures(const Fonts& fonts, const Both& both, int columns) {
  if (!ImGui::BeginTable("figures", 1 + columns, ImGuiTableFlags_SizingStretchSame)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 84);
  for (int i = 0; i < columns; ++i) ImGui::TableSetupColumn(i == 0 ? "first" : "second");
  row(fonts, "azimuth", both, columns, [](const PixelInfo& i) { return fmt::format("{:.2f} deg", deg_per_rad * i.ellipse.azimuth_rad); });
  row(fonts, "ellipticity", both, columns, [](const PixelInfo& i) {
    return fmt::format("{:+.2f} deg{}", deg_per_rad * i.ellipse.ellipticity_rad, handedness(i));
  });
  row(fonts, "degree", both, columns, [](const PixelInfo& i) { return fmt::format("{:.2f} %", 100 * i.ellipse.degree); });
  rows_of_three(fonts, "XYZ", "XYZ", both, columns, [](const PixelInfo& i) { return i.xyz; });
  rows_of_three(fonts, "linear RGB", "RGB", both, columns, [](const PixelInfo& i) { return i.rgb; });
  row(fonts, "sRGB 8 bit", both, columns, [](const PixelInfo& i) { return fmt::format("{} {} {}", i.srgb[0], i.srgb[1], i.srgb[2]); });
  row(fonts, "", both, columns, [](const PixelInfo& i) { return hex(i.srgb); });
  row(fonts, "samples", both, columns, [](const PixelInfo& i) {
    return i.block > 1 ? fmt::format("block {0}x{0}", i.block) : fmt::format("{}", i.samples);
  });
  row(fonts, "cut off", both, columns, [](const PixelInfo& i) { return fmt::format("weight {}", short_number(i.cut_off)); });
  row(fonts, "at most", both, columns, [](const PixelInfo& i) { return fmt::format("{} per nm", short_number(i.cut_off_radiance)); });
  ImGui::EndTable();
}

// Ellipses in their circles of full polarization, beside them the colours.
void shapes(const Both& both, int columns) {
  constexpr float radius = 38;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float share = ImGui::GetContentRegionAvail().x / static_cast<float>(columns);
  for (int i = 0; i < columns; ++i) {
    const PixelInfo* info = both[static_cast<std::size_t>(i)];
    if (!info) continue;
    const ImVec2 middle{at.x + share * static_cast<float>(i) + radius + 2, at.y + radius + 2};
    list.AddCircle(middle, radius, colours::faint, 64);
    list.AddLine({middle.x - radius, middle.y}, {middle.x + radius, middle.y}, IM_COL32(255, 255, 255, 24));
    list.AddLine({middle.x, middle.y - radius}, {middle.x, middle.y + radius}, IM_COL32(255, 255, 255, 24));
    draw_ellipse(list, middle, radius, info->ellipse, true, 1.6F);
    const ImVec2 swatch{middle.x + radius + 12, at.y + 2}, end{at.x + share * static_cast<float>(i + 1) - 6, at.y + 2 * radius + 2};
    list.AddRectFilled(swatch, end, IM_COL32(info->srgb[0], info->srgb[1], info->srgb[2], 255));
    list.AddRect(swatch, end, colours::faint);
  }
  ImGui::Dummy({0, 2 * radius + 4});
}

void path(Ui& ui) {
  const auto met = ui.session.pixel_path(ui.pixel->pane, ui.pixel->x, ui.pixel->y);
  ImGui::Separator();
  if (!met) {
    ImGui::TextDisabled("What its light met: ...");
    return;
  }
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("effects met");
  ImGui::TextUnformatted(met->effects.empty() ? "none" : fmt::format("{}", fmt::join(met->effects, ", ")).c_str());
  ImGui::TextDisabled("cells met");
  for (const std::string& cell : met->cells) ImGui::TextUnformatted(cell.c_str());
  if (met->cells.empty()) ImGui::TextUnformatted("none");
  ImGui::TextDisabled("ends at");
  ImGui::TextUnformatted(met->ends.empty() ? "nothing" : met->ends.c_str());
  ImGui::PopTextWrapPos();
}

void heading(Ui& ui, bool two) {
  const bool pinned = ui.session.controls.pinned.has_value();
  const char* pane = ui.pixel->pane == 0 ? "left" : "right";
  ImGui::Text("Pixel %d, %d", ui.pixel->x, ui.pixel->y);
  ImGui::SameLine();
  if (two) ImGui::TextDisabled("solid: %s, dashed: %s", pane, ui.pixel->pane == 0 ? "right" : "left");
  else ImGui::TextDisabled("%s pane", pane);
  if (!pinned) return;
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - 44);
  if (ImGui::SmallButton("unpin")) ui.session.controls.pinned.reset();
  ui.mark("unpin");
}

}  // namespace

void pixel_panel(Ui& ui) {
  if (!ui.pixel) {
    ImGui::TextDisabled("Pixel: point at a picture; a click pins it.");
    return;
  }
  const bool two = ui.session.two_renders();
  heading(ui, two);
  std::array<std::optional<PixelInfo>, 2> info;
  const std::size_t own = static_cast<std::size_t>(ui.pixel->pane);
  for (std::size_t pane = 0; pane < 2; ++pane)
    if (two || pane == own) info[pane] = ui.session.pixel(static_cast<int>(pane), ui.pixel->x, ui.pixel->y);
  if (!info[own]) {
    ImGui::TextDisabled("Nothing traced there yet.");
    return;
  }
  Both both{info[0] ? &*info[0] : nullptr, info[1] ? &*info[1] : nullptr};
  spectrum_plot(ui.fonts, {ImGui::GetContentRegionAvail().x, 150}, *both[own], two ? both[1 - own] : nullptr);
  if (!two) both[0] = both[own];
  shapes(both, two ? 2 : 1);
  figures(ui.fonts, both, two ? 2 : 1);
  path(ui);
}

}  // namespace nicol::window
