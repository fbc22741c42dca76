// Spectra drawn by hand: axes, lines, what the mouse is over. See spectrum_plot.hpp.
#include "host/window/spectrum_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

using preview::PixelInfo;

constexpr const char* stokes_names[4] = {"S0", "S1", "S2", "S3"};

// Data to the screen, and back.
struct Axes {
  ImVec2 low, high;              // corners of the plot on the screen: left top, right bottom
  double from = 0, to = 1;       // nm, or bars
  double least = 0, most = 1;    // radiance
  float x(double v) const { return low.x + (high.x - low.x) * static_cast<float>((v - from) / (to - from)); }
  float y(double v) const { return high.y - (high.y - low.y) * static_cast<float>((v - least) / (most - least)); }
};

void widen(Axes& axes, const PixelInfo& info) {
  for (const std::vector<double>& component : info.stokes)
    for (const double value : component) {
      if (!std::isfinite(value)) continue;
      axes.least = std::min(axes.least, value);
      axes.most = std::max(axes.most, value);
    }
}

Axes axes_of(const Fonts& fonts, ImVec2 at, ImVec2 size, const PixelInfo& shown, const PixelInfo* other) {
  Axes axes;
  axes.least = axes.most = 0;
  widen(axes, shown);
  if (other) widen(axes, *other);
  if (!(axes.most > axes.least)) axes.most = axes.least + 1;
  const double margin = 0.05 * (axes.most - axes.least);
  axes.most += margin;
  if (axes.least < 0) axes.least -= margin;
  const float line = ImGui::GetTextLineHeight();
  const float number = fonts.mono->CalcTextSizeA(ImGui::GetFontSize() * 0.86F, 1e4F, 0, "-0.0000").x;
  axes.low = {at.x + number + 6, at.y + line + 4};
  axes.high = {at.x + size.x - 14, at.y + size.y - line - 2};
  axes.from = shown.lambda_nm.front();
  axes.to = shown.lambda_nm.back();
  if (!(axes.to > axes.from)) axes.from = 0, axes.to = 4;
  return axes;
}

void number_at(ImDrawList& list, const Fonts& fonts, ImVec2 at, float align, ImU32 colour, const std::string& text) {
  const float height = ImGui::GetFontSize() * 0.86F;
  const float width = fonts.mono->CalcTextSizeA(height, 1e4F, 0, text.c_str()).x;
  list.AddText(fonts.mono, height, {std::floor(at.x - align * width), std::floor(at.y)}, colour, text.c_str());
}

void draw_axes(ImDrawList& list, const Fonts& fonts, const Axes& axes, bool in_nm) {
  const float line = ImGui::GetTextLineHeight();
  const ImU32 grid = IM_COL32(255, 255, 255, 22);
  for (const double v : ticks(axes.least, axes.most, 6)) {
    const float y = axes.y(v);
    const bool zero = std::abs(v) < 1e-9 * (axes.most - axes.least);
    list.AddLine({axes.low.x, y}, {axes.high.x, y}, zero ? colours::faint : grid);
    number_at(list, fonts, {axes.low.x - 5, y - line / 2 + 1}, 1, colours::dim, fmt::format("{:g}", zero ? 0 : v));
  }
  if (in_nm)
    for (const double v : ticks(axes.from, axes.to, 5)) {
      const float x = axes.x(v);
      list.AddLine({x, axes.low.y}, {x, axes.high.y}, grid);
      number_at(list, fonts, {x, axes.high.y + 2}, 0.5F, colours::dim, fmt::format("{:g}", v));
    }
  list.AddRect(axes.low, axes.high, colours::faint);
}

void solid(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour) {
  list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.6F);
}

// Dashes of 4 with gaps of 3, whatever the points' distances.
void dashed(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour) {
  constexpr float dash = 4, period = 7;
  float along = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = points[i - 1], b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](float s) { return ImVec2(a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length); };
    for (float s = 0; s < length;) {
      const float phase = std::fmod(along + s, period), rest = (phase < dash ? dash : period) - phase;
      const float end = std::min(length, s + std::max(rest, 0.05F));
      if (phase < dash) list.AddLine(at(s), at(end), colour, 1);
      s = end;
    }
    along += length;
  }
}

void draw_lines(ImDrawList& list, const Axes& axes, const PixelInfo& info, bool thin) {
  for (const int s : {3, 2, 1, 0}) {
    std::vector<ImVec2> points;
    const std::vector<double>& values = info.stokes[static_cast<std::size_t>(s)];
    for (std::size_t i = 0; i < std::min(values.size(), info.lambda_nm.size()); ++i)
      if (std::isfinite(values[i])) points.emplace_back(axes.x(info.lambda_nm[i]), axes.y(values[i]));
    if (thin) dashed(list, points, (colours::stokes[s] & 0x00FFFFFFU) | (190U << 24));
    else solid(list, points, colours::stokes[s]);
  }
}

void draw_bars(ImDrawList& list, const Axes& axes, const PixelInfo& info, bool thin) {
  for (int s = 0; s < 4; ++s) {
    if (info.stokes[static_cast<std::size_t>(s)].empty()) continue;
    const double value = info.stokes[static_cast<std::size_t>(s)].front();
    if (!std::isfinite(value)) continue;
    const float left = axes.x(s + 0.2), right = axes.x(s + 0.8), y = axes.y(value);
    if (thin) dashed(list, {{left - 3, y}, {right + 3, y}}, colours::text);
    else list.AddRectFilled({left, std::min(y, axes.y(0))}, {right, std::max(y, axes.y(0)) + 1}, colours::stokes[s]);
  }
}

std::string values_text(const PixelInfo& info, std::size_t index) {
  std::string text;
  for (std::size_t s = 0; s < 4; ++s) {
    if (index >= info.stokes[s].size()) continue;
    text += fmt::format("{}{} {}", s ? "\n" : "", stokes_names[s], short_number(info.stokes[s][index]));
  }
  return text;
}

// The values at the wavelength that the mouse is at.
void read_off(ImDrawList& list, const Axes& axes, const PixelInfo& shown, const PixelInfo* other) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool lone = shown.lambda_nm.size() < 2;
  const double at = axes.from + (axes.to - axes.from) * (mouse.x - axes.low.x) / (axes.high.x - axes.low.x);
  const std::size_t index = lone ? 0 : preview::nearest_wavelength(shown.lambda_nm, at);
  const float x = axes.x(shown.lambda_nm[index]);
  if (!lone) list.AddLine({x, axes.low.y}, {x, axes.high.y}, colours::dim);
  std::string text = fmt::format("{:.6g} nm\n{}", shown.lambda_nm[index], values_text(shown, index));
  if (other && index < other->lambda_nm.size()) text += "\ndashed:\n" + values_text(*other, index);
  ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace

void spectrum_plot(const Fonts& fonts, ImVec2 size, const PixelInfo& shown, const PixelInfo* other) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("spectrum", size);
  if (shown.lambda_nm.empty()) return;
  const bool hovered = ImGui::IsItemHovered(), lone = shown.lambda_nm.size() < 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Axes axes = axes_of(fonts, at, size, shown, other);
  // Above: which line is which; below: the axis.
  const float right = axes.high.x;
  number_at(list, fonts, {at.x, at.y}, 0, colours::dim, "per nm");
  for (int s = 0; s < 4; ++s)
    if (!lone)
      number_at(list, fonts, {right - static_cast<float>(3 - s) * 26, at.y}, 1, colours::stokes[s], stokes_names[s]);
  draw_axes(list, fonts, axes, !lone);
  list.PushClipRect(axes.low, {axes.high.x + 1, axes.high.y + 1}, true);
  for (const PixelInfo* info : {other, &shown}) {
    if (!info) continue;
    if (lone) draw_bars(list, axes, *info, info != &shown);
    else draw_lines(list, axes, *info, info != &shown);
  }
  if (lone && other) draw_bars(list, axes, *other, true);
  list.PopClipRect();
  if (lone)
    for (int s = 0; s < 4; ++s)
      number_at(list, fonts, {axes.x(s + 0.5), axes.high.y + 2}, 0.5F, colours::stokes[s], stokes_names[s]);
  if (hovered) read_off(list, axes, shown, other);
}

}  // namespace nicol::window
