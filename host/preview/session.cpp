// The session's side of the window's thread.
#include "host/preview/session.hpp"

#include <algorithm>
#include <cmath>

#include "host/preview/session_parts.hpp"
#include "host/vec.hpp"

namespace nicol::preview {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int smallest_side = 16, largest_side = 8192;

// The largest size within width x height of the shape `aspect`.
std::array<int, 2> within(double width, double height, double aspect) {
  const double w = std::min(width, height * aspect);
  const auto side = [](double v) { return std::clamp(static_cast<int>(std::lround(v)), smallest_side, largest_side); };
  return {side(w), side(w / aspect)};
}

}  // namespace

Session::Session(SessionOptions options, std::function<void()> wake) {
  controls.width = options.width;
  controls.height = options.height;
  parts_ = std::make_unique<Parts>(std::move(options), controls, std::move(wake));
  update();
}

Session::~Session() = default;

bool Session::Parts::wants_right(const Controls& controls) const {
  return options.right || !controls.without_right.empty() || controls.before_analyzer;
}

bool Session::two_renders() const { return parts_->wants_right(controls) && parts_->panes().size() > 1; }
bool Session::compares() const { return two_renders() && (parts_->options.right || !controls.before_analyzer); }

Look Session::Parts::look_of(const Controls& controls, bool right) const {
  Look look;
  look.navigation = controls.navigation;
  look.analyzer = right && !options.right && controls.before_analyzer ? Analyzer::none : controls.analyzer;
  look.analyzer_rad = look.analyzer == Analyzer::none ? 0 : controls.analyzer_deg * pi / 180;
  look.polarizer_rad = controls.polarizer_deg * pi / 180;
  look.without = controls.without;
  if (right) look.without.insert(controls.without_right.begin(), controls.without_right.end());
  look.width = controls.width;
  look.height = controls.height;
  return look;
}

void Session::Parts::sync_panes(const Controls& controls) {
  auto now = panes();
  if (wants_right(controls) == (now.size() > 1)) return;
  if (now.size() > 1) {
    now.back()->stop();
    now.pop_back();
    asked[1].reset();
  } else {
    PaneSource source = options.right ? *options.right : options.left;
    now.push_back(std::make_shared<Pane>(std::move(source), builder, options, quit));
    asked[1] = look_of(controls, true);
    now.back()->ask(*asked[1]);
  }
  set_panes(std::move(now));
}

// The size and the views that suit the scene.
void Session::Parts::take_first_scene(Controls& controls) {
  const auto scene = panes().front()->scene();
  if (first_scene_taken || !scene) return;
  first_scene_taken = true;
  const Camera& camera = scene->camera;
  if (options.keep_camera_shape) {
    const auto size = within(options.width, options.height, length(camera.right) / length(camera.up));
    controls.width = at_start.width = size[0];
    controls.height = at_start.height = size[1];
  }
  if (!options.right && camera.polarizer) {
    controls.before_analyzer = at_start.before_analyzer = true;
    // Of all wavelengths together the planes of polarization of an active crystal come to nothing.
    constexpr double sodium_nm = 589.3;   // mean of the D lines
    controls.view[1] = at_start.view[1] = {Quantity::ellipses, nearest_wavelength(scene->lambda_nm, sodium_nm)};
  } else if (options.right) {
    controls.view[1] = at_start.view[1] = View{};
  }
}

bool Session::update() {
  Parts& p = *parts_;
  controls.navigation.zoom = std::clamp(controls.navigation.zoom, least_zoom, most_zoom);
  p.take_first_scene(controls);
  p.sync_panes(controls);
  const auto panes = p.panes();
  for (int i = 0; i < static_cast<int>(panes.size()); ++i) p.ask(i, p.look_of(controls, i == 1));
  for (std::size_t i = 0; i < 2; ++i) p.status[i] = panes[std::min(i, panes.size() - 1)]->status();
  std::vector<std::string> files;
  bool any_new = false;
  for (const auto& pane : panes) {
    const auto more = pane->files();
    files.insert(files.end(), more.begin(), more.end());
    any_new |= pane->status().stale;
  }
  if (files != p.watched || any_new != p.watched_any_new) {
    p.watched = files;
    p.watched_any_new = any_new;
    p.watch.watch(files, any_new);
    if (const std::string failure = p.watch.failure(); !failure.empty()) tell(failure + "; F5 reads the files again");
  }
  const std::uint64_t pieces = p.pieces;
  return std::exchange(p.pieces_seen, pieces) != pieces;
}

const PaneStatus& Session::status(int pane) const { return parts_->status[static_cast<std::size_t>(pane)]; }

View Session::shown_view(int pane) const {
  View view = controls.view[static_cast<std::size_t>(pane)];
  if (controls.scrubbed) view.wavelength = controls.scrubbed;
  const auto& lambda_nm = status(pane).lambda_nm;
  const std::size_t count = lambda_nm.size();
  const auto& of_left = status(0).lambda_nm;
  // The scrubber counts the left pane's wavelengths.
  if (pane == 1 && controls.scrubbed && *controls.scrubbed < of_left.size() && count > 0)
    view.wavelength = nearest_wavelength(lambda_nm, of_left[*controls.scrubbed]);
  if (view.wavelength && count > 0) view.wavelength = std::min(*view.wavelength, count - 1);
  if (view.wavelength && count == 0) view.wavelength.reset();
  return view;
}

bool Session::pictures_done() const {
  const auto panes = parts_->panes();
  const auto done = [](const auto& pane) { return pane->urgency() == Pane::nothing && pane->status().done; };
  return std::all_of(panes.begin(), panes.end(), done) && shows_latest();
}

bool Session::at_rest() const { return parts_->resting && pictures_done(); }

void Session::reload() {
  for (const auto& pane : parts_->panes()) pane->ask_read();
  parts_->notify();
}

void Session::turn_effect(int number, bool right_only) {
  const auto& effects = status(0).effects;
  if (number < 1 || number > static_cast<int>(effects.size())) {
    tell("the scene has no effect " + std::to_string(number));
    return;
  }
  const std::string& name = effects[static_cast<std::size_t>(number) - 1].name;
  std::set<std::string>& without = right_only ? controls.without_right : controls.without;
  if (without.erase(name) > 0) return;
  without.insert(name);
  if (!right_only || parts_->options.right) return;
  controls.before_analyzer = false;   // the right pane compares now
  controls.view[1] = controls.view[0];
}

void Session::reset() {
  Controls fresh = parts_->at_start;
  fresh.width = controls.width;
  fresh.height = controls.height;
  fresh.divider = controls.divider;
  fresh.show_panel = controls.show_panel;
  controls = fresh;
}

void Session::take_window_size(double pane_width, double pane_height) {
  if (pane_width < 1 || pane_height < 1) return;
  const auto size = within(pane_width, pane_height, static_cast<double>(controls.width) / controls.height);
  controls.width = size[0];
  controls.height = size[1];
}

std::string Session::notice() const {
  const std::lock_guard<std::mutex> held(parts_->notice_lock);
  return std::chrono::steady_clock::now() < parts_->notice_until ? parts_->notice : "";
}

void Session::Parts::tell(std::string text) {
  constexpr std::chrono::seconds shown_for{5};
  const std::lock_guard<std::mutex> held(notice_lock);
  notice = std::move(text);
  notice_until = std::chrono::steady_clock::now() + shown_for;
}

void Session::tell(std::string notice) { parts_->tell(std::move(notice)); }

}  // namespace nicol::preview
