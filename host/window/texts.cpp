// See texts.hpp. Test: tests/window/texts_test.cpp.
#include "host/window/texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nicol::window {
namespace {

using preview::PaneStatus;
using preview::Quantity;

std::string kernel_text(const PaneStatus& status) {
  if (status.waits_for_kernel) return "first kernel in building";
  if (!status.kernel_failure.empty()) return "generic kernel, the specialised one does not build";
  if (status.building) return "generic kernel, specialised one in building";
  return status.specialised ? "specialised kernel" : "generic kernel";
}

std::string doing_text(const PaneStatus& status) {
  if (status.reading) return "reading";
  if (status.working) return fmt::format("tracing {:.0f} %", std::floor(100 * std::clamp(status.fraction, 0.0, 1.0)));
  return status.done ? "done" : "waiting";
}

std::string samples_text(double samples) {
  const bool whole = std::abs(samples - std::round(samples)) < 0.05;
  return fmt::format("{:.{}f} sample{}", samples, whole ? 0 : 1, whole && std::lround(samples) == 1 ? "" : "s");
}

std::string effects_text(const PaneStatus& status) {
  const std::size_t all = status.effects.size(), out = status.without.size();
  return out == 0 ? fmt::format("all {} effects", all) : fmt::format("{} of {} effects", all - std::min(all, out), all);
}

}  // namespace

std::string short_number(double value) {
  const double size = std::abs(value);
  if (value == 0) return "0";
  if (!std::isfinite(value) || size < 1e-4 || size >= 1e5) return fmt::format("{:.2e}", value);
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return fmt::format("{:.{}f}", value, std::clamp(3 - before, 0, 6));
}

std::string progress_text(const PaneStatus& status) {
  if (status.step == 0) return "-";
  if (status.step > 1) return fmt::format("block {0}x{0}", status.step);
  return samples_text(std::max(1.0, status.samples));
}

std::string status_text(const PaneStatus& status, bool with_device) {
  std::vector<std::string> parts;
  parts.push_back(doing_text(status));
  parts.push_back(progress_text(status));
  if (status.passes > 0) parts.push_back(fmt::format("{} pass{}", status.passes, status.passes == 1 ? "" : "es"));
  if (status.passes > 0 && !std::isnan(status.sample_error))
    parts.push_back(fmt::format("error {} %", short_number(100 * status.sample_error)));
  if (status.segments_per_second > 0)
    parts.push_back(fmt::format("{:.1f} M segments/s", status.segments_per_second / 1e6));
  if (!status.effects.empty()) parts.push_back(effects_text(status));
  parts.push_back(kernel_text(status));
  if (with_device && !status.device.empty()) parts.push_back(status.device + ", " + status.real);
  if (status.counted_errors > 0) parts.insert(parts.begin(), fmt::format("{} ERRORS COUNTED", status.counted_errors));
  return fmt::format("{}", fmt::join(parts, "  |  "));
}

std::string quantity_label(Quantity quantity) {
  switch (quantity) {
    case Quantity::colour: return "colour";
    case Quantity::degree: return "degree of polarization";
    case Quantity::angle: return "angle of polarization";
    case Quantity::ellipticity: return "ellipticity";
    case Quantity::ellipses: return "polarization ellipses";
    case Quantity::s1: return "S1/S0";
    case Quantity::s2: return "S2/S0";
    case Quantity::s3: return "S3/S0";
  }
  return "";
}

std::string pane_title(const PaneStatus& status, const preview::View& view, const std::string& kind) {
  // Without its folders: there is little room.
  const std::size_t folders = status.title.rfind('/', status.title.find(' '));
  std::vector<std::string> parts{folders == std::string::npos ? status.title : status.title.substr(folders + 1)};
  if (!kind.empty()) parts.push_back(kind);
  parts.push_back(quantity_label(view.quantity));
  if (view.wavelength && *view.wavelength < status.lambda_nm.size())
    parts.push_back(fmt::format("{} nm", short_number(status.lambda_nm[*view.wavelength])));
  if (!status.without.empty()) parts.push_back(fmt::format("without {}", fmt::join(status.without, ", ")));
  if (status.step > 0) parts.push_back(progress_text(status));
  return fmt::format("{}", fmt::join(parts, "  |  "));
}

ShownLine shown_line(const std::string& line, int column) {
  constexpr std::size_t tab = 4;
  ShownLine shown;
  int width = 0;   // in characters: a byte 10xxxxxx goes on with one
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (column > 0 && i == std::min(static_cast<std::size_t>(column) - 1, line.size())) shown.caret = width;
    if (i == line.size()) break;
    const auto c = static_cast<unsigned char>(line[i]);
    const std::size_t blanks = tab - static_cast<std::size_t>(width) % tab;
    if (c == '\t') shown.text.append(blanks, ' ');
    else if (c != '\r' && c != '\n') shown.text += line[i];
    if (c == '\t') width += static_cast<int>(blanks);
    else if ((c & 0xC0) != 0x80) ++width;
  }
  return shown;
}

std::string place_text(const preview::Message& message) {
  if (message.file.empty() || message.line <= 0) return message.file;
  if (message.column <= 0) return fmt::format("{}:{}", message.file, message.line);
  return fmt::format("{}:{}:{}", message.file, message.line, message.column);
}

std::vector<double> ticks(double low, double high, int most) {
  std::vector<double> places;
  if (!(high > low) || most < 1 || !std::isfinite(high - low)) return places;
  const double least = (high - low) / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= least) step = factor * power;
  const auto first = std::llround(std::ceil(low / step - 1e-9)), last = std::llround(std::floor(high / step + 1e-9));
  for (auto i = first; i <= last; ++i) places.push_back(static_cast<double>(i) * step);
  return places;
}

}  // namespace nicol::window
