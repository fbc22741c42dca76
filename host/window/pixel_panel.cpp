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
void rows_of_three(const Fonts& fonts, const std::string& name, const char* letters, const Both& both, int columns,
                   Values&& values) {
  const auto all = [&](const PixelInfo& i) { return triple(values(i)); };
  if (columns == 1) return row(fonts, (name + letters).c_str(), both, 1, all);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string one = fmt::format("{}{}", name, letters[c]);
    row(fonts, one.c_str(), both, columns, [&](const PixelInfo& i) { return short_number(values(i)[c]); });
  }
}

// Below this degree there is no ellipse to speak of.
constexpr double least_degree = 1e-6;

// In [0, 180), as the false colours have it.
std::string azimuth_text(const PixelInfo& info) {
  const double deg = std::fmod(deg_per_rad * info.ellipse.azimuth_rad, 180.0);
  return info.ellipse.degree < least_degree ? "-" : fmt::format("{:.1f}", deg < 0 ? deg + 180 : deg);
}

std::string ellipticity_text(const PixelInfo& info) {
  const double deg = deg_per_rad * info.ellipse.ellipticity_rad;
  if (info.ellipse.degree < least_degree) return "-";
  return fmt::format("{:+.1f}{}", deg, std::abs(deg) < 0.05 ? "" : deg > 0 ? " right" : " left");
}

void figures(const Fonts& fonts, const Both& both, int columns) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4, 0.5F});
  const bool open = ImGui::BeginTable("figures", 1 + columns, ImGuiTableFlags_SizingStretchSame);
  ImGui::PopStyleVar();
  if (!open) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 108);
  for (int i = 0; i < columns; ++i) ImGui::TableSetupColumn(i == 0 ? "first" : "second");
  row(fonts, "azimuth (deg)", both, columns, azimuth_text);
  row(fonts, "ellipticity (deg)", both, columns, ellipticity_text);
  row(fonts, "degree", both, columns,
      [](const PixelInfo& i) { return fmt::format("{:.2f} %", 100 * i.ellipse.degree); });
  rows_of_three(fonts, "", "XYZ", both, columns, [](const PixelInfo& i) { return i.xyz; });
  rows_of_three(fonts, "linear ", "RGB", both, columns, [](const PixelInfo& i) { return i.rgb; });
  row(fonts, "sRGB 8 bit", both, columns, [](const PixelInfo& i) { return fmt::format("{}", fmt::join(i.srgb, " ")); });
  row(fonts, "samples", both, columns, [](const PixelInfo& i) {
    return i.block > 1 ? fmt::format("block {0}x{0}", i.block) : fmt::format("{}", i.samples);
  });
  row(fonts, "cut-off weight", both, columns, [](const PixelInfo& i) { return short_number(i.cut_off); });
  row(fonts, "bound (per nm)", both, columns, [](const PixelInfo& i) { return short_number(i.cut_off_radiance); });
  ImGui::EndTable();
}

// Ellipses in their circles of full polarization, beside them the colours.
void shapes(const Both& both, int columns) {
  constexpr float radius = 33;
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
    const ImVec2 swatch{middle.x + radius + 12, at.y + 2};
    const ImVec2 end{at.x + share * static_cast<float>(i + 1) - 6, at.y + 2 * radius + 2};
    list.AddRectFilled(swatch, end, IM_COL32(info->srgb[0], info->srgb[1], info->srgb[2], 255));
    list.AddRect(swatch, end, colours::faint);
  }
  ImGui::Dummy({0, 2 * radius + 4});
}

// A name, and text that is wrapped beside it.
void told(const char* name, const std::string& text) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(84);
  ImGui::TextUnformatted(text.c_str());
}

void path(Ui& ui) {
  const auto met = ui.session.pixel_path(ui.pixel->pane, ui.pixel->x, ui.pixel->y);
  ImGui::Separator();
  if (!met) {
    ImGui::TextDisabled("What its light met: ...");
    return;
  }
  ImGui::PushTextWrapPos();
  const std::string effects = fmt::format("{}", fmt::join(met->effects, ", "));
  told("effects met", effects.empty() ? "none" : effects);
  for (std::size_t i = 0; i < met->cells.size(); ++i) told(i == 0 ? "cells met" : "", met->cells[i]);
  told("ends at", met->ends.empty() ? "nothing" : met->ends);
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
  spectrum_plot(ui.fonts, {ImGui::GetContentRegionAvail().x, 134}, *both[own], two ? both[1 - own] : nullptr);
  if (!two) both[0] = both[own];
  shapes(both, two ? 2 : 1);
  figures(ui.fonts, both, two ? 2 : 1);
  path(ui);
}

}  // namespace nicol::window
