// Events reach ImGui in portions that it can take.
#include <doctest/doctest.h>
#include <imgui.h>

#include "host/window/imgui_input.hpp"

using namespace nicol;
using namespace nicol::window;
using Kind = Event::Kind;

namespace {

// Nothing is drawn: a queue only.
class Queue : public Surface {
 public:
  void make_current() override {}
  unsigned framebuffer() const override { return 0; }
  void framebuffer_size(int& width, int& height) const override { width = height = 100; }
  double content_scale() const override { return 2; }
  void swap() override {}
  void wait(std::optional<double>) override {}
  void poll() override {}
  void wake() override { ++wakes; }
  void set_clipboard(const std::string&) override {}
  void set_cursor(Cursor) override {}
  bool should_close() const override { return false; }
  void add(Kind kind, const std::string& key = "") {
    Event event;
    event.kind = kind;
    event.key = key;
    event.at = {10, 20};
    push(event);
  }
  int wakes = 0;
};

struct Context {
  Context() { ImGui::CreateContext(); }
  ~Context() { ImGui::DestroyContext(); }
};

std::vector<Kind> kinds(const std::vector<Event>& events) {
  std::vector<Kind> all;
  for (const Event& event : events) all.push_back(event.kind);
  return all;
}

}  // namespace

TEST_CASE("a press and a release in one go are seen in two turns") {
  const Context context;
  Queue queue;
  ImguiInput input;
  queue.add(Kind::mouse_press);
  queue.add(Kind::mouse_release);
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_press});
  CHECK(ImGui::GetIO().MouseDown[0]);
  CHECK(input.has_more(queue));
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_release});
  CHECK_FALSE(ImGui::GetIO().MouseDown[0]);
  CHECK_FALSE(input.has_more(queue));
}

TEST_CASE("a button changes in a turn of its own, where the mouse has come to before") {
  const Context context;
  Queue queue;
  ImguiInput input;
  for (const Kind kind : {Kind::mouse_move, Kind::mouse_move, Kind::mouse_press, Kind::mouse_move, Kind::mouse_release})
    queue.add(kind);
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_move, Kind::mouse_move});
  CHECK(ImGui::GetIO().MousePos.y == 20);
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_press});
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_move});
  CHECK(ImGui::GetIO().MouseDown[0]);
  CHECK(kinds(input.take(queue)) == std::vector{Kind::mouse_release});
}

TEST_CASE("a key pressed and let go is down for a turn") {
  const Context context;
  Queue queue;
  ImguiInput input;
  const int left = ImGui::GetIO().KeyMap[ImGuiKey_LeftArrow];
  queue.add(Kind::key_press, "shift+left");
  queue.add(Kind::key_release, "shift+left");
  CHECK(input.take(queue).size() == 1);
  CHECK(ImGui::GetIO().KeysDown[left]);
  CHECK(input.take(queue).size() == 1);
  CHECK_FALSE(ImGui::GetIO().KeysDown[left]);
}

TEST_CASE("keys are known without their modifiers, the plus too") {
  CHECK(without_modifiers("left") == "left");
  CHECK(without_modifiers("ctrl+shift+a") == "a");
  CHECK(without_modifiers("+") == "+");
  CHECK(without_modifiers("shift++") == "+");
}

TEST_CASE("what is pushed wakes, and the logical size is that of the framebuffer by its scale") {
  Queue queue;
  queue.add(Kind::close);
  CHECK(queue.wakes == 1);
  CHECK(queue.logical_width() == 50);
}
