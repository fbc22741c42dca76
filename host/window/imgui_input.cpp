// See imgui_input.hpp. ImGui 1.86 has no queue of its own.
#include "host/window/imgui_input.hpp"

#include <imgui.h>

#include <array>
#include <utility>

namespace nicol::window {
namespace {

using Kind = Event::Kind;

struct KnownKey {
  ImGuiKey key;
  const char* name;
};
// ImGui knows a key by its index here.
constexpr std::array<KnownKey, 20> known_keys = {{
    {ImGuiKey_Tab, "tab"}, {ImGuiKey_LeftArrow, "left"}, {ImGuiKey_RightArrow, "right"}, {ImGuiKey_UpArrow, "up"},
    {ImGuiKey_DownArrow, "down"}, {ImGuiKey_PageUp, "pageup"}, {ImGuiKey_PageDown, "pagedown"}, {ImGuiKey_Home, "home"},
    {ImGuiKey_End, "end"}, {ImGuiKey_Insert, "insert"}, {ImGuiKey_Delete, "delete"}, {ImGuiKey_Backspace, "backspace"},
    {ImGuiKey_Space, "space"}, {ImGuiKey_Enter, "enter"}, {ImGuiKey_Escape, "escape"}, {ImGuiKey_A, "a"},
    {ImGuiKey_C, "c"}, {ImGuiKey_V, "v"}, {ImGuiKey_X, "x"}, {ImGuiKey_Z, "z"}}};

bool is_button(const Event& event) { return event.kind == Kind::mouse_press || event.kind == Kind::mouse_release; }

int imgui_button(preview::Button button) {
  return button == preview::Button::left ? ImGuiMouseButton_Left
         : button == preview::Button::right ? ImGuiMouseButton_Right
                                            : ImGuiMouseButton_Middle;
}

}  // namespace

std::string without_modifiers(const std::string& key) {
  const std::size_t plus = key.size() > 1 ? key.rfind('+', key.size() - 2) : std::string::npos;
  return plus == std::string::npos ? key : key.substr(plus + 1);
}

ImguiInput::ImguiInput() {
  ImGuiIO& io = ImGui::GetIO();
  for (std::size_t i = 0; i < known_keys.size(); ++i) io.KeyMap[known_keys[i].key] = static_cast<int>(i);
}

std::vector<Event> ImguiInput::take(Surface& surface) {
  std::vector<Event> taken;
  bool moved = false, pressed_key = false;
  while (true) {
    std::optional<Event> event = held_ ? std::exchange(held_, std::nullopt) : surface.next_event();
    if (!event) return taken;
    const bool too_soon = (is_button(*event) && moved) || (event->kind == Kind::key_release && pressed_key);
    if (too_soon) {
      held_ = std::move(event);
      return taken;
    }
    feed(*event);
    moved = moved || event->kind == Kind::mouse_move;
    pressed_key = pressed_key || event->kind == Kind::key_press;
    taken.push_back(std::move(*event));
    if (is_button(taken.back())) return taken;
  }
}

void ImguiInput::feed(const Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.kind < Kind::character) {
    io.KeyShift = event.shift;
    io.KeyCtrl = event.ctrl;
    io.KeyAlt = event.alt;
  }
  switch (event.kind) {
    case Kind::mouse_move:
      io.MousePos = {static_cast<float>(event.at.x), static_cast<float>(event.at.y)};
      break;
    case Kind::mouse_press:
    case Kind::mouse_release:
      io.MouseDown[imgui_button(event.button)] = event.kind == Kind::mouse_press;
      break;
    case Kind::scroll:
      io.MouseWheelH += static_cast<float>(event.scroll_right);
      io.MouseWheel += static_cast<float>(event.scroll_up);
      break;
    case Kind::key_press: set_key(event.key, true); break;
    case Kind::key_release: set_key(event.key, false); break;
    case Kind::character: io.AddInputCharacter(event.character); break;
    case Kind::focus: io.AddFocusEvent(event.focused); break;
    case Kind::resize:
    case Kind::close: break;
  }
}

void ImguiInput::set_key(const std::string& name, bool down) {
  const std::string plain = without_modifiers(name);
  for (std::size_t i = 0; i < known_keys.size(); ++i)
    if (plain == known_keys[i].name) ImGui::GetIO().KeysDown[i] = down;
}

}  // namespace nicol::window
