// The picture's colours, and the choice of a sink by the suffix of the file.
#include "host/output/frame.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <mutex>

#include "host/optics/colour.hpp"
#include "host/output/atomic_file.hpp"
#include "host/output/sinks.hpp"

namespace nicol {

namespace {

std::mutex makers_guard;
std::map<std::string, SinkMaker>& further_makers() {
  static auto* makers = new std::map<std::string, SinkMaker>;
  return *makers;
}

SinkMaker maker_for(const std::string& suffix) {
  const std::lock_guard lock(makers_guard);
  const auto found = further_makers().find(suffix);
  return found == further_makers().end() ? SinkMaker() : found->second;
}

}  // namespace

void add_sink_maker(const std::string& suffix, SinkMaker make) {
  const std::lock_guard lock(makers_guard);
  further_makers()[suffix] = std::move(make);
}

std::unique_ptr<FrameSink> make_sink(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const SinkMaker further = maker_for(suffix);
  if (suffix != ".exr" && suffix != ".png" && !further)
    cannot_write(path, (suffix.empty() ? "its name has no suffix" : "unknown suffix " + suffix) +
                           " (.exr and .png are known)");
  AtomicFile trial(path);  // goes away again: it only shows that the folder takes files
  if (further) return further(path);
  return suffix == ".exr" ? make_exr_sink(path) : make_png_sink(path);
}

std::vector<float> linear_rgb(const Frame& frame) {
  if (!frame.rgb.empty()) return frame.rgb;
  std::vector<std::array<double, 3>> weights;
  for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i) {
    auto xyz = colour_matching(frame.lambda_nm[i]);
    for (double& component : xyz) component *= frame.weight_nm[i] * frame.exposure;
    weights.push_back(linear_srgb(xyz));
  }
  const auto width = static_cast<std::size_t>(frame.width);
  std::vector<float> rgb(3 * frame.plane());
  std::vector<double> row(3 * width);
  for (std::size_t start = 0; start < frame.plane(); start += width) {
    std::fill(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const float* radiance = frame.component(0, i) + start;
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t k = 0; k < 3; ++k)
          row[3 * x + k] += weights[i][k] * static_cast<double>(radiance[x]);
    }
    std::transform(row.begin(), row.end(), rgb.begin() + static_cast<std::ptrdiff_t>(3 * start),
                   [](double value) { return static_cast<float>(value); });
  }
  return rgb;
}

std::size_t clipped_pixels(const Frame& frame) {
  const double half_step = 0.5 / 255;
  const double least = -half_step / 12.92,
               most = 1 + half_step * 2.4 / 1.055;  // slopes of sRGB at 0 and 1
  const auto rgb = linear_rgb(frame);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const auto fits = [&](float value) { return value >= least && value <= most; };
    if (!(fits(rgb[i]) && fits(rgb[i + 1]) && fits(rgb[i + 2]))) ++count;
  }
  return count;
}

std::vector<std::pair<std::string, std::string>> notes_of(const Frame& frame) {
  auto notes = frame.how;
  const auto done =
      std::count_if(frame.row_done.begin(), frame.row_done.end(), [](auto d) { return d != 0; });
  if (!frame.row_done.empty() && done < frame.height)
    notes.emplace_back("partial",
                       std::to_string(done) + " of " + std::to_string(frame.height) + " rows");
  return notes;
}

void check_frame(const Frame& frame, const std::string& path) {
  if (frame.width <= 0 || frame.height <= 0) cannot_write(path, "the picture has no pixels");
  if (frame.lambda_nm.empty() && frame.rgb.empty()) cannot_write(path, "the picture has no wavelengths");
  const bool fits = frame.weight_nm.size() == frame.lambda_nm.size() &&
                    frame.stokes.size() == 4 * frame.lambda_nm.size() * frame.plane() &&
                    (frame.rgb.empty() || frame.rgb.size() == 3 * frame.plane()) &&
                    (frame.sample_error.empty() || frame.sample_error.size() == frame.plane()) &&
                    std::all_of(frame.planes.begin(), frame.planes.end(),
                                [&](const auto& named) { return named.second.size() == frame.plane(); }) &&
                    (frame.cut_off.empty() || frame.cut_off.size() == frame.plane());
  if (!fits) cannot_write(path, "the arrays of the picture do not fit its size");
}

}  // namespace nicol
