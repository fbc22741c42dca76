// Errors and warnings of a scene over the lower part of its pane; the picture above them is the last good one.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "host/window/panels.hpp"
#include "host/window/texts.hpp"

namespace nicol::window {
namespace {

using preview::Message;
using preview::PaneStatus;

ImVec4 colour_of(bool error) { return ImGui::ColorConvertU32ToFloat4(error ? colours::error : colours::warning); }

// A line of the scene with its number; where the error is: highlighted, and a caret under its column.
void source_line(const Message& message, int number, const std::string& text) {
  const bool here = number == message.line;
  const ShownLine line = shown_line(text, here ? message.column : 0);
  if (here) {
    const float left = ImGui::GetWindowPos().x, top = ImGui::GetCursorScreenPos().y - 1;
    const ImVec2 end{left + ImGui::GetWindowWidth(), top + ImGui::GetTextLineHeight() + 2};
    const ImU32 behind = message.error ? IM_COL32(96, 40, 34, 255) : IM_COL32(84, 68, 30, 255);
    ImGui::GetWindowDrawList()->AddRectFilled({left, top}, end, behind);
  }
  ImGui::TextUnformatted(fmt::format("{:>6} {} {}", number, here ? '>' : '|', line.text).c_str());
  if (line.caret < 0) return;
  const std::string caret(static_cast<std::size_t>(9 + line.caret), ' ');   // below "%6d > "
  ImGui::TextColored(colour_of(message.error), "%s^", caret.c_str());
}

void show(const Ui& ui, const Message& message) {
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - 16);
  const std::string place = place_text(message);
  if (!place.empty()) ImGui::TextColored(colour_of(message.error), "%s", place.c_str());
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PushFont(ui.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6, 2});
  for (const auto& [number, text] : message.lines) source_line(message, number, text);
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::Spacing();
}

std::size_t count(const PaneStatus& status, bool errors) {
  return static_cast<std::size_t>(std::count_if(status.messages.begin(), status.messages.end(),
                                                [&](const Message& m) { return m.error == errors; }));
}

std::string counted(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

// Rows of text that the messages take, about.
double rows_of(const PaneStatus& status) {
  double rows = 2.5;
  for (const Message& m : status.messages)
    if (m.error) rows += 3.5 + static_cast<double>(m.lines.size()) + static_cast<double>(m.text.size()) / 60;
  return rows + (status.failure.empty() ? 0 : 2 + static_cast<double>(status.failure.size()) / 60);
}

// One line that opens.
void warnings(const Ui& ui, const PaneStatus& status) {
  const std::size_t all = count(status, false);
  if (all == 0) return;
  const bool open = ImGui::TreeNode("warnings", "%s", counted(all, "warning").c_str());
  ui.mark("warnings");
  if (!open) return;
  for (const Message& message : status.messages)
    if (!message.error) show(ui, message);
  ImGui::TreePop();
}

void errors_window(Ui& ui, const PaneStatus& status, const preview::Rect& pane, const char* name) {
  const double height = std::min(0.55 * pane.height, 18.0 * rows_of(status));
  const preview::Rect place{pane.x, pane.y + pane.height - height, pane.width, height};
  ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.10F, 0.10F, 0.10F, 1});
  ImGui::SetNextWindowPos(corner(place));
  ImGui::SetNextWindowSize(vec(place.width, place.height));
  ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                  ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_HorizontalScrollbar);
  const std::size_t errors = count(status, true);
  if (errors > 0)
    ImGui::TextDisabled("%s: %s", status.title.c_str(), counted(errors, "error").c_str());
  if (!status.failure.empty()) {
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - 16);
    ImGui::TextColored(colour_of(true), "%s", status.failure.c_str());
    ImGui::PopTextWrapPos();
  }
  for (const Message& message : status.messages)
    if (message.error) show(ui, message);
  warnings(ui, status);
  ImGui::End();
  ImGui::PopStyleColor();
}

// As small as its text, while it is closed.
void warnings_window(Ui& ui, const PaneStatus& status, const preview::Rect& pane, const char* name) {
  ImGui::SetNextWindowPos(vec(pane.x, pane.y + pane.height), ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, vec(pane.width, 0.55 * pane.height));
  ImGui::SetNextWindowBgAlpha(0.85F);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  warnings(ui, status);
  ImGui::End();
}

// Two panes of one scene have the same to tell.
bool told_at_left(const PaneStatus& left, const PaneStatus& right) {
  const auto same = [](const Message& a, const Message& b) {
    return a.error == b.error && a.told == b.told && a.text == b.text;
  };
  return std::equal(left.messages.begin(), left.messages.end(), right.messages.begin(), right.messages.end(), same) &&
         left.failure == right.failure;
}

}  // namespace

void message_box(Ui& ui, int pane) {
  const PaneStatus& status = ui.session.status(pane);
  if (pane == 1 && told_at_left(ui.session.status(0), status)) return;
  const preview::Rect place = visible_pane(ui, pane);
  const std::string name = fmt::format("messages {}", pane);
  if (count(status, true) > 0 || !status.failure.empty()) errors_window(ui, status, place, name.c_str());
  else if (!status.messages.empty()) warnings_window(ui, status, place, name.c_str());
}

}  // namespace nicol::window
