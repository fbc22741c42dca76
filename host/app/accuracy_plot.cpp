// The picture of error against time, as a script for gnuplot.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "host/app/accuracy_report.hpp"

namespace nicol::app {
namespace {

namespace fs = std::filesystem;

// Text inside gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < ' ') continue;
    out += c;
    if (c == '\'') out += c;
  }
  return out;
}

struct Series {
  Knob knob;
  const char* title;
  const char* style;
};

// Colours that stay apart for most eyes: Okabe & Ito 2008.
const Series series[] = {
    {Knob::wavelengths, "step of wavelength", "pt 5 ps 1.1 lc rgb '#0072B2'"},
    {Knob::depth, "depth (max_trace_level)", "pt 9 ps 1.2 lc rgb '#009E73'"},
    {Knob::cut_off, "cut-off (adc_bailout)", "pt 11 ps 1.2 lc rgb '#56B4E9'"},
    {Knob::precision, "precision: the other one", "pt 2 ps 1.4 lw 2 lc rgb '#000000'"},
    {Knob::samples, "samples, alike everywhere", "pt 7 ps 1.1 lc rgb '#D55E00'"},
    {Knob::adaptive, "samples where they matter", "pt 13 ps 1.5 lc rgb '#CC79A7'"},
    {Knob::combined, "combined", "pt 6 ps 1.3 lw 1.5 lc rgb '#7A6A00'"},
};

bool drawable(const Measurement& m) { return !m.seconds.empty() && m.error.rms() > 0 && std::isfinite(m.error.rms()); }

std::string point(const Measurement& m) {
  return fmt::format("{:g} {:g} {:g} {:g}\n", m.median(), 100 * m.error.rms(), m.fastest(), m.slowest());
}

// Points of a knob by rising time, the scene's own among them, so that a line through them tells what turning it does.
std::string points_of(const Sweep& sweep, Knob knob) {
  std::vector<const Measurement*> points;
  for (const Measurement& m : sweep.measurements)
    if ((m.knob == knob || (m.knob == Knob::base && knob != Knob::combined)) && drawable(m)) points.push_back(&m);
  const bool any = std::any_of(points.begin(), points.end(), [&](const Measurement* m) { return m->knob == knob; });
  if (!any) return "";
  std::sort(points.begin(), points.end(), [](const auto* a, const auto* b) { return a->median() < b->median(); });
  std::string text;
  for (const Measurement* m : points) text += point(*m);
  return text;
}

// Data of one series as a block, and what plots it.
class Script {
 public:
  void add(const std::string& points, const std::string& how, const std::string& title) {
    if (points.empty()) return;
    const std::string name = fmt::format("$d{}", ++blocks_);
    data_ += fmt::format("{} << EOD\n{}EOD\n", name, points);
    plots_ += fmt::format("{}{} {} {}", plots_.empty() ? "plot " : ", \\\n  ", name, how,
                          title.empty() ? "notitle" : fmt::format("title '{}'", quoted(title)));
  }
  std::string text() const { return data_ + plots_ + "\n"; }

 private:
  int blocks_ = 0;
  std::string data_, plots_;
};

void add_effects(const Sweep& sweep, Script& script) {
  char letter = 'a';
  for (const Measurement& m : sweep.measurements) {
    if (m.knob != Knob::effects || !drawable(m)) continue;
    const std::string style = "lc rgb '#B00020'";
    script.add(point(m), fmt::format("using 1:2 with points pt '{}' ps 1.3 {}", letter++, style), "without " + m.setting.without);
  }
}

}  // namespace

std::string accuracy_plot(const AccuracyCommand& command, const Sweep& sweep, const std::string& terminal) {
  Script script;
  std::string front;
  for (const std::size_t i : pareto_front(sweep.measurements)) front += point(sweep.measurements[i]);
  script.add(front, "using 1:2 with lines lw 5 lc rgb '#D0D0D0'", "Pareto front");
  for (const Series& s : series) {
    const std::string points = points_of(sweep, s.knob);
    const std::string line = s.knob == Knob::combined ? "" : fmt::format("{} dt 3", s.style);
    if (!line.empty()) script.add(points, "using 1:2 with lines " + line.substr(line.find("lc rgb")), "");
    script.add(points, fmt::format("using 1:2:3:4 with xerrorbars {}", s.style), s.title);
  }
  add_effects(sweep, script);
  std::string base;
  for (const Measurement& m : sweep.measurements)
    if (m.knob == Knob::base && drawable(m)) base += point(m);
  script.add(base, "using 1:2 with points pt 3 ps 2 lw 2 lc rgb '#000000'", "the scene as it is");

  const Reference& reference = sweep.reference;
  std::string text = fmt::format(
      "set terminal {}\nset encoding utf8\nset title '{}, {}x{} pixels, on {}{}' noenhanced\n", terminal, quoted(fs::path(command.scene).filename()),
      command.options.width, command.options.height, quoted(sweep.device), sweep.interrupted ? " (interrupted)" : "");
  text +=
      "set logscale xy\nset grid xtics ytics lt 1 lc rgb '#E4E4E4'\n"
      "set xlabel 'time of the picture in seconds (median, bars from the fastest to the slowest rendering)'\n"
      "set ylabel 'RMS error in % of the mean radiance'\n"
      "set key outside right top Left reverse noenhanced spacing 1.2\nset format y '%g'\nset format x '%g'\n";
  if (reference.own_error() > 0) {
    const double own = 100 * reference.own_error();
    text += fmt::format("set arrow from graph 0, first {:g} to graph 1, first {:g} nohead dt 2 lc rgb '#808080'\n", own, own);
    // The range holds the line too.
    double least = own, most = own;
    for (const Measurement& m : sweep.measurements) {
      if (!drawable(m)) continue;
      least = std::min(least, 100 * m.error.rms());
      most = std::max(most, 100 * m.error.rms());
    }
    text += fmt::format("set yrange [{:g}:{:g}]\n", least / 1.5, most * 1.5);
    text += fmt::format("set label 'error of the reference' at graph 0.01, first {:g} offset 0, 0.5 tc rgb '#606060'\n", own);
  }
  return text + script.text();
}

}  // namespace nicol::app
