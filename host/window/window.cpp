// The turns of the window: events to ImGui, to the mouse in the pictures, to the keys; then a frame, if there is
// something new.
#include "host/window/window.hpp"

#include <algorithm>
#include <chrono>
#include <cctype>
#include <cmath>

#include "host/window/canvas.hpp"
#include "host/window/imgui_input.hpp"
#include "host/window/panels.hpp"

namespace nicol::window {

using preview::PixelPlace;
using Kind = Event::Kind;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int frames_to_settle = 2;   // ImGui knows sizes a frame late

bool is_switch(const std::string& key) {
  const std::string plain = without_modifiers(key);
  return plain.size() == 1 && std::isalnum(static_cast<unsigned char>(plain[0])) != 0;
}

}  // namespace

struct Screen::Parts {
  Parts(preview::Session& s, Surface& on, ScreenOptions o)
      : session(s), surface(on), options(o), context(on), canvas(s, on), mouse(s.controls) {}

  preview::Session& session;
  Surface& surface;
  ScreenOptions options;
  ImguiContext context;
  ImguiInput input;
  Canvas canvas;
  preview::Mouse mouse;
  preview::Layout layout;
  std::optional<PixelPlace> pixel;
  Widgets widgets;
  int settling = frames_to_settle;
  bool ended = false, mouse_known = false;
  std::uint64_t frames = 0;
  std::string shown_notice;
  std::array<double, 2> asked_size{};   // of the panes
  std::array<double, 2> seen_size{};    // and what it has been since `seen_at`
  Clock::time_point seen_at{};
  bool size_waits = false;
  std::array<int, 2> fitted_size{};     // of the pictures then
  std::size_t shown_messages = 0;
  bool path_missing = false;

  Ui ui() { return {session, surface, layout, context.fonts(), widgets, pixel}; }
  void lay_out() { layout = preview::lay_out(surface.logical_width(), surface.logical_height(), session.controls); }
  void fit_pictures();
  bool something_new();
  void frame(const std::vector<Event>& events);
  void dispatch(const Event& event);
  void key(const Event& event);
  void find_pixel();
  void build(Ui& ui);
};

// Asks for pictures as large as the panes, in the framebuffer's pixels, when the panes' size or the pictures' shape has
// changed; not before a drag of the divider has ended, nor while the window's edge is being dragged.
void Screen::Parts::fit_pictures() {
  size_waits = false;
  if (!options.pictures_fit_window || mouse.dragging()) return;
  lay_out();
  const double scale = surface.content_scale();
  const std::array<double, 2> size{std::floor(scale * std::max(layout.pane[0].width, layout.pane[1].width)),
                                   std::floor(scale * layout.pane[0].height)};
  const auto pictures = [&] { return std::array<int, 2>{session.controls.width, session.controls.height}; };
  if ((size == asked_size && pictures() == fitted_size) || size[0] < 1 || size[1] < 1) return;
  constexpr std::chrono::milliseconds rest{150};
  const bool first = asked_size == std::array<double, 2>{};
  if (size != seen_size) seen_at = Clock::now();
  seen_size = size;
  size_waits = !first && Clock::now() - seen_at < rest;
  if (size_waits) return;
  asked_size = size;
  session.take_window_size(size[0], size[1]);
  fitted_size = pictures();
}

bool Screen::Parts::something_new() {
  const bool changed = session.update();
  const bool path_came = path_missing && pixel && session.pixel_path(pixel->pane, pixel->x, pixel->y);
  const std::size_t messages = session.status(0).messages.size() + session.status(1).messages.size();
  if (messages != shown_messages) settling = frames_to_settle;
  shown_messages = messages;
  return changed || path_came || session.notice() != shown_notice;
}

void Screen::Parts::key(const Event& event) {
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (ImGui::GetIO().WantTextInput || (event.repeated && is_switch(event.key))) return;
  if (event.key == "ctrl+c") copy_camera(session, surface);
  else if (event.key == "escape" && session.controls.show_help) session.controls.show_help = false;
  else if (event.key == "escape" || event.key == "q") ended = ended || !popup;
  else preview::act_by_key(session, event.key);
}

// A drag goes on where it began: ImGui keeps its own, Mouse keeps those in the pictures.
void Screen::Parts::dispatch(const Event& event) {
  const bool for_picture = mouse.dragging() || !ImGui::GetIO().WantCaptureMouse;
  switch (event.kind) {
    case Kind::mouse_move:
      mouse_known = true;
      if (for_picture) mouse.move(layout, event.at);
      break;
    case Kind::mouse_press:
      if (for_picture) mouse.press(layout, event.button, event.shift);
      break;
    case Kind::mouse_release:
      if (for_picture) mouse.release(layout, event.button);
      break;
    case Kind::scroll:
      if (for_picture) mouse.scroll(layout, event.scroll_up);
      break;
    case Kind::key_press: key(event); break;
    case Kind::close: ended = true; break;
    default: break;
  }
}

// The pixel under the mouse, or the last one that was; the pinned one in the pane under the mouse.
void Screen::Parts::find_pixel() {
  const preview::Controls& controls = session.controls;
  const bool in_pictures = mouse_known && !ImGui::GetIO().WantCaptureMouse;
  const auto under = in_pictures ? preview::pixel_at(layout, controls, mouse.at()) : std::nullopt;
  if (under) pixel = under;
  if (controls.pinned) pixel = PixelPlace{pixel ? pixel->pane : 0, (*controls.pinned)[0], (*controls.pinned)[1]};
  if (pixel && (pixel->x >= controls.width || pixel->y >= controls.height)) pixel.reset();
}

static void draw_divider(const Ui& ui) {
  const preview::Rect& d = ui.layout.divider;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const double middle = d.x + d.width / 2;
  if (ui.session.controls.wipe) {
    list.AddRectFilled(vec(middle - 1.5, d.y), vec(middle + 1.5, d.y + d.height), IM_COL32(20, 20, 20, 255));
    list.AddRectFilled(vec(middle - 0.5, d.y), vec(middle + 0.5, d.y + d.height), IM_COL32(200, 200, 200, 255));
    return;
  }
  list.AddRectFilled(corner(d), far_corner(d), IM_COL32(28, 28, 28, 255));
  const double y = d.y + d.height / 2;
  list.AddRectFilled(vec(middle - 1, y - 14), vec(middle + 1, y + 14), IM_COL32(120, 120, 120, 255));
}

void Screen::Parts::build(Ui& ui) {
  for (int pane = 0; pane < 2; ++pane) pane_overlay(ui, pane);
  draw_divider(ui);
  message_box(ui, 0);
  if (session.two_renders()) message_box(ui, 1);
  side_panel(ui);
  status_line(ui);
  help_overlay(ui);
}

void Screen::Parts::frame(const std::vector<Event>& events) {
  lay_out();
  context.begin_frame();
  for (const Event& event : events) dispatch(event);
  session.update();
  lay_out();
  find_pixel();
  widgets.clear();
  shown_notice = session.notice();
  Ui drawn = ui();
  build(drawn);
  path_missing = pixel && !session.pixel_path(pixel->pane, pixel->x, pixel->y);
  const bool at_divider = mouse_known && !ImGui::GetIO().WantCaptureMouse && mouse.over_divider(layout);
  surface.set_cursor(at_divider ? Cursor::resize_horizontally : Cursor::arrow);
  ImGui::Render();
  canvas.draw(drawn);
  ++frames;
}

Screen::Screen(preview::Session& session, Surface& surface, ScreenOptions options)
    : parts_(std::make_unique<Parts>(session, surface, options)) {}

Screen::~Screen() { parts_->surface.make_current(); }

void Screen::turn() {
  Parts& p = *parts_;
  p.surface.make_current();
  p.surface.poll();
  const std::vector<Event> events = p.input.take(p.surface);
  p.ended = p.ended || p.surface.should_close();
  p.fit_pictures();
  const bool fresh = p.something_new();
  const auto moves = [](const Event& event) { return event.kind == Kind::mouse_move; };
  const bool only_moved = std::all_of(events.begin(), events.end(), moves);
  if (!events.empty()) p.settling = only_moved ? 1 : frames_to_settle;
  else if (p.settling > 0) --p.settling;
  else if (!fresh) return;
  p.frame(events);
}

void Screen::redraw() { parts_->settling = frames_to_settle + 1; }
bool Screen::more_to_do() const { return parts_->settling > 0 || parts_->input.has_more(parts_->surface); }
bool Screen::size_waits() const { return parts_->size_waits; }
bool Screen::ended() const { return parts_->ended; }
std::uint64_t Screen::frames_drawn() const { return parts_->frames; }
const std::vector<std::pair<std::string, preview::Rect>>& Screen::widgets() const { return parts_->widgets; }
const preview::Layout& Screen::layout() const { return parts_->layout; }

Screenshot Screen::screenshot() {
  Parts& p = *parts_;
  p.surface.make_current();
  if (p.frames == 0) turn();
  p.session.finish_showing();
  return p.canvas.screenshot(p.ui());
}

void run(preview::Session& session, Surface& surface, ScreenOptions options) {
  constexpr double least_pause_seconds = 0.05;   // between frames that nobody's hand asks for
  constexpr double look_again_seconds = 0.5;     // while a notice is shown, or work goes on
  Screen screen(session, surface, options);
  while (!screen.ended()) {
    screen.turn();
    if (screen.more_to_do() || screen.ended()) continue;
    const Clock::time_point drawn = Clock::now();
    const bool looks_again = !session.notice().empty() || !session.at_rest();
    surface.wait(screen.size_waits() ? std::optional<double>(least_pause_seconds)
                 : looks_again       ? std::optional<double>(look_again_seconds)
                                     : std::nullopt);
    while (!surface.has_events() && !surface.should_close()) {
      const double pause = least_pause_seconds - std::chrono::duration<double>(Clock::now() - drawn).count();
      if (pause <= 0) break;
      surface.wait(pause);
    }
  }
}

}  // namespace nicol::window
