// See render_summary.hpp.
#include "host/engine/render_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace nicol::engine {
namespace {

std::string build_text(const BuildReport& build) {
  return fmt::format("kernel {} in {:.2f} s", build.cached ? "from the cache" : "built",
                     build.seconds);
}

double segments_per_second(const RenderReport& report) {
  return report.seconds > 0 ? static_cast<double>(report.segments) / report.seconds : 0;
}

std::string counters_text(const RenderReport& report) {
  std::string text = fmt::format("not a number {}, energy {}, stack {}, Stokes {}", report.nan_count,
                                 report.energy_count, report.stack_count, report.stokes_count);
  if (report.fallback_count > 0) text += fmt::format(", precise wave solver {} (in {})", report.fallback_count,
                                                        report.precise_real);
  return text;
}

// What each of several devices did; "": there was one.
std::string shares_text(const RenderReport& report) {
  if (report.shares.size() < 2) return "";
  std::string text;
  for (const DeviceShare& share : report.shares) {
    const double part = report.segments > 0 ? 100.0 * static_cast<double>(share.segments) / static_cast<double>(report.segments) : 0;
    text += fmt::format("{}{}{}: {} tiles, {:.0f} %", text.empty() ? "" : "; ", share.place.empty() ? "" : share.place + ", ",
                        share.device.empty() ? "not ready in time" : share.device, share.tiles, part);
  }
  return text;
}

}  // namespace

const char* version() { return NICOL_VERSION; }

std::string samples_text(double mean) {
  const std::string number = mean >= 100 || mean == std::round(mean) ? fmt::format("{:.0f}", mean) : fmt::format("{:.3g}", mean);
  return number + (number == "1" ? " sample a pixel" : " samples a pixel");
}

std::string summary_text(const Frame& frame, const RenderReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}x{} pixels, {} wavelength{} {:g} to {:g} nm, {}{}\n",
                 frame.width, frame.height, frame.lambda_nm.size(), frame.lambda_nm.size() == 1 ? "" : "s",
                 frame.lambda_nm.front(), frame.lambda_nm.back(), samples_text(report.samples_mean),
                 report.passes > 1 ? fmt::format(" on average, in {} passes", report.passes) : "");
  fmt::format_to(out, "{:.2f} s, {:.1f} M segments/s on {}, {} lane{} of {}; {}\n", report.seconds,
                 segments_per_second(report) / 1e6, report.device, report.lanes,
                 report.lanes == 1 ? "" : "s", report.real, build_text(report.build));
  if (report.shares.size() > 1) fmt::format_to(out, "shared: {}\n", shares_text(report));
  if (!report.sample_error_kept)
    fmt::format_to(out, "the sampling error {:.2g} % is more than what was to be kept\n", 100 * report.sample_error);
  fmt::format_to(out, "weight cut off: mean {:.2g}, worst pixel {:.2g}\n", report.cut_off_mean,
                 report.cut_off_worst);
  fmt::format_to(out, "counted on the device: {}\n", counters_text(report));
  return text;
}

std::vector<std::string> counter_warnings(const RenderReport& report) {
  std::vector<std::string> lines;
  const auto warn = [&](std::uint64_t count, const char* meaning) {
    if (count > 0) lines.push_back(fmt::format("{} times {}", count, meaning));
  };
  warn(report.nan_count, "a path's light was not a number; it was left out");
  warn(report.energy_count, "a face gave out more light than it got");
  warn(report.stack_count,
       "a path had more branches than the stack holds; they were counted as cut off");
  warn(report.stokes_count, "a pixel was polarized by more than 100 %");
  return lines;
}

std::vector<std::pair<std::string, std::string>> how_made(const LoadedScene& loaded,
                                                          const PictureOptions& command,
                                                          const RenderReport& report) {
  const Settings& settings = loaded.scene.settings;
  const FrameClock& clock = command.options.clock;
  std::vector<std::pair<std::string, std::string>> notes{
          {"scene", command.scene},
          {"command", command.command_line},
          {"version", fmt::format("nicol {}", version())},
          {"settings",
           fmt::format(
               "samples {}, max_trace_level {}, adc_bailout {:g}, exposure {:g}, polarization {}, "
               "coherence {}",
               settings.samples, settings.max_trace_level, settings.adc_bailout, settings.exposure,
               settings.polarization ? "on" : "off", settings.coherence ? "on" : "off")},
          {"features", fmt::format("{:#x}", loaded.features.mask)},
          {"device", fmt::format("{}, {} lanes of {}", report.device, report.lanes, report.real)},
          {"time", fmt::format("{:.3f} s, {:.3g} segments/s; {}", report.seconds,
                               segments_per_second(report), build_text(report.build))},
          {"cutOff",
           fmt::format("mean {:.3g}, worst {:.3g}", report.cut_off_mean, report.cut_off_worst)},
          {"counters", counters_text(report)}};
  if (report.shares.size() > 1 && !report.interrupted) notes.emplace_back("shared", shares_text(report));
  if (clock.final_frame > 0)
    notes.emplace_back("frame", fmt::format("{} of {} to {}, clock {:g}", clock.frame_number, clock.initial_frame, clock.final_frame,
                                            clock.clock));
  return notes;
}

}  // namespace nicol::engine
