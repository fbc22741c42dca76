// The session's working thread, and the one that writes down what a pixel's light met.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/preview/session_parts.hpp"

namespace nicol::preview {

namespace {

// Binaries are kept when there is nothing else to do: it takes a second in which no picture can be traced.
SessionOptions with_kernels_kept_later(SessionOptions options) {
  options.left.kernel.save_later = true;
  if (options.right) options.right->kernel.save_later = true;
  return options;
}

}  // namespace

Session::Parts::Parts(SessionOptions session_options, const Controls& controls, std::function<void()> wake_window)
    : options(with_kernels_kept_later(std::move(session_options))), wake(std::move(wake_window)), at_start(controls),
      builder(
          [this] {
            for (const auto& pane : panes()) pane->kernels_changed();
            notify();
          },
          [this] { notify(); }),
      watch([this] {
        for (const auto& pane : panes()) pane->ask_read();
        notify();
      }) {
  panes_.push_back(std::make_shared<Pane>(options.left, builder, options, quit));
  ask(0, look_of(controls, false));
  worker = std::thread([this] { run(); });
}

Session::Parts::~Parts() {
  quit = true;
  for (const auto& pane : panes()) pane->stop();
  for (const Path& way : path)
    if (way.given_up) *way.given_up = true;
  notify();
  worker.join();
}

std::vector<std::shared_ptr<Pane>> Session::Parts::panes() const {
  const std::lock_guard<std::mutex> held(panes_lock);
  return panes_;
}

void Session::Parts::set_panes(std::vector<std::shared_ptr<Pane>> panes) {
  {
    const std::lock_guard<std::mutex> held(panes_lock);
    panes_ = std::move(panes);
  }
  notify();
}

void Session::Parts::notify() {
  {
    const std::lock_guard<std::mutex> held(panes_lock);
    ++requests;
    resting = false;
  }
  news.notify_all();
}

void Session::Parts::ask(int pane, const Look& look) {
  auto& last = asked[static_cast<std::size_t>(pane)];
  if (last && *last == look) return;
  const bool resized = last && (last->width != look.width || last->height != look.height);
  last = look;
  const auto all = panes();
  all[static_cast<std::size_t>(pane)]->ask(look);
  if (resized) all[static_cast<std::size_t>(pane)]->ask_read();   // the text may go by the picture's size
  for (const auto& other : all) other->yield();
  notify();
}

std::shared_ptr<Pane> Session::Parts::most_urgent() {
  std::shared_ptr<Pane> best;
  int least = Pane::nothing;
  for (const auto& pane : panes()) {
    const int urgency = pane->urgency();
    if (urgency < least || (best && urgency == least && best.get() == had_turn)) {
      least = urgency;
      best = pane;
    }
  }
  return best;
}

void Session::Parts::rest() try {
  for (const auto& pane : panes()) {
    const auto device = pane->device();
    if (!device || !builder.idle()) continue;
    if (pane->prepared()) builder.build_generic(device, pane->kernel());
    if (builder.idle()) save_kernels(*device);
  }
} catch (const std::exception& error) {   // the next start builds them again
  tell(error.what());
}

void Session::Parts::run() {
  for (;;) {
    std::uint64_t seen = 0;
    {
      const std::lock_guard<std::mutex> held(panes_lock);
      seen = requests;
    }
    if (quit) return;
    if (const auto pane = most_urgent()) {
      pane->work();
      had_turn = pane.get();
      ++pieces;
      wake();
      continue;
    }
    if (builder.idle()) rest();
    std::unique_lock<std::mutex> held(panes_lock);
    if (requests != seen || quit) continue;
    resting = builder.idle();
    held.unlock();
    ++pieces;
    wake();
    held.lock();
    news.wait(held, [&] { return requests != seen || quit; });
  }
}

namespace {

std::string place(const Scene& scene, int object) {
  const Object& o = scene.objects[static_cast<std::size_t>(object)];
  return o.kind + ", line " + std::to_string(o.where.line);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

PixelPath in_words(const Prepared& prepared, const PathRecord& record) {
  PixelPath path;
  path.effects = record.effects;
  for (const MetCell& cell : record.cells) {
    std::string text = cell.cell == 0 ? "surroundings" : prepared.scene.media[static_cast<std::size_t>(cell.medium)].name;
    if (cell.object >= 0) text += " (" + place(prepared.scene, cell.object) + ")";
    text += ": " + std::to_string(cell.faces) + (cell.faces == 1 ? " face" : " faces") + ", weight " + number(cell.weight);
    path.cells.push_back(std::move(text));
  }
  std::vector<std::string> ends;
  if (!record.emissions.empty()) ends.push_back(record.emissions.size() == 1 ? "a light" : std::to_string(record.emissions.size()) + " lights");
  if (record.sky) ends.push_back("the sky");
  for (const std::string& end : ends) path.ends += (path.ends.empty() ? "" : ", ") + end;
  if (path.ends.empty()) path.ends = "nothing that shines";
  path.ends += "; " + std::to_string(record.faces) + " faces in all, " + std::to_string(record.deepest) + " deep";
  if (!record.polarizers.empty()) path.ends += "; polarizers passed: " + std::to_string(record.polarizers.size());
  return path;
}

}  // namespace

std::optional<PixelPath> Session::pixel_path(int pane, int x, int y) {
  Parts& p = *parts_;
  const auto panes = p.panes();
  const std::size_t at = std::min(static_cast<std::size_t>(pane), panes.size() - 1);
  const auto prepared = panes[at]->prepared();
  if (!prepared || x < 0 || y < 0 || x >= prepared->width || y >= prepared->height) return std::nullopt;
  const std::size_t middle = prepared->scene.lambda_nm.size() / 2;
  const std::size_t wavelength = std::min(shown_view(pane).wavelength.value_or(middle), prepared->scene.lambda_nm.size() - 1);
  const auto given_up = std::make_shared<std::atomic<bool>>(false);
  {
    const std::lock_guard<std::mutex> held(p.path_lock);
    Parts::Path& path = p.path[at];
    if (path.prepared == prepared && path.x == x && path.y == y && path.wavelength == wavelength) return path.found;
    if (path.given_up) *path.given_up = true;
    path = {prepared, x, y, wavelength, std::nullopt, given_up};
  }
  p.witness[at].post([&p, prepared, x, y, wavelength, at, given_up] {
    PixelPath found;
    try {
      found = in_words(*prepared, record_paths(prepared->scene, prepared->geometry, prepared->features, prepared->width, prepared->height,
                                               x, y, wavelength, given_up.get()));
    } catch (const RecordStopped&) {
      return;
    } catch (const std::exception& error) {
      found.ends = error.what();
    }
    {
      const std::lock_guard<std::mutex> held(p.path_lock);
      Parts::Path& path = p.path[at];
      if (path.given_up == given_up) path.found = found;
    }
    p.wake();
  });
  return std::nullopt;
}

}  // namespace nicol::preview
