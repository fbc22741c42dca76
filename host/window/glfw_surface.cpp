// A visible window: GLFW, OpenGL 3.3 core.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/window/surface.hpp"

namespace nicol::window {
namespace {

// Keys that type nothing, and digits, which have their place on every keyboard.
const std::map<int, std::string>& named_keys() {
  static const std::map<int, std::string> names = [] {
    std::map<int, std::string> all = {
        {GLFW_KEY_LEFT, "left"}, {GLFW_KEY_RIGHT, "right"}, {GLFW_KEY_UP, "up"}, {GLFW_KEY_DOWN, "down"},
        {GLFW_KEY_ESCAPE, "escape"}, {GLFW_KEY_ENTER, "enter"}, {GLFW_KEY_KP_ENTER, "enter"}, {GLFW_KEY_TAB, "tab"},
        {GLFW_KEY_BACKSPACE, "backspace"}, {GLFW_KEY_DELETE, "delete"}, {GLFW_KEY_INSERT, "insert"},
        {GLFW_KEY_HOME, "home"}, {GLFW_KEY_END, "end"}, {GLFW_KEY_PAGE_UP, "pageup"},
        {GLFW_KEY_PAGE_DOWN, "pagedown"}, {GLFW_KEY_SPACE, "space"}};
    for (int i = 0; i < 12; ++i) all[GLFW_KEY_F1 + i] = "F" + std::to_string(i + 1);
    for (int i = 0; i < 10; ++i) all[GLFW_KEY_0 + i] = all[GLFW_KEY_KP_0 + i] = std::to_string(i);
    return all;
  }();
  return names;
}

bool is_letter_or_digit(char32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// Letters by the keyboard's own layout; signs come by what they type.
std::string key_name(int key, int scancode) {
  const auto named = named_keys().find(key);
  if (named != named_keys().end()) return named->second;
  const char* name = glfwGetKeyName(key, scancode);
  return name && name[0] && !name[1] && is_letter_or_digit(static_cast<unsigned char>(name[0])) ? name : "";
}

std::string with_modifiers(const std::string& name, int mods) {
  std::string all;
  if (mods & GLFW_MOD_CONTROL) all += "ctrl+";
  if (mods & GLFW_MOD_ALT) all += "alt+";
  if (mods & GLFW_MOD_SHIFT) all += "shift+";
  return all + name;
}

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

class GlfwSurface : public Surface {
 public:
  GlfwSurface(const std::string& title, int width, int height) {
    if (!dlopen("libGL.so.1", RTLD_LAZY | RTLD_GLOBAL))
      throw WindowError("no window: libGL.so.1 is missing; install libgl1 and libgl1-mesa-dri (Debian's names)");
    if (!glfwInit()) throw WindowError("no display: neither X11 nor Wayland answers (GLFW: " + glfw_error() + ")");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
      const std::string reason = glfw_error();
      glfwTerminate();
      throw WindowError("no window: the display gives no OpenGL 3.3 (GLFW: " + reason + ")");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    divider_cursor_ = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
    listen();
  }

  ~GlfwSurface() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  void make_current() override { glfwMakeContextCurrent(window_); }
  unsigned framebuffer() const override { return 0; }
  void framebuffer_size(int& width, int& height) const override { glfwGetFramebufferSize(window_, &width, &height); }
  double content_scale() const override {
    float across = 1, down = 1;
    glfwGetWindowContentScale(window_, &across, &down);
    return across > 0 ? across : 1;
  }
  void swap() override { glfwSwapBuffers(window_); }
  void poll() override { glfwPollEvents(); }
  void wake() override { glfwPostEmptyEvent(); }
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
  void set_cursor(Cursor cursor) override {
    glfwSetCursor(window_, cursor == Cursor::arrow ? nullptr : divider_cursor_);
  }
  bool should_close() const override { return glfwWindowShouldClose(window_) != 0; }

  void wait(std::optional<double> timeout_seconds) override {
    if (!timeout_seconds) glfwWaitEvents();
    else if (*timeout_seconds > 0) glfwWaitEventsTimeout(*timeout_seconds);
    else glfwPollEvents();
  }

 private:
  static GlfwSurface& of(GLFWwindow* window) { return *static_cast<GlfwSurface*>(glfwGetWindowUserPointer(window)); }

  Event event(Event::Kind kind) const {
    const auto down = [&](int a, int b) {
      return glfwGetKey(window_, a) == GLFW_PRESS || glfwGetKey(window_, b) == GLFW_PRESS;
    };
    Event e;
    e.kind = kind;
    e.shift = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    e.ctrl = down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    e.alt = glfwGetKey(window_, GLFW_KEY_LEFT_ALT) == GLFW_PRESS;
    return e;
  }

  void listen() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).moved(x, y); });
    glfwSetMouseButtonCallback(
        window_, [](GLFWwindow* w, int button, int action, int) { of(w).button(button, action); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double right, double up) {
      Event e = of(w).event(Event::Kind::scroll);
      e.scroll_right = right;
      e.scroll_up = up;
      of(w).push(e);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
      of(w).key(key, scancode, action, mods);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) { of(w).character(character); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).tell(Event::Kind::resize); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).tell(Event::Kind::resize); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).tell(Event::Kind::resize); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { of(w).tell(Event::Kind::close); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
      Event e = of(w).event(Event::Kind::focus);
      e.focused = focused != 0;
      of(w).push(e);
    });
  }

  void tell(Event::Kind kind) { push(event(kind)); }

  // GLFW's window coordinates are framebuffer pixels on some systems and logical ones on others.
  void moved(double x, double y) {
    int window_width = 0, window_height = 0, width = 0, height = 0;
    glfwGetWindowSize(window_, &window_width, &window_height);
    glfwGetFramebufferSize(window_, &width, &height);
    Event e = event(Event::Kind::mouse_move);
    e.at = {x * width / std::max(1, window_width) / content_scale(),
            y * height / std::max(1, window_height) / content_scale()};
    push(e);
  }

  void button(int number, int action) {
    if (number > GLFW_MOUSE_BUTTON_MIDDLE) return;
    Event e = event(action == GLFW_PRESS ? Event::Kind::mouse_press : Event::Kind::mouse_release);
    e.button = number == GLFW_MOUSE_BUTTON_LEFT    ? preview::Button::left
               : number == GLFW_MOUSE_BUTTON_RIGHT ? preview::Button::right
                                                   : preview::Button::middle;
    push(e);
  }

  void key(int code, int scancode, int action, int mods) {
    const std::string name = key_name(code, scancode);
    // With AltGr held a key types a sign, and is not itself.
    const bool types_a_sign = name.size() == 1 && glfwGetKey(window_, GLFW_KEY_RIGHT_ALT) == GLFW_PRESS;
    if (name.empty() || types_a_sign) return;
    Event e = event(action == GLFW_RELEASE ? Event::Kind::key_release : Event::Kind::key_press);
    e.key = with_modifiers(name, mods);
    e.repeated = action == GLFW_REPEAT;
    push(e);
  }

  void character(char32_t typed) {
    Event e = event(Event::Kind::character);
    e.character = typed;
    push(e);
    if (typed <= ' ' || typed > '~' || is_letter_or_digit(typed)) return;
    e.kind = Event::Kind::key_press;
    e.key = std::string(1, static_cast<char>(typed));
    push(e);
    e.kind = Event::Kind::key_release;
    push(e);
  }

  GLFWwindow* window_ = nullptr;
  GLFWcursor* divider_cursor_ = nullptr;
};

}  // namespace

std::unique_ptr<Surface> open_window(const std::string& title, int width, int height) {
  return std::make_unique<GlfwSurface>(title, width, height);
}

}  // namespace nicol::window
