// What is shown, saved to files.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "host/output/atomic_file.hpp"
#include "host/preview/session_parts.hpp"

namespace nicol::preview {
namespace {

// In the working directory; what was saved before stays: scene-preview.png, scene-preview-2.png, ...
std::string free_name(const std::string& scene, const std::string& what, const std::string& suffix) {
  const std::string start = std::filesystem::path(scene).stem().string() + "-" + what;
  std::error_code failed;
  for (int number = 1;; ++number) {
    const std::string name = start + (number > 1 ? "-" + std::to_string(number) : "") + suffix;
    if (!std::filesystem::exists(name, failed)) return name;
  }
}

// The picture as it stands; pixels not traced yet are those that they show.
Frame whole_frame(const Picture& picture) {
  Frame frame = picture.frame;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t p = static_cast<std::size_t>(y) * frame.width + static_cast<std::size_t>(x);
      const std::int64_t from = shown_pixel(picture, x, y);
      if (from < 0 || static_cast<std::size_t>(from) == p) continue;
      for (std::size_t w = 0; w < frame.lambda_nm.size(); ++w)
        for (int s = 0; s < 4; ++s) frame.component(s, w)[p] = frame.component(s, w)[from];
      frame.cut_off[p] = frame.cut_off[static_cast<std::size_t>(from)];
    }
  std::fill(frame.row_done.begin(), frame.row_done.end(), static_cast<unsigned char>(1));
  return frame;
}

std::vector<std::pair<std::string, std::string>> notes(const PaneStatus& status) {
  std::string without;
  for (const std::string& name : status.without) without += (without.empty() ? "" : " ") + name;
  std::ostringstream sampling;
  if (status.step > 1) sampling << "blocks of " << status.step << " pixels";
  else sampling << status.samples << " samples a pixel";
  return {{"scene", status.title}, {"made", "nicol preview"}, {"device", status.device + ", " + status.real}, {"sampling", sampling.str()},
          {"without", without.empty() ? "nothing left out" : without}};
}

// A line that says what became of it.
template <class Make>
std::string save(const std::string& path, Make frame) {
  try {
    const Frame& whole = frame();
    make_sink(path)->write(whole);
    return "saved " + path;
  } catch (const std::bad_alloc&) {
    return "the memory does not suffice to save " + path;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

void Session::save_picture(int pane) {
  finish_showing();
  const Developed& shown = developed(pane);
  const bool differs = pane == 1 && difference();
  if (shown.rgb.empty()) return tell("there is no picture yet");
  Frame frame;
  frame.width = shown.width;
  frame.height = shown.height;
  frame.rgb = shown.rgb;
  frame.cut_off.resize(frame.plane());
  frame.row_done.assign(static_cast<std::size_t>(frame.height), 1);
  const auto factor = static_cast<float>(display_factor(pane));
  for (float& value : frame.rgb) value *= factor;
  frame.how = notes(status(pane));
  frame.how.emplace_back("shown", differs ? "difference" : name_of(shown_view(pane).quantity));
  Parts& p = *parts_;
  p.saver.post([&p, pane, frame = std::move(frame)] {
    p.tell(save(free_name(p.options.left.title, pane == 1 ? "preview-right" : "preview", ".png"), [&]() -> const Frame& { return frame; }));
    p.wake();
  });
}

void Session::save_spectra(int pane) {
  Parts& p = *parts_;
  const auto panes = p.panes();
  const auto from = panes[std::min(static_cast<std::size_t>(pane), panes.size() - 1)];
  const auto how = notes(status(pane));
  const double stops = std::exp2(controls.exposure_stops);
  p.saver.post([&p, pane, from, how, stops] {
    const std::string name = free_name(p.options.left.title, pane == 1 ? "preview-right" : "preview", ".exr");
    p.tell(save(name, [&] {
      Frame frame = from->with_picture([](const Picture& picture) { return picture.step > 0 ? whole_frame(picture) : Frame{}; });
      if (frame.stokes.empty()) throw std::runtime_error("there is no picture yet");
      frame.how = how;
      frame.exposure *= stops;
      return frame;
    }));
    p.wake();
  });
}

std::string Session::camera_sdl() const {
  const auto prepared = parts_->panes().front()->prepared();
  return prepared ? camera_text(prepared->scene) : "";
}

void Session::save_camera() {
  const std::string text = camera_sdl(), path = free_name(parts_->options.left.title, "camera", ".inc");
  if (text.empty()) return tell("there is no camera yet");
  try {
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
    tell("saved " + path);
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

}  // namespace nicol::preview
