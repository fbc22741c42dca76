#include "host/window/script_state.hpp"

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace nicol::window {
namespace {

using nlohmann::json;

json as_json(const preview::Rect& r) { return {{"x", r.x}, {"y", r.y}, {"width", r.width}, {"height", r.height}}; }

json as_json(const preview::PaneStatus& s) {
  json messages = json::array(), effects = json::array();
  for (const preview::Message& m : s.messages)
    messages.push_back({{"error", m.error}, {"file", m.file}, {"line", m.line}, {"column", m.column}, {"text", m.text}});
  for (const Effect& effect : s.effects) effects.push_back(effect.name);
  return {{"title", s.title}, {"device", s.device}, {"real", s.real}, {"reading", s.reading}, {"working", s.working}, {"done", s.done},
          {"specialised", s.specialised}, {"building", s.building}, {"step", s.step}, {"samples", s.samples}, {"passes", s.passes},
          {"sample_error", s.sample_error}, {"segments_per_second", s.segments_per_second}, {"seconds_to_first", s.seconds_to_first},
          {"pass_seconds", s.pass_seconds}, {"all_effects_pass_seconds", s.all_effects_pass_seconds}, {"effects", effects},
          {"without", s.without}, {"messages", messages}, {"stale", s.stale}, {"failure", s.failure}, {"chosen", s.chosen},
          {"counted_errors", s.counted_errors}};
}

json as_json(const preview::Controls& c) {
  json views = json::array();
  for (const preview::View& view : c.view) views.push_back(preview::name_of(view.quantity));
  return {{"analyzer_deg", c.analyzer_deg}, {"polarizer_deg", c.polarizer_deg}, {"exposure_stops", c.exposure_stops},
          {"divider", c.divider}, {"difference", c.show_difference}, {"amplification", c.amplification}, {"wipe", c.wipe},
          {"views", views}, {"width", c.width}, {"height", c.height}, {"yaw_rad", c.navigation.yaw_rad},
          {"pitch_rad", c.navigation.pitch_rad}, {"zoom", c.navigation.zoom}, {"pan", {c.navigation.pan_right, c.navigation.pan_up}}};
}

double resident_mib() {
  std::ifstream in("/proc/self/statm");
  double pages = 0, resident = 0;
  in >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

}  // namespace

double seconds_since_start() {
  std::ifstream in("/proc/self/stat");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string field;
  constexpr int start_time = 20;   // after the name: field 22 of proc(5)
  for (int i = 0; i < start_time && fields >> field; ++i) {
  }
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
         std::strtod(field.c_str(), nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::string state_text(const preview::Session& session, const Surface& surface, const Screen& screen, double first_picture_seconds) {
  session.finish_showing();
  const preview::Layout& layout = screen.layout();
  json widgets = json::object();
  for (const auto& [name, rect] : screen.widgets()) widgets[name] = as_json(rect);
  json state{{"window", {surface.logical_width(), surface.logical_height()}}, {"frames", screen.frames_drawn()},
             {"panes", {as_json(session.status(0)), as_json(session.status(1))}}, {"two_renders", session.two_renders()},
             {"at_rest", session.at_rest()}, {"controls", as_json(session.controls)}, {"notice", session.notice()},
             {"pictures", {as_json(layout.picture[0]), as_json(layout.picture[1])}}, {"divider", as_json(layout.divider)},
             {"panel", as_json(layout.panel)}, {"widgets", widgets}, {"first_picture_seconds", first_picture_seconds},
             {"resident_mib", resident_mib()}};
  if (const preview::Difference* d = session.difference())
    state["difference"] = {{"comparable", d->comparable}, {"rms", d->rms}, {"largest", d->largest}, {"x", d->x}, {"y", d->y}};
  return state.dump();
}

std::string pixel_text(preview::Session& session, int pane, int x, int y) {
  const auto info = session.pixel(pane, x, y);
  if (!info) return "null";
  json text{{"x", info->x}, {"y", info->y}, {"lambda_nm", info->lambda_nm}, {"stokes", info->stokes}, {"xyz", info->xyz}, {"rgb", info->rgb},
            {"srgb", info->srgb}, {"stokes_y", info->stokes_y}, {"degree", info->ellipse.degree}, {"azimuth_rad", info->ellipse.azimuth_rad},
            {"ellipticity_rad", info->ellipse.ellipticity_rad}, {"samples", info->samples}, {"cut_off", info->cut_off}};
  if (const auto path = session.pixel_path(pane, x, y)) text["path"] = {{"effects", path->effects}, {"cells", path->cells}, {"ends", path->ends}};
  return text.dump();
}

}  // namespace nicol::window
