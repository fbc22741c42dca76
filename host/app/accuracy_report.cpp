// See accuracy_report.hpp.
#include "host/app/accuracy_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace nicol::app {
namespace {

std::string percent(double relative) { return std::isnan(relative) ? "-" : fmt::format("{:.3g}", 100 * relative); }

// Errors below the reference's own are not told apart from it.
std::string percent_above(double relative, double own_error) {
  return relative < own_error ? "<" + percent(own_error) : percent(relative);
}

std::string seconds_text(double seconds) { return fmt::format("{:.3g}", seconds); }

std::vector<bool> on_front(const Sweep& sweep) {
  std::vector<bool> front(sweep.measurements.size(), false);
  for (const std::size_t i : pareto_front(sweep.measurements)) front[i] = true;
  return front;
}

// What a combined setting is, beside what its knob's row says of the others.
std::string setting_text(const AccuracySetting& s) {
  const double step_nm = equal_step_nm(s.lambda_nm);
  const std::string spectrum =
      step_nm > 0 ? fmt::format("{:.4g} nm", step_nm) : fmt::format("{} lines", s.lambda_nm.size());
  const std::string sampling = s.sample_error > 0 ? fmt::format("to {:g} %", 100 * s.sample_error)
                                                  : fmt::format("{} sample{}", s.samples, s.samples == 1 ? "" : "s");
  return fmt::format("{}, {} faces, {:.2g}, {}, {}{}", spectrum, s.max_trace_level, s.adc_bailout, sampling,
                     s.real_double ? "double" : "float", s.without.empty() ? "" : ", no " + s.without);
}

void append_reference(const Sweep& sweep, std::string& text) {
  const Reference& r = sweep.reference;
  fmt::format_to(std::back_inserter(text),
                 "reference: {}, {} wavelengths, {:.4g} samples a pixel on average; {:.1f} s\n"
                 "its own error: {} % RMS (sampling {} %, spectral step {} %, cut-off {} %); of smaller ones nothing "
                 "is said\n",
                 setting_text(r.setting), r.setting.lambda_nm.size(), r.samples_mean, r.seconds, percent(r.own_error()),
                 percent(r.sampling), percent(r.spectral), percent(r.cut_off));
}

// What the scene's own setting errs by each of its knobs.
void append_base(const Sweep& sweep, std::string& text) {
  std::string parts;
  for (const auto& [knob, error] : sweep.base_alone)
    if (knob != Knob::adaptive)
      parts += fmt::format("{}{} {} %", parts.empty() ? "" : ", ", knob_name(knob), percent(error));
  if (!parts.empty()) fmt::format_to(std::back_inserter(text), "the scene as it is errs by its {}\n", parts);
}

std::size_t text_width(const Sweep& sweep) {
  std::size_t width = 0;
  for (const Measurement& m : sweep.measurements)
    width = std::max(width, m.knob == Knob::combined ? setting_text(m.setting).size() : m.text.size());
  return width;
}

// How much renderings of one setting differ: (slowest - fastest)/median, of the settings' middle and the worst.
void append_noise(const Sweep& sweep, std::string& text) {
  std::vector<double> spread;
  std::size_t most = 0;
  for (const Measurement& m : sweep.measurements) {
    most = std::max(most, m.seconds.size());
    if (m.seconds.size() > 1) spread.push_back((m.slowest() - m.fastest()) / m.median());
  }
  if (spread.empty()) return;
  std::sort(spread.begin(), spread.end());
  fmt::format_to(std::back_inserter(text),
                 "noise of the machine: {} renderings of a setting lie {:.0f} % of their median apart (the worst "
                 "{:.0f} %)\n",
                 most, 100 * spread[spread.size() / 2], 100 * spread.back());
}

void append_choices(const AccuracyCommand& command, const Sweep& sweep, std::string& text) {
  const auto out = std::back_inserter(text);
  const double own = sweep.reference.own_error();
  fmt::format_to(out, "the cheapest settings:\n");
  for (const Target& target : usual_targets()) {
    const auto found = cheapest(sweep.measurements, target, own);
    fmt::format_to(out, "  {}: ", target.text);
    if (found) {
      const Measurement& m = sweep.measurements[*found];
      fmt::format_to(out, "{} s\n    {}\n", seconds_text(m.median()), render_command_text(command, m.setting));
    } else if (target.measure == Target::Measure::rms && target.limit < own) {
      fmt::format_to(out, "the reference itself is only good to {} %: see --reference-error\n", percent(own));
    } else {
      fmt::format_to(out, "none of the settings keeps it\n");
    }
  }
}

}  // namespace

std::string render_command_text(const AccuracyCommand& command, const AccuracySetting& s) {
  const SceneOptions& o = command.options;
  std::string text = fmt::format("nicol render {} -W {} -H {}", command.scene, o.width, o.height);
  const auto out = std::back_inserter(text);
  for (const std::string& folder : o.library_paths) fmt::format_to(out, " -L {}", folder);
  for (const std::string& declare : o.declares) fmt::format_to(out, " -D {}", declare);
  fmt::format_to(out, " --wavelengths {} --max-trace-level {} --adc-bailout {:g} --samples {}",
                 wavelengths_text(s.lambda_nm), s.max_trace_level, s.adc_bailout, s.samples);
  if (s.sample_error > 0) fmt::format_to(out, " --sample-error {:g}%", 100 * s.sample_error);
  if (s.real_double) fmt::format_to(out, " --real double");
  if (s.without == "polarization" || o.polarization == "off") fmt::format_to(out, " --polarization off");
  if (!command.device.device.empty()) fmt::format_to(out, " --device '{}'", command.device.device);
  return text;
}

std::string accuracy_table(const AccuracyCommand& command, const Sweep& sweep) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}, {}x{} pixels, on {}\n", command.scene, command.options.width, command.options.height,
                 sweep.device);
  append_reference(sweep, text);
  const std::size_t width = std::max<std::size_t>(text_width(sweep), 5);
  fmt::format_to(out, "\n{:<11} {:<{}}  {:>8} {:>15}  {:>8} {:>8} {:>8}  {:>6} {:>6} {:>6}\n", "knob", "value", width,
                 "seconds", "least..most", "RMS %", "max %", "alone %", "CIEDE", "95 %", "worst");
  const std::vector<bool> front = on_front(sweep);
  for (std::size_t i = 0; i < sweep.measurements.size(); ++i) {
    const Measurement& m = sweep.measurements[i];
    const std::string value = m.knob == Knob::combined ? setting_text(m.setting) : m.text;
    fmt::format_to(out, "{:<11} {:<{}}  {:>8} {:>15}  {:>8} {:>8} {:>8}  {:>6.2f} {:>6.2f} {:>6.2f}{}\n",
                   knob_name(m.knob), value, width, seconds_text(m.median()),
                   fmt::format("{}..{}", seconds_text(m.fastest()), seconds_text(m.slowest())),
                   percent_above(m.error.rms(), sweep.reference.own_error()),
                   percent(std::max(m.error.stokes_max, m.error.xyz_max)), percent(m.alone), m.error.ciede_mean,
                   m.error.ciede_95, m.error.ciede_worst, front[i] ? " *" : "");
  }
  fmt::format_to(out, "alone: what this knob errs, all else alike; * no other setting is faster and better\n");
  append_base(sweep, text);
  append_noise(sweep, text);
  for (const std::string& note : sweep.notes) fmt::format_to(out, "{}\n", note);
  append_choices(command, sweep, text);
  return text;
}

std::string accuracy_csv(const AccuracyCommand& command, const Sweep& sweep) {
  std::string text =
      "knob,value,wavelengths,from_nm,to_nm,max_trace_level,adc_bailout,samples,sample_error,real,without,"
      "rms,stokes_rms,stokes_max,xyz_rms,xyz_max,alone_rms,ciede_mean,ciede_95,ciede_worst,"
      "seconds_median,seconds_min,seconds_max,renderings,samples_mean,pareto,scene,width,height,device\n";
  const auto out = std::back_inserter(text);
  const auto add = [&](const char* knob, const std::string& value, const AccuracySetting& s,
                       const std::string& numbers) {
    fmt::format_to(out, "{},\"{}\",{},{:g},{:g},{},{:g},{},{:g},{},{},{},\"{}\",{},{},\"{}\"\n", knob, value,
                   s.lambda_nm.size(), s.lambda_nm.front(), s.lambda_nm.back(), s.max_trace_level, s.adc_bailout,
                   s.samples, s.sample_error, s.real_double ? "double" : "float", s.without, numbers, command.scene,
                   command.options.width, command.options.height, sweep.device);
  };
  const Reference& r = sweep.reference;
  add("reference", "its own error", r.setting,
      fmt::format("{:g},,,,,,,,,{:g},{:g},{:g},1,{:g},", r.own_error(), r.seconds, r.seconds, r.seconds,
                  r.samples_mean));
  const std::vector<bool> front = on_front(sweep);
  for (std::size_t i = 0; i < sweep.measurements.size(); ++i) {
    const Measurement& m = sweep.measurements[i];
    const PictureError& e = m.error;
    add(knob_name(m.knob), m.knob == Knob::combined ? setting_text(m.setting) : m.text, m.setting,
        fmt::format("{:g},{:g},{:g},{:g},{:g},{},{:g},{:g},{:g},{:g},{:g},{:g},{},{:g},{}", e.rms(), e.stokes_rms,
                    e.stokes_max, e.xyz_rms, e.xyz_max, std::isnan(m.alone) ? "" : fmt::format("{:g}", m.alone),
                    e.ciede_mean, e.ciede_95, e.ciede_worst, m.median(), m.fastest(), m.slowest(), m.seconds.size(),
                    m.samples_mean,
                    front[i] ? 1 : 0));
  }
  return text;
}

}  // namespace nicol::app
