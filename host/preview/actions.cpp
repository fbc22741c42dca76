// Every action with its key.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "host/preview/session.hpp"

namespace nicol::preview {
namespace {

constexpr double turn_deg = 5, fine_deg = 1, orbit_rad = 0.1, pan_part = 0.05, zoom_step = 0.25, stop = 1.0 / 3;

double within_half_turn(double deg) { return std::remainder(deg, 360); }

Action turn_analyzer(const char* name, const char* key, const char* help, double deg) {
  return {name, key, help, [deg](Session& s) { s.controls.analyzer_deg = within_half_turn(s.controls.analyzer_deg + deg); }};
}
Action turn_polarizer(const char* name, const char* key, const char* help, double deg) {
  return {name, key, help, [deg](Session& s) { s.controls.polarizer_deg = within_half_turn(s.controls.polarizer_deg + deg); }};
}
Action orbit(const char* name, const char* key, double yaw, double pitch) {
  return {name, key, "orbit", [=](Session& s) {
            s.controls.navigation.yaw_rad += yaw;
            s.controls.navigation.pitch_rad += pitch;
          }};
}
Action pan(const char* name, const char* key, double right, double up) {
  return {name, key, "pan", [=](Session& s) {
            s.controls.navigation.pan_right += right;
            s.controls.navigation.pan_up += up;
          }};
}
Action zoom(const char* name, const char* key, double step) {
  return {name, key, "zoom", [=](Session& s) { s.controls.navigation.zoom += step; }};
}
Action toggle(const char* name, const char* key, const char* help, bool Controls::*what) {
  return {name, key, help, [=](Session& s) { s.controls.*what = !(s.controls.*what); }};
}

Action next_view(const char* name, const char* key, const char* help, int pane) {
  return {name, key, help, [pane](Session& s) {
            Quantity& shown = s.controls.view[static_cast<std::size_t>(pane)].quantity;
            const auto& all = all_quantities();
            const auto at = std::find(all.begin(), all.end(), shown);
            shown = at == all.end() || at + 1 == all.end() ? all.front() : *(at + 1);
          }};
}

void scrub(Session& s, int step) {
  const int count = static_cast<int>(s.status(0).lambda_nm.size());
  if (count == 0) return;
  const int now = s.controls.scrubbed ? static_cast<int>(*s.controls.scrubbed) + step : count / 2;
  s.controls.scrubbed = static_cast<std::size_t>(std::clamp(now, 0, count - 1));
}

void cycle_analyzer(Session& s) {
  Analyzer& now = s.controls.analyzer;
  now = now == Analyzer::as_scene ? Analyzer::none : now == Analyzer::none ? Analyzer::added : Analyzer::as_scene;
}

void before_analyzer(Session& s) {
  bool& on = s.controls.before_analyzer;
  on = !on;
  s.tell(on ? "right: the light that arrives at the analyzer" : "right: the left picture");
}

std::vector<Action> make_actions() {
  return {
      toggle("help", "h", "this help", &Controls::show_help),
      toggle("panel", "tab", "the panel", &Controls::show_panel),
      {"reset", "r", "camera, polarizers, effects, exposure and views as at the start", [](Session& s) { s.reset(); }},
      {"reload", "F5", "read the files again", [](Session& s) { s.reload(); }},
      next_view("view left", "c", "the left pane's next view", 0),
      next_view("view right", "v", "the right pane's next view", 1),
      {"scrub down", ",", "one wavelength; the next shorter", [](Session& s) { scrub(s, -1); }},
      {"scrub up", ".", "one wavelength; the next longer", [](Session& s) { scrub(s, 1); }},
      {"spectrum", "/", "the whole spectrum again", [](Session& s) { s.controls.scrubbed.reset(); }},
      {"exposure down", "-", "darker by 1/3 stop", [](Session& s) { s.controls.exposure_stops -= stop; }},
      {"exposure up", "=", "brighter by 1/3 stop", [](Session& s) { s.controls.exposure_stops += stop; }},
      turn_analyzer("analyzer left", "a", "analyzer 5 deg counter-clockwise", turn_deg),
      turn_analyzer("analyzer right", "shift+a", "analyzer 5 deg clockwise", -turn_deg),
      turn_analyzer("analyzer fine left", "ctrl+a", "analyzer 1 deg counter-clockwise", fine_deg),
      turn_polarizer("polarizer left", "p", "polarizers 5 deg counter-clockwise", turn_deg),
      turn_polarizer("polarizer right", "shift+p", "polarizers 5 deg clockwise", -turn_deg),
      turn_polarizer("polarizer fine left", "ctrl+p", "polarizers 1 deg counter-clockwise", fine_deg),
      {"analyzer kind", "n", "analyzer: the scene's, none, an ideal one", cycle_analyzer},
      {"before analyzer", "b", "right pane: the light that arrives at the analyzer", before_analyzer},
      toggle("difference", "d", "right pane: |left - right|, where two renders are compared", &Controls::show_difference),
      {"less difference", "[", "half the amplification", [](Session& s) { s.controls.amplification /= 2; }},
      {"more difference", "]", "twice the amplification", [](Session& s) { s.controls.amplification *= 2; }},
      toggle("wipe", "w", "both pictures in one place, cut at the divider", &Controls::wipe),
      orbit("orbit left", "left", -orbit_rad, 0),
      orbit("orbit right", "right", orbit_rad, 0),
      orbit("orbit up", "up", 0, orbit_rad),
      orbit("orbit down", "down", 0, -orbit_rad),
      pan("pan left", "shift+left", -pan_part, 0),
      pan("pan right", "shift+right", pan_part, 0),
      pan("pan up", "shift+up", 0, pan_part),
      pan("pan down", "shift+down", 0, -pan_part),
      zoom("nearer", "pageup", zoom_step),
      zoom("farther", "pagedown", -zoom_step),
      {"save picture", "s", "save what the left pane shows (.png)", [](Session& s) { s.save_picture(0); }},
      {"save right picture", "shift+s", "save what the right pane shows (.png)", [](Session& s) { s.save_picture(1); }},
      {"save spectra", "e", "save the left picture's spectra (.exr)", [](Session& s) { s.save_spectra(0); }},
      {"save right spectra", "shift+e", "save the right picture's spectra (.exr)", [](Session& s) { s.save_spectra(1); }},
      {"save camera", "k", "save the camera as text (.inc)", [](Session& s) { s.save_camera(); }},
  };
}

bool turn_effect_by_key(Session& session, const std::string& key) {
  const bool shift = key.rfind("shift+", 0) == 0;
  const std::string digit = shift ? key.substr(6) : key;
  if (digit.size() != 1 || digit[0] < '1' || digit[0] > '9') return false;
  session.turn_effect(digit[0] - '0', shift);
  return true;
}

bool act(Session& session, const std::string& word, std::string Action::*by) {
  const auto& all = actions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Action& action) { return action.*by == word; });
  if (found == all.end()) return false;
  found->act(session);
  return true;
}

}  // namespace

const std::vector<Action>& actions() {
  static const std::vector<Action> all = make_actions();
  return all;
}

bool act_by_key(Session& session, const std::string& key) {
  return turn_effect_by_key(session, key) || act(session, key, &Action::key);
}

bool act_by_name(Session& session, const std::string& name) { return act(session, name, &Action::name); }

}  // namespace nicol::preview
