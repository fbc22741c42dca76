// What the panes show of their pictures. Pictures are developed on threads of their own: large ones, and differences, take longer than
// an answer to the mouse may.
#include <algorithm>
#include <cmath>

#include "host/preview/session_parts.hpp"

namespace nicol::preview {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds patience{12};   // of the window's thread

bool same_view(const View& a, const View& b) { return a.quantity == b.quantity && a.wavelength == b.wavelength; }

// Not held: something is being written to the picture for longer than the window waits.
std::unique_lock<std::mutex> hold_soon(std::mutex& lock) {
  std::unique_lock<std::mutex> held(lock, std::try_to_lock);
  for (const auto end = Clock::now() + patience; !held && Clock::now() < end;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (held.try_lock()) break;
  }
  return held;
}

}  // namespace

bool Session::Parts::ToShow::same_kind(const ToShow& o) const { return of == o.of && other == o.other && same_view(view, o.view); }

// On its own thread.
void Session::Parts::make_shown(std::size_t pane, const ToShow& what) {
  Shown shown{what, 0, 0, {}, {}, Clock::now()};
  try {
    if (what.other) {
      const std::scoped_lock both(what.of->picture_lock(), what.other->picture_lock());
      shown.picture = what.of->picture().version;
      shown.other = what.other->picture().version;
      shown.difference = preview::difference(what.other->picture(), what.of->picture(), what.view);
      shown.developed = std::move(shown.difference.developed);
    } else {
      const std::lock_guard<std::mutex> held(what.of->picture_lock());
      shown.picture = what.of->picture().version;
      if (what.of->picture().step > 0) shown.developed = develop(what.of->picture(), what.view);
    }
  } catch (const std::exception& error) {
    tell(error.what());
  }
  {
    const std::lock_guard<std::mutex> held(show_lock);
    showing[pane].next = std::move(shown);
    showing[pane].in_work = false;
  }
  shown_news.notify_all();
  ++pieces;
  wake();
}

void Session::Parts::take_next(Showing& own) {
  if (!own.next) return;
  Shown next = std::move(*own.next);
  own.next.reset();
  // Of a picture just sized anew the earlier one stays.
  if (next.developed.rgb.empty() && !next.what.other) next.developed = std::move(own.now.developed);
  else ++own.version;
  own.now = std::move(next);
}

bool Session::Parts::show(std::size_t pane, const ToShow& what) {
  Showing& own = showing[pane];
  std::unique_lock<std::mutex> held(show_lock);
  take_next(own);
  const auto is_latest = [&] {
    return own.now.what.same_kind(what) && own.now.picture == what.of->picture_version_now() &&
           (!what.other || own.now.other == what.other->picture_version_now());
  };
  if (own.in_work) return false;
  if (is_latest()) return true;
  // Differences take a while: not at each step of a picture that still gets finer.
  constexpr std::chrono::milliseconds pause{300};
  const bool finer = what.other && own.now.what.same_kind(what) && (what.of->urgency() != Pane::nothing || what.other->urgency() != Pane::nothing);
  if (finer && Clock::now() - own.now.at < pause) return false;
  own.in_work = true;
  shower[pane].post([this, pane, what] { make_shown(pane, what); });
  shown_news.wait_for(held, patience, [&] { return !own.in_work; });
  take_next(own);
  return !own.in_work && is_latest();
}

bool Session::shows_latest() const {
  Parts& p = *parts_;
  const auto panes = p.panes();
  bool latest = true;
  for (std::size_t pane = 0; pane < 2; ++pane) {
    const bool difference = pane == 1 && controls.show_difference && compares();
    const auto& of = panes[std::min(pane, panes.size() - 1)];
    latest &= p.show(pane, {of, difference ? panes[0] : nullptr, shown_view(difference ? 0 : static_cast<int>(pane))});
  }
  return latest;
}

const Developed& Session::developed(int pane) const {
  shows_latest();
  return parts_->showing[static_cast<std::size_t>(pane)].now.developed;
}

std::uint64_t Session::developed_version(int pane) const { return parts_->showing[static_cast<std::size_t>(pane)].version; }

double Session::display_factor(int pane) const {
  double factor = developed(pane).exposed ? status(pane).exposure * std::exp2(controls.exposure_stops) : 1;
  if (pane == 1 && difference() && difference()->comparable) factor *= controls.amplification;
  return factor;
}

void Session::finish_showing() const {
  while (!shows_latest()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

const Difference* Session::difference() const {
  if (!controls.show_difference || !compares()) return nullptr;
  shows_latest();
  const auto& shown = parts_->showing[1].now;
  return shown.what.other ? &shown.difference : nullptr;
}

std::vector<Ellipse> Session::ellipses(int pane, int spacing) const {
  const auto panes = parts_->panes();
  const auto& of = panes[std::min(static_cast<std::size_t>(pane), panes.size() - 1)];
  const View view = shown_view(pane);
  Parts::Ellipses& kept = parts_->ellipses[static_cast<std::size_t>(pane)];
  const auto held = hold_soon(of->picture_lock());
  if (!held) return kept.found;
  const std::uint64_t version = of->picture().version;
  const bool same = kept.of.lock() == of && kept.picture == version && same_view(kept.view, view) && kept.spacing == spacing;
  if (!same) kept = {of, version, view, spacing, preview::ellipses(of->picture(), view, spacing)};
  return kept.found;
}

std::optional<PixelInfo> Session::pixel(int pane, int x, int y) const {
  const auto panes = parts_->panes();
  const auto& of = panes[std::min(static_cast<std::size_t>(pane), panes.size() - 1)];
  Parts::Pixel& kept = parts_->pixels[static_cast<std::size_t>(pane)];
  const auto held = hold_soon(of->picture_lock());
  if (held) kept = {of, pixel_info(of->picture(), shown_view(pane), x, y, std::exp2(controls.exposure_stops))};
  const bool same = kept.of.lock() == of && kept.info && kept.info->x == x && kept.info->y == y;
  return same ? kept.info : std::nullopt;
}

}  // namespace nicol::preview
