#include "host/window/script.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <istream>
#include <map>
#include <ostream>

#include "host/output/frame.hpp"
#include "host/window/script_state.hpp"
#include "host/window/script_words.hpp"

namespace nicol::window {
namespace {

using Kind = Event::Kind;
using Clock = std::chrono::steady_clock;

constexpr double patience_seconds = 300;

void save(const std::string& path, const Screenshot& shot) {
  Frame frame;
  frame.width = shot.width;
  frame.height = shot.height;
  frame.cut_off.resize(frame.plane());
  frame.row_done.assign(static_cast<std::size_t>(frame.height), 1);
  for (const std::uint8_t byte : shot.rgb) {
    const double v = byte / 255.0;   // IEC 61966-2-1
    frame.rgb.push_back(static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4)));
  }
  make_sink(path)->write(frame);
}

}  // namespace

struct Script::Parts {
  Parts(preview::Session& s, Surface& on, OffscreenSurface* none, ScreenOptions options)
      : session(s), surface(on), offscreen(none), screen(s, on, options) {}

  preview::Session& session;
  Surface& surface;
  OffscreenSurface* offscreen;
  Screen screen;
  double first_picture_seconds = 0;
  bool quit = false;

  void turn() {
    screen.turn();
    if (first_picture_seconds == 0 && !session.developed(0).rgb.empty() && session.status(0).step > 0)
      first_picture_seconds = seconds_since_start();
  }
  void settle() {
    for (turn(); screen.more_to_do() || screen.size_waits(); turn())
      if (!screen.more_to_do()) surface.wait(0.02);
  }
  template <class Is>
  void until(Is is, const char* what) {
    const auto end = Clock::now() + std::chrono::duration<double>(patience_seconds);
    for (settle(); !is(); settle()) {
      if (screen.ended()) return;
      if (Clock::now() > end) throw ScriptError(fmt::format("waited {} s in vain for '{}'", patience_seconds, what));
      surface.wait(0.1);
    }
    settle();
  }
  void push(Event event) {
    surface.push(std::move(event));
    settle();
  }
  void move_to(preview::Point at) {
    Event event;
    event.at = at;
    push(event);
  }
  void button(Kind kind, preview::Button which) {
    Event event;
    event.kind = kind;
    event.button = which;
    push(event);
  }
  preview::Point place(const Words& words, std::size_t& i);
  void wait(const Words& words);
  void drag(const Words& words);
  void set(const Words& words);
  void key(const std::string& name);
  void scroll(double steps);
  void click(const Words& words);
  void resize(const Words& words);
  void act_by_name(const Words& words);
  void act(const Words& words, std::ostream& answers);
};

preview::Point Script::Parts::place(const Words& words, std::size_t& i) {
  const preview::Layout& layout = screen.layout();
  const std::string& what = word_at(words, i++);
  if (what == "left" || what == "right") {
    const preview::Rect& r = layout.picture[what == "right"];
    const double x = number(word_at(words, i++)), y = number(word_at(words, i++));
    return {r.x + x * r.width, r.y + y * r.height};
  }
  if (what == "divider") {
    const preview::Rect& d = layout.divider;
    preview::Point at{d.x + d.width / 2, d.y + d.height / 2};
    const bool named = i < words.size() && words[i] != "divider" && words[i] != "left" && words[i] != "right";
    if (named) at.x = number(words[i++]) * surface.logical_width();
    return at;
  }
  if (what == "widget") {
    const std::string& name = word_at(words, i++);
    for (const auto& [known, r] : screen.widgets())
      if (known == name) return {r.x + r.width / 2, r.y + r.height / 2};
    throw ScriptError("no widget '" + name + "' is to be seen");
  }
  return {number(what), number(word_at(words, i++))};
}

void Script::Parts::wait(const Words& words) {
  const std::string& what = word_at(words, 1);
  const auto shown = [&] {
    for (int pane = 0; pane < 2; ++pane) {
      const preview::PaneStatus& s = session.status(pane);
      if (s.step == 0 && s.stale && !s.reading)
        throw ScriptError("there is no picture: " + (s.messages.empty() ? s.title : s.messages.front().text));
      if (s.step == 0 && s.failure.empty()) return false;
    }
    return true;
  };
  const auto failed = [&] { return session.status(0).stale || session.status(1).stale || !session.status(0).failure.empty(); };
  session.update();
  if (what == "picture") return until(shown, "picture");
  if (what == "done") return until([&] { return session.pictures_done(); }, "done");
  if (what == "rest") return until([&] { return session.at_rest(); }, "rest");
  if (what == "error") return until(failed, "error");
  const auto end = Clock::now() + std::chrono::duration<double>(number(what));
  until([&] { return Clock::now() >= end; }, "time");
}

// A move in steps, as a hand makes it.
void Script::Parts::drag(const Words& words) {
  std::size_t i = 1;
  const preview::Point from = place(words, i), to = place(words, i);
  const preview::Button which = button_at(words, i);
  move_to(from);
  button(Kind::mouse_press, which);
  constexpr int steps = 8;
  for (int step = 1; step <= steps; ++step)
    move_to({from.x + (to.x - from.x) * step / steps, from.y + (to.y - from.y) * step / steps});
  button(Kind::mouse_release, which);
}

void Script::Parts::set(const Words& words) {
  const std::string& name = word_at(words, 1);
  const std::string& value = word_at(words, 2);
  preview::Controls& c = session.controls;
  const std::map<std::string, double*> numbers{{"analyzer", &c.analyzer_deg}, {"polarizer", &c.polarizer_deg},
                                               {"exposure", &c.exposure_stops}, {"amplification", &c.amplification},
                                               {"divider", &c.divider}};
  if (const auto found = numbers.find(name); found != numbers.end()) {
    *found->second = number(value);
  } else if (name == "wavelength" && value == "none") {
    c.scrubbed.reset();
  } else if (name == "wavelength") {
    const auto& lambda_nm = session.status(0).lambda_nm;
    if (lambda_nm.empty()) throw ScriptError("there are no wavelengths yet");
    c.scrubbed = preview::nearest_wavelength(lambda_nm, number(value));
  } else if (name == "left" || name == "right") {
    const auto quantity = preview::quantity_named(value);
    if (!quantity) throw ScriptError("there is no view '" + value + "'");
    c.view[name == "right"].quantity = *quantity;
  } else {
    throw ScriptError("'" + name + "' cannot be set");
  }
  screen.redraw();
  settle();
}

void Script::Parts::key(const std::string& name) {
  Event event;
  event.kind = Kind::key_press;
  event.key = name;
  surface.push(event);
  event.kind = Kind::key_release;
  push(event);
}

void Script::Parts::scroll(double steps) {
  Event event;
  event.kind = Kind::scroll;
  event.scroll_up = steps;
  push(event);
}

void Script::Parts::click(const Words& words) {
  std::size_t i = 1;
  move_to(place(words, i));
  const preview::Button which = button_at(words, i);
  button(Kind::mouse_press, which);
  button(Kind::mouse_release, which);
}

void Script::Parts::resize(const Words& words) {
  if (!offscreen) throw ScriptError("'size' is for scripts without a display");
  const double width = number(word_at(words, 1)), height = number(word_at(words, 2));
  if (width < 1 || height < 1 || width > 16384 || height > 16384) throw ScriptError("a window has 1 to 16384 pixels a side");
  offscreen->resize(static_cast<int>(width), static_cast<int>(height));
  settle();
}

void Script::Parts::act_by_name(const Words& words) {
  const std::string name = fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
  if (!preview::act_by_name(session, name)) throw ScriptError("there is no action '" + name + "'");
  screen.redraw();
  settle();
}

void Script::Parts::act(const Words& words, std::ostream& answers) {
  const std::map<std::string, std::function<void()>> commands{
      {"wait", [&] { wait(words); }},
      {"key", [&] { key(word_at(words, 1)); }},
      {"do", [&] { act_by_name(words); }},
      {"move", [&] { std::size_t i = 1; move_to(place(words, i)); }},
      {"press", [&] { button(Kind::mouse_press, button_at(words, 1)); }},
      {"release", [&] { button(Kind::mouse_release, button_at(words, 1)); }},
      {"click", [&] { click(words); }},
      {"drag", [&] { drag(words); }},
      {"scroll", [&] { scroll(number(word_at(words, 1))); }},
      {"size", [&] { resize(words); }},
      {"set", [&] { set(words); }},
      {"replace", [&] { replace_in(word_at(words, 1), word_at(words, 2), word_at(words, 3)); }},
      {"screenshot", [&] { settle(); save(word_at(words, 1), screen.screenshot()); }},
      {"state", [&] { answers << state_text(session, surface, screen, first_picture_seconds) << std::endl; }},
      {"pixel",
       [&] {
         const int x = static_cast<int>(number(word_at(words, 2))), y = static_cast<int>(number(word_at(words, 3)));
         answers << pixel_text(session, word_at(words, 1) == "right", x, y) << std::endl;
       }},
      {"quit", [&] { quit = true; }}};
  const auto command = commands.find(words.front());
  if (command == commands.end()) throw ScriptError("there is no command '" + words.front() + "'");
  command->second();
}

Script::Script(preview::Session& session, Surface& surface, OffscreenSurface* offscreen, ScreenOptions options)
    : parts_(std::make_unique<Parts>(session, surface, offscreen, options)) {}
Script::~Script() = default;

void Script::run(std::istream& commands, std::ostream& answers, bool interactive) {
  Parts& p = *parts_;
  int number_of_line = 0;
  p.settle();
  for (std::string line; !p.quit && !p.screen.ended() && std::getline(commands, line);) {
    ++number_of_line;
    try {
      const Words words = split(line);
      if (!words.empty()) p.act(words, answers);
      if (interactive) answers << "ok" << std::endl;
    } catch (const std::exception& error) {
      if (!interactive) throw ScriptError(fmt::format("line {}: {}", number_of_line, error.what()));
      answers << "error: " << error.what() << std::endl;
    }
  }
}

}  // namespace nicol::window
