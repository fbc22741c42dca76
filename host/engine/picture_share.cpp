// See picture_share.hpp.
#include "host/engine/picture_share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "host/opencl/gather.hpp"

namespace nicol::engine {
namespace {

// All of the text, or nothing.
template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool has_window(const WindowOptions& window) {
  return window.start_row || window.end_row || window.start_column || window.end_column || window.rows || window.columns;
}

PixelRange in_picture(PixelRange range, int count, const std::string& what) {
  if (range.first >= 0 && range.first <= range.last && range.last < count) return range;
  throw UsageError(fmt::format("{}s {}..{} are not in the picture (0 to {})", what, range.first, range.last, count - 1));
}

PixelRange rows_of(const WindowOptions& window, int height) {
  return window.rows ? in_picture(*window.rows, height, "row") : pixel_range(window.start_row, window.end_row, height, "row");
}

PixelRange columns_of(const WindowOptions& window, int width) {
  return window.columns ? in_picture(*window.columns, width, "column") : pixel_range(window.start_column, window.end_column, width, "column");
}

bool is_png(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  return suffix == ".png" || suffix == ".PNG";
}

[[noreturn]] void refuse(const PictureShare& share, const std::string& what, const std::string& why) {
  throw UsageError(fmt::format("{} does not go with a part of a picture ({}): {}", what, share.name, why));
}

// What needs a whole picture, and why.
void refuse_with_part(const PictureOptions& command, const std::vector<std::string>& outputs, const Scene& scene, const PictureShare& share) {
  const bool from_scene = !command.options.error && !command.options.sample_error;
  if (scene.settings.error > 0)
    refuse(share, from_scene ? "the scene's `error`" : "an error to be kept", "the settings that keep it are picked, and its samples placed, by the whole picture");
  if (scene.settings.sample_error > 0)
    refuse(share, from_scene ? "the scene's `sample_error`" : "a sample error to be kept",
           "where further samples go is decided by the whole picture; 'samples' gives every pixel as many");
  if (command.wants_error_bound()) refuse(share, "an error bound", "it holds each pixel against its neighbours");
  for (const std::string& path : outputs) check_output(share, path);
}

bool leaves_out_nothing(PixelRange range, int count) { return range.first == 0 && range.last == count - 1; }

std::string range_text(const char* what, PixelRange range) { return fmt::format("{} {}..{}", what, range.first + 1, range.last + 1); }

void choose_pixels(const PictureOptions& command, PictureShare& share, std::vector<std::string>& names) {
  const int width = command.options.width, height = command.options.height;
  if (!command.part.empty()) {
    const auto [i, n] = parse_share(command.part);
    share.pixels = dealt_pixels(width, height, i, n);
    if (share.pixels.empty())
      throw UsageError(fmt::format("part {}: the picture has fewer runs of {} pixels than that", command.part, deal_run));
    names.push_back("share " + command.part);
  }
  if (!has_window(command.window)) return;
  const PixelRange rows = rows_of(command.window, height), columns = columns_of(command.window, width);
  if (leaves_out_nothing(rows, height) && leaves_out_nothing(columns, width)) return;
  share.window_only = command.part.empty();
  const auto outside = [&](std::int32_t p) {
    const int x = p % width, y = p / width;
    return x < columns.first || x > columns.last || y < rows.first || y > rows.last;
  };
  if (command.part.empty()) {
    for (int y = rows.first; y <= rows.last; ++y)
      for (int x = columns.first; x <= columns.last; ++x)
        share.pixels.push_back(static_cast<std::int32_t>(static_cast<std::int64_t>(y) * width + x));
  } else {
    share.pixels.erase(std::remove_if(share.pixels.begin(), share.pixels.end(), outside), share.pixels.end());
    if (share.pixels.empty()) throw UsageError(fmt::format("part {} of the picture has nothing in this window", command.part));
  }
  names.push_back(range_text("rows", rows) + ", " + range_text("columns", columns));
}

void choose_wavelengths(const PictureOptions& command, const Scene& scene, PictureShare& share, std::vector<std::string>& names) {
  if (command.wavelength_part.empty()) return;
  const auto [from_nm, to_nm] = parse_wavelength_part(command.wavelength_part);
  const auto first = std::lower_bound(scene.lambda_nm.begin(), scene.lambda_nm.end(), from_nm);
  const auto last = std::upper_bound(scene.lambda_nm.begin(), scene.lambda_nm.end(), to_nm);
  if (first >= last)
    throw UsageError(fmt::format("none of the scene's {} wavelengths ({:g} to {:g} nm) lies in {:g}..{:g}", scene.lambda_nm.size(),
                                 scene.lambda_nm.front(), scene.lambda_nm.back(), from_nm, to_nm));
  if (first == scene.lambda_nm.begin() && last == scene.lambda_nm.end()) return;
  share.wavelengths = {static_cast<std::size_t>(first - scene.lambda_nm.begin()), static_cast<std::size_t>(last - first)};
  names.push_back(fmt::format("{:g}..{:g} nm", *first, *(last - 1)));
}

}  // namespace

std::array<int, 2> parse_share(const std::string& text) {
  const std::size_t slash = text.find('/');
  int i = 0, n = 0;
  constexpr int most = 1'000'000;
  const bool good = slash != std::string::npos && read_number(std::string_view(text).substr(0, slash), i) &&
                    read_number(std::string_view(text).substr(slash + 1), n) && i >= 1 && i <= n && n <= most;
  if (!good) throw UsageError(fmt::format("a part is told as i/n with 1 <= i <= n, as in 2/3, not '{}'", text));
  return {i, n};
}

std::array<double, 2> parse_wavelength_part(const std::string& text) {
  const std::size_t dots = text.find("..");
  double from_nm = 0, to_nm = 0;
  const bool good = dots != std::string::npos && read_number(std::string_view(text).substr(0, dots), from_nm) &&
                    read_number(std::string_view(text).substr(dots + 2), to_nm) && from_nm <= to_nm;
  if (!good) throw UsageError(fmt::format("a part of the wavelengths is told as A..B in nm (450..550), not '{}'", text));
  return {from_nm, to_nm};
}

PixelRange pixel_range(std::optional<double> start, std::optional<double> end, int count, const std::string& what) {
  for (const auto& value : {start, end})
    if (value && (!(*value >= 0) || *value > count))
      throw UsageError(fmt::format("{} {:g} is not in the picture (1 to {}, or 0 to 1 as a part of it)", what, *value, count));
  const auto floored = [](double value) { return static_cast<int>(std::floor(value)); };
  PixelRange range{0, count - 1};
  if (start) range.first = *start >= 1 ? floored(*start) - 1 : floored(*start * count);
  if (end) range.last = floored(*end > 1 ? *end : *end * count) - 1;
  if (range.last < range.first)
    throw UsageError(fmt::format("from {} {} to {} there is nothing to render", what, range.first + 1, range.last + 1));
  return range;
}

void check_output(const PictureShare& share, const std::string& path) {
  if (share.whole() || share.window_only || !is_png(path)) return;
  refuse(share, path, "only .exr tells what is there and what it belongs to; `nicol merge` writes .png of all parts");
}

PictureShare choose_share(const PictureOptions& command, const std::vector<std::string>& outputs, const Scene& scene) {
  PictureShare share;
  std::vector<std::string> names;
  choose_pixels(command, share, names);
  choose_wavelengths(command, scene, share, names);
  share.name = fmt::format("{}", fmt::join(names, ", "));
  share.window_only = share.window_only && names.size() == 1;
  if (!share.whole()) refuse_with_part(command, outputs, scene, share);
  return share;
}

PictureShare whole_lanes(const PictureShare& share, const PackedScene& whole, std::size_t wavelengths, int lanes) {
  PictureShare wide = share;
  if ((whole.features & lanes_over_pixels_bit()) != 0) {
    const std::int64_t plane = static_cast<std::int64_t>(whole.width) * whole.height;
    wide.pixels.clear();
    std::int64_t end = 0;  // of the lanes taken so far
    for (const std::int32_t p : share.pixels) {
      if (p < end) continue;
      end = std::min(plane, (p / lanes + 1) * std::int64_t{lanes});
      for (std::int64_t q = p / lanes * std::int64_t{lanes}; q < end; ++q) wide.pixels.push_back(static_cast<std::int32_t>(q));
    }
  } else if (whole.mixing.empty() && share.wavelengths.count > 0) {
    const auto step = static_cast<std::size_t>(lanes);
    const std::size_t end = share.wavelengths.first + share.wavelengths.count;
    wide.wavelengths.first = share.wavelengths.first / step * step;
    wide.wavelengths.count = std::min(wavelengths, (end + step - 1) / step * step) - wide.wavelengths.first;
  }
  return wide;
}

WholePicture whole_picture(const LoadedScene& loaded, const PictureOptions& command) {
  const Scene& scene = loaded.scene;
  const Settings& settings = scene.settings;
  WholePicture whole;
  whole.width = command.options.width;
  whole.height = command.options.height;
  whole.lambda_nm = scene.lambda_nm;
  whole.weight_nm = scene.weight_nm;
  whole.exposure = settings.exposure;
  const PackedScene packed = pack(scene, loaded.geometry, loaded.features.mask, whole.width, whole.height, 1);
  whole.shared_channels = !packed.mixing.empty();
  whole.settings = {{"version", version()},
                    {"kernels", kernels_hash()},
                    {"scene", scene_hash(packed, scene.lambda_nm)},
                    {"samples", fmt::format("{}", settings.samples)},
                    {"precision", command.device.real},
                    {"max_trace_level", fmt::format("{}", settings.max_trace_level)},
                    {"adc_bailout", fmt::format("{:.17g}", settings.adc_bailout)},
                    {"polarization", settings.polarization ? "on" : "off"},
                    {"coherence", settings.coherence ? "on" : "off"}};
  if (settings.error > 0) whole.settings["error"] = fmt::format("{:.17g}", settings.error);
  if (settings.sample_error > 0) whole.settings["sample_error"] = fmt::format("{:.17g}", settings.sample_error);
  return whole;
}

}  // namespace nicol::engine
