// The picture of error against time, as a script for gnuplot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

bool drawable(const Measurement& m) {
  return !m.seconds.empty() && m.error.rms() > 0 && std::isfinite(m.error.rms());
}

std::string logarithmic(double relative) { return relative > 0 ? fmt::format("{:g}", 100 * relative) : "NaN"; }

// Columns: median time, error, fastest, slowest, error of the knob alone.
std::string point(const Measurement& m, double alone) {
  return fmt::format("{:g} {} {:g} {:g} {}\n", m.median(), logarithmic(m.error.rms()), m.fastest(), m.slowest(),
                     logarithmic(alone));
}

// Points of a knob by falling error, the scene's own among them: a line through them tells what turning it does.
std::string points_of(const Sweep& sweep, Knob knob) {
  std::vector<const Measurement*> points;
  for (const Measurement& m : sweep.measurements)
    if ((m.knob == knob || (m.knob == Knob::base && knob != Knob::combined)) && drawable(m)) points.push_back(&m);
  const bool any = std::any_of(points.begin(), points.end(), [&](const Measurement* m) { return m->knob == knob; });
  if (!any) return "";
  const auto at_base = sweep.base_alone.find(knob);
  const auto alone = [&](const Measurement& m) {
    return m.knob != Knob::base ? m.alone : at_base == sweep.base_alone.end() ? NAN : at_base->second;
  };
  std::sort(points.begin(), points.end(), [&](const auto* a, const auto* b) { return alone(*a) > alone(*b); });
  std::string text;
  for (const Measurement* m : points) text += point(*m, alone(*m));
  return text;
}

// One panel's plot command over blocks of data.
class Panel {
 public:
  void add(const std::string& block, const std::string& how, const std::string& title) {
    plots_ += fmt::format("{}${} {} {}", plots_.empty() ? "plot " : ", \\\n  ", block, how,
                          title.empty() ? "notitle" : fmt::format("title '{}'", quoted(title)));
  }
  std::string text() const { return plots_ + "\n"; }

 private:
  std::string plots_;
};

// Upper panel: the picture's error, with legend. Lower: what each knob errs alone.
struct Plot {
  std::string data;
  Panel whole, alone;

  bool add_block(const std::string& name, const std::string& points) {
    if (!points.empty()) data += fmt::format("${} << EOD\n{}EOD\n", name, points);
    return !points.empty();
  }
};

bool errs_alone(const Sweep& sweep, Knob knob) {
  const auto at_base = sweep.base_alone.find(knob);
  return (at_base != sweep.base_alone.end() && at_base->second > 0) ||
         std::any_of(sweep.measurements.begin(), sweep.measurements.end(),
                     [&](const Measurement& m) { return m.knob == knob && m.alone > 0; });
}

// Blocks without a point to draw are left out of a panel: gnuplot 5.4 ends by a fault over some of them.
void add_knob(const Sweep& sweep, const Series& s, Plot& plot) {
  const std::string block = fmt::format("knob{}", static_cast<int>(s.knob));
  if (!plot.add_block(block, points_of(sweep, s.knob))) return;
  const std::string style = s.style, colour = style.substr(style.find("lc rgb"));
  if (s.knob != Knob::combined) plot.whole.add(block, "using 1:2 with lines dt 3 " + colour, "");
  if (s.knob != Knob::combined && errs_alone(sweep, s.knob)) {
    plot.alone.add(block, "using 1:5 with lines dt 3 " + colour, "");
    plot.alone.add(block, "using 1:5:3:4 with xerrorbars " + style, "");
  }
  plot.whole.add(block, "using 1:2:3:4 with xerrorbars " + style, s.title);
}

void add_effects(const Sweep& sweep, Plot& plot) {
  char letter = 'a';
  for (const Measurement& m : sweep.measurements) {
    if (m.knob != Knob::effects || !drawable(m)) continue;
    const std::string block = fmt::format("effect_{}", letter);
    plot.add_block(block, point(m, m.alone));
    const std::string style = fmt::format("with points pt '{}' ps 1.3 lc rgb '#B00020'", letter++);
    plot.whole.add(block, "using 1:2 " + style, "without " + m.setting.without);
    if (m.alone > 0) plot.alone.add(block, "using 1:5 " + style, "");
  }
}

Plot make_plot(const Sweep& sweep) {
  Plot plot;
  std::string front, base;
  for (const std::size_t i : pareto_front(sweep.measurements)) front += point(sweep.measurements[i], NAN);
  for (const Measurement& m : sweep.measurements)
    if (m.knob == Knob::base && drawable(m)) base += point(m, NAN);
  if (plot.add_block("front", front))
    plot.whole.add("front", "using 1:2 with lines lw 5 lc rgb '#D0D0D0'", "Pareto front");
  for (const Series& s : series) add_knob(sweep, s, plot);
  add_effects(sweep, plot);
  if (plot.add_block("base", base))
    plot.whole.add("base", "using 1:2 with points pt 3 ps 2 lw 2 lc rgb '#000000'", "the scene as it is");
  return plot;
}

// The reference's own error as a line, in a range that holds it.
std::string reference_line(const Sweep& sweep) {
  const double own = 100 * sweep.reference.own_error();
  if (!(own > 0)) return "";
  double least = own, most = own;
  for (const Measurement& m : sweep.measurements) {
    if (!drawable(m)) continue;
    least = std::min(least, 100 * m.error.rms());
    most = std::max(most, 100 * m.error.rms());
  }
  return fmt::format(
      "set yrange [{0:g}:{1:g}]\n"
      "set arrow 1 from graph 0, first {2:g} to graph 1, first {2:g} nohead dt 2 lc rgb '#808080'\n"
      "set label 1 'error of the reference' at graph 0.01, first {2:g} offset 0, 0.5 tc rgb '#606060'\n",
      least / 1.5, most * 1.5, own);
}

// Times of all points, so that both panels have the same.
std::string time_range(const Sweep& sweep) {
  double least = HUGE_VAL, most = 0;
  for (const Measurement& m : sweep.measurements) {
    if (!drawable(m)) continue;
    least = std::min(least, m.fastest());
    most = std::max(most, m.slowest());
  }
  return most > 0 ? fmt::format("set xrange [{:g}:{:g}]\n", least / 1.3, most * 1.3) : "";
}

}  // namespace

std::string accuracy_plot(const AccuracyCommand& command, const Sweep& sweep, const std::string& terminal) {
  const Plot plot = make_plot(sweep);
  const bool knobs = plot.alone.text().size() > 1;
  std::string text = fmt::format("set terminal {}\nset encoding utf8\n{}", terminal, plot.data);
  text += "set logscale xy\nset grid xtics ytics lt 1 lc rgb '#E4E4E4'\nset format y '%g'\nset format x '%g'\n";
  text += "set key outside right top Left reverse noenhanced spacing 1.15 width 1\nset lmargin 10\nset rmargin 40\n";
  text += time_range(sweep);
  text += fmt::format("set title '{}, {}x{} pixels, on {}{}' noenhanced\n", quoted(fs::path(command.scene).filename()),
                      command.options.width, command.options.height, quoted(sweep.device),
                      sweep.interrupted ? " (interrupted)" : "");
  const char* const time = "set xlabel 'seconds (median; bars from the fastest to the slowest rendering)'\n";
  text += knobs ? "set multiplot\nset size 1, 0.6\nset origin 0, 0.4\n" : time;
  text += "set ylabel 'RMS error of the picture, %'\n" + reference_line(sweep) + plot.whole.text();
  if (!knobs) return text;
  text += "set size 1, 0.4\nset origin 0, 0\nset key off\nunset arrow\nunset label\nunset title\nset autoscale y\n";
  text += "set ylabel 'error of a knob alone, %'\n";
  return text + time + plot.alone.text() + "unset multiplot\n";
}

}  // namespace nicol::app
